#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/tether.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/scene.h"
#include "felt/tools/transform/transform_drag.h"

namespace felt {

/// The tether of a stretch: a scale tether for each axis, with the pen projected onto the axis. For
/// x, the sum S of tether.h is sum |x_i - c| |ln s_x|, with x_i the anchors, c the centre and s_x
/// the factor; for y, the sum is defined in the same way. If both axes act, each has 1/sqrt 2 of
/// the force, so that together they stay within 1 N and the stiffness limit Kcap (tether.h). If the
/// pen has crossed the centre along an axis, that axis exerts no force, because its factor is
/// constant there.
class StretchTether {
 public:
  StretchTether() noexcept = default;
  StretchTether(TransformKind kind, Point centre, Point grab, std::span<const Point> anchors,
                ForceLaw law, double min_scale) noexcept
      : centre_(centre), grab_(grab) {
    double sum_x = 0.0, sum_y = 0.0;
    for (const Point p : anchors) {
      sum_x += std::fabs(p.x - centre.x);
      sum_y += std::fabs(p.y - centre.y);
    }
    const bool x = stretches_x(kind, centre, grab), y = stretches_y(kind, centre, grab);
    if (x && y) law.gain /= std::numbers::sqrt2;
    if (x)
      x_ = Tether::scale(centre, {grab.x, centre.y}, sum_x).with_law(law).with_min_scale(min_scale);
    if (y)
      y_ = Tether::scale(centre, {centre.x, grab.y}, sum_y).with_law(law).with_min_scale(min_scale);
  }

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    PenSample on_x = sample, on_y = sample;
    on_x.position.x = centre_.x + forward(grab_.x - centre_.x, sample.position.x - centre_.x);
    on_x.position.y = centre_.y;
    on_x.velocity.y = 0.0;
    on_y.position.x = centre_.x;
    on_y.position.y = centre_.y + forward(grab_.y - centre_.y, sample.position.y - centre_.y);
    on_y.velocity.x = 0.0;
    const Force x = x_(on_x, memory);
    return x + y_(on_y, memory);
  }
  [[nodiscard]] Slopes slopes() const noexcept {
    const Slopes x = x_.slopes(), y = y_.slopes();  // perpendicular to each other
    return x.lateral_n_per_m > y.lateral_n_per_m ? x : y;
  }

 private:
  /// Returns the coordinate of the pen relative to the centre if the pen is on the same side as the
  /// grab, else 0.
  [[nodiscard]] static double forward(double grab, double pen) noexcept {
    const double side = std::copysign(1.0, grab);
    return side * std::fmax(0.0, side * pen);
  }

  Tether x_, y_;
  Point centre_{}, grab_{};
};

/// Factor on the pencil's friction and grain. It is small because the tool leaves no ink.
inline constexpr double kTransformGlide = 0.4;

/// The tethers that hold a selection while it is transformed (R35-R38). Without anchors no tether
/// acts.
struct TransformHold {
  TransformKind kind = TransformKind::kMove;
  Point centre, grab;  ///< `centre` is the point that stays in place
  std::span<const Point> anchors;
  std::uint32_t gesture = 0;
  bool constrained = false;  ///< moves along one axis, or turns in steps (Tether::constrained)
  double min_scale = TransformDrag::kMinScale;
};

/// Returns the force model of the transform tool: the surface with little friction and, while the
/// pen holds a selection (`hold` is not null), the tethers of the selection. The form kPaper of the
/// law does not constrain, and the paper does not stretch.
inline ForceModel make_transform_force(const Scene& scene, double strength,
                                       const TransformHold* hold) {
  const Medium material = scaled_medium(medium_of(scene, "pencil"), kTransformGlide * strength,
                                        kTransformGlide * strength);
  const SurfaceForce surface =
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface));
  FeelId id("transform");
  id.with_surface(scene.surface, medium_of(scene, "pencil")).with(strength);
  if (!hold || hold->anchors.empty()) {
    ForceModel model(surface);
    model.set_fade_id(id.value());
    return model;
  }
  ForceLaw law = kTransformLaw;
  law.gain *= strength;
  double radii = 0.0;
  Vec anchors_from_grab{};
  for (const Point p : hold->anchors) {
    radii += distance(p, hold->centre);
    anchors_from_grab += p - hold->grab;
  }
  id.with(static_cast<std::uint64_t>(hold->kind)).with(std::uint64_t{hold->gesture});
  id.with(std::uint64_t{hold->constrained ? 1U : 0U});
  id.with(hold->centre.x).with(hold->centre.y);
  id.with_law(scene.law);
  const Point middle =
      hold->grab + (1.0 / static_cast<double>(hold->anchors.size())) * anchors_from_grab;
  const auto with_tether = [&](const Tether& tether) {
    const Tether held = tether.with_law(law).with_min_scale(hold->min_scale);
    if (scene.law == LawForm::kPaper) return ForceModel(Compose(surface, held.printed(middle)));
    return ForceModel(Compose(surface, hold->constrained ? held.constrained() : held));
  };
  ForceModel model;
  switch (hold->kind) {
    case TransformKind::kMove: {
      const auto count = static_cast<int>(std::min<std::size_t>(hold->anchors.size(), 1'000'000));
      model = with_tether(Tether::translation(hold->grab, count));
      break;
    }
    case TransformKind::kRotate:
      model = with_tether(Tether::rotation(hold->centre, hold->grab, radii, hold->gesture));
      break;
    case TransformKind::kScale:
      model = with_tether(Tether::scale(hold->centre, hold->grab, radii));
      break;
    case TransformKind::kStretch:
    case TransformKind::kStretchX:
    case TransformKind::kStretchY:
      model = ForceModel(Compose(surface, StretchTether(hold->kind, hold->centre, hold->grab,
                                                        hold->anchors, law, hold->min_scale)));
      break;
  }
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
