#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/recolor/recolor_options.h"
#include "felt/tools/scene.h"

namespace felt {

/// Factor on the pencil's friction and grain. It is small because the tool leaves no ink.
inline constexpr double kRecolorGlide = 0.4;

/// Returns the force model: only the surface, more slippery than under a pencil. It is the same
/// before and during the gesture.
inline ForceModel make_recolor_force(const RecolorSettings& settings, const Scene& scene) {
  const double glide = kRecolorGlide * settings.strength;
  const Medium& pencil = medium_of(scene, "pencil");
  ForceModel model(make_surface_force(scene.surface, scaled_medium(pencil, glide, glide),
                                      scene.device, surface_grain(scene.surface)));
  model.set_fade_id(
      FeelId("recolor").with_surface(scene.surface, pencil).with(settings.strength).value());
  return model;
}

}  // namespace felt
