#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "felt/haptics/bricks/band_damping.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/bricks/push_clicks.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/stabiliser.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/guided_feel.h"
#include "felt/tools/medium_line.h"
#include "felt/tools/pencil/pencil_options.h"
#include "felt/tools/pencil/shape_hold.h"
#include "felt/tools/pencil/width_steps.h"
#include "felt/tools/pressing.h"
#include "felt/tools/scene.h"

namespace felt {

/// The inertia of the stabiliser, rendered with only the fraction `share` of its force. The nib
/// moves as with the full force, so that the line does not depend on the option `strength`.
class ScaledInertia {
 public:
  ScaledInertia(const InertiaOptions& options, double share) noexcept
      : inertia_(options), share_(share) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
    const double scale = memory.scale.lateral;
    memory.scale.lateral = share_ * scale;
    const Force force = inertia_(sample, memory);
    memory.scale.lateral = scale;
    return force;
  }
  [[nodiscard]] Slopes slopes() const noexcept {
    return {.lateral_n_per_m = share_ * inertia_.slopes().lateral_n_per_m};
  }

 private:
  Inertia inertia_;
  double share_;
};

/// Returns the share of those forces that the option `strength` reduces only below 0.5: grain, the
/// friction of slippery media and the attraction. They cost little accuracy, and with half of their
/// force they could not be felt (docs/materials.md).
inline double weak_share(double strength) noexcept {
  return std::min(1.0, 2.0 * strength);
}

/// Returns the medium as the option `strength` changes it: its friction in proportion, but not
/// below that of a brush pen, and its grain by weak_share().
inline Medium felt_medium(const Medium& medium, double strength) {
  constexpr double kSlippery = 0.11;
  Medium felt = scaled_medium(medium, strength, weak_share(strength));
  felt.kept_friction = kSlippery * weak_share(strength);
  return felt;
}

enum class PenPace : std::uint8_t { kPasses, kRests };

/// Returns the attraction of a target. It draws a pen that rests beside the target with the option
/// `attraction_n` beyond what the device rubs, so that it moves the hand, and a pen that may only
/// pass with half of the option: with all of it, a soft hand that writes was drawn to the ends of
/// other letters (`./dev bench feel --snapping`).
inline WellShape attraction_of(const PencilSettings& settings, const Scene& scene,
                               PenPace pace) noexcept {
  constexpr double kSlopeNPerMm = 0.3, kPassingShare = 0.5;
  SnapOptions snap = settings.snap;
  if (pace == PenPace::kPasses) {
    snap.force_n *= kPassingShare;
  } else if (snap.force_n > 0.0) {
    snap.force_n += finite_positive(scene.device.friction_n);
  }
  const double strength = weak_share(settings.strength);
  const WellShape shape = well_of(snap, strength, kSlopeNPerMm);
  return scene.law == LawForm::kPaper ? shape.printed(strength) : shape;
}

/// Returns the clicks between the steps of the width, or none if the option is off or the device
/// does not press by depth.
inline PushClicks width_clicks(const PencilSettings& settings, const Scene& scene) {
  PushClicks clicks;
  const Pressing pressing(scene.surface, scene.device);
  if (!settings.width_steps || !pressing.is_felt()) return clicks;
  const Medium& medium = medium_of(scene, settings.medium);
  const std::size_t steps = WidthSteps(drawn_with(medium, settings.ink).width_map).size();
  for (std::size_t i = 1; i < steps; ++i) {
    clicks.add(pressing.depth_mm_at(static_cast<double>(i) / static_cast<double>(steps)));
  }
  return clicks;
}

/// Returns the force model of a pencil: the surface (plane, grain, friction between medium and
/// surface), the attracting target, if any, or the hold of a resting pen (ShapeHold), the guide, if
/// any, the stabiliser, and the damping of the steady hand. All but the attraction is the same
/// above and on the surface, so that it does not change at the touch; each part detects by itself
/// whether the pen is down.
inline ForceModel make_pencil_force(const PencilSettings& settings, const Scene& scene,
                                    const std::optional<SnapTarget>& target,
                                    const std::optional<Point>& held_at = {},
                                    PenPace pace = PenPace::kPasses) {
  Medium material = felt_medium(medium_of(scene, settings.medium), settings.strength);
  if (scene.guide.softens_friction) material = guided_medium(std::move(material));
  const SurfaceForce surface =
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface));

  const WellShape shape = attraction_of(settings, scene, pace);
  const PushClicks clicks = width_clicks(settings, scene);
  SnapWells well = target ? SnapWells(target->point, shape) : SnapWells();
  if (held_at) well = SnapWells(*held_at, hold_shape(settings.strength));

  FeelId id("pencil");
  id.with_surface(scene.surface, medium_of(scene, settings.medium)).with(settings.strength);
  id.with_law(scene.law);
  if (held_at) {
    id.with("hold").with(held_at->x).with(held_at->y);
  } else if (target) {
    id.with(target->tip.stroke.value).with(static_cast<std::uint64_t>(target->tip.tip));
    id.with(target->point.x).with(target->point.y).with(shape.radius_mm).with(shape.force_n);
  }
  if (clicks.size() > 0) id.with("clicks").with(std::uint64_t{clicks.size()});
  if (scene.guide.force) id.with("guide").with(std::uint64_t{scene.guide.number});
  if (scene.guide.softens_friction) id.with("softer");
  const auto model_of = [&](const auto&... others) {
    if (!scene.guide.force) return ForceModel(Compose(surface, clicks, well, others...));
    return ForceModel(Compose(surface, clicks, well, *scene.guide.force, others...));
  };
  BandDampingOptions band;
  if (settings.steady) {
    band = band_damping_for(settings.steady->hz, scene.device);
    band.damping_n_s_per_m *= settings.strength;
    id.with("steady").with(band.hz);
  }
  const auto model_with = [&](const auto&... stabiliser) {
    return settings.steady ? model_of(stabiliser..., BandDamping(band)) : model_of(stabiliser...);
  };
  ForceModel model;
  switch (settings.stabiliser.kind) {
    case StabiliserKind::kOff:
      model = model_with();
      break;
    case StabiliserKind::kInertia:
      id.with("inertia").with(settings.stabiliser.mass_g);
      model = model_with(ScaledInertia(inertia_of(settings.stabiliser), settings.strength));
      break;
    case StabiliserKind::kTowed: {
      TowOptions tow = tow_of(settings.stabiliser);
      id.with("towed").with(tow.rope_mm);
      tow.law.gain *= settings.strength;
      tow.damping_n_s_per_m *= settings.strength;
      model = model_with(Towed(tow));
      break;
    }
  }
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
