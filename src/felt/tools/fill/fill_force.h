#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/fill/fill_options.h"
#include "felt/tools/guide_track.h"
#include "felt/tools/scene.h"

namespace felt {

/// Factor on the pencil's friction and grain. It is small because the tool leaves no ink.
inline constexpr double kFillGlide = 0.4;

/// Returns the force model: the surface, more slippery than under a pencil, and the ridge at the
/// edge of the area under the pen, if there is one.
inline ForceModel make_fill_force(const FillSettings& settings, const Scene& scene,
                                  const GuideTrack* ridge) {
  const double glide = kFillGlide * settings.strength;
  const Medium& pencil = medium_of(scene, "pencil");
  const SurfaceForce surface =
      make_surface_force(scene.surface, scaled_medium(pencil, glide, glide), scene.device,
                         surface_grain(scene.surface));
  FeelId id("fill");
  id.with_surface(scene.surface, pencil).with(settings.strength);
  if (ridge) id.with("ridge").with(std::uint64_t{ridge->number()});
  ForceModel model = ridge ? ForceModel(Compose(surface, ridge->guide())) : ForceModel(surface);
  model.set_fade_id(id.value());
  return model;
}

}  // namespace felt
