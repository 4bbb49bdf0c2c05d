#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/lasso/lasso_options.h"
#include "felt/tools/scene.h"

namespace felt {

/// Factor on the pencil's friction and grain. It is small because the lasso leaves no ink.
inline constexpr double kLassoGlide = 0.4;

/// Returns the force model of the lasso: only the surface, more slippery than under a pencil,
/// because forces must not disturb pointing. It is the same before and during the gesture.
inline ForceModel make_lasso_force(const LassoSettings& settings, const Scene& scene) {
  const Medium material = scaled_medium(medium_of(scene, "pencil"), kLassoGlide * settings.strength,
                                        kLassoGlide * settings.strength);
  ForceModel model(
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface)));
  model.set_fade_id(FeelId("lasso")
                        .with_surface(scene.surface, medium_of(scene, "pencil"))
                        .with(settings.strength)
                        .value());
  return model;
}

}  // namespace felt
