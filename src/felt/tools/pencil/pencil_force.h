#pragma once

#include <optional>
#include <utility>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/stabiliser.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/guided_feel.h"
#include "felt/tools/pencil/pencil_options.h"
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

/// Returns the force model of a pencil: the surface (plane, grain, friction between medium and
/// surface), the attracting target, if any, the guide, if any, and the stabiliser. The model is the
/// same above and on the surface, so that it does not change at the touch; each part detects by
/// itself whether the pen is down.
inline ForceModel make_pencil_force(const PencilSettings& settings, const Scene& scene,
                                    const std::optional<SnapTarget>& target) {
  Medium material =
      scaled_medium(medium_of(scene, settings.medium), settings.strength, settings.strength);
  if (scene.guide.is_of_drawing) material = guided_medium(std::move(material));
  const SurfaceForce surface =
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface));

  const WellShape shape = well_of(settings.snap, settings.strength);
  const SnapWells well = target ? SnapWells(target->point, shape) : SnapWells();

  FeelId id("pencil");
  id.with_surface(scene.surface, medium_of(scene, settings.medium)).with(settings.strength);
  if (target) {
    id.with(target->tip.stroke.value).with(static_cast<std::uint64_t>(target->tip.tip));
    id.with(target->point.x).with(target->point.y).with(shape.radius_mm).with(shape.force_n);
  }
  if (scene.guide.force) id.with("guide").with(std::uint64_t{scene.guide.number});
  const auto model_with = [&](const auto&... stabiliser) {
    if (!scene.guide.force) return ForceModel(Compose(surface, well, stabiliser...));
    return ForceModel(Compose(surface, well, *scene.guide.force, stabiliser...));
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
