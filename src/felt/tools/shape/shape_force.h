#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/scene.h"
#include "felt/tools/shape/shape_options.h"

namespace felt {

/// Returns the force model: the surface under the medium of new ink. It is the same before and
/// during the gesture.
inline ForceModel make_shape_force(const ShapeSettings& settings, const Scene& scene) {
  const Medium& medium = medium_of(scene, scene.medium);
  ForceModel model(make_surface_force(scene.surface,
                                      scaled_medium(medium, settings.strength, settings.strength),
                                      scene.device, surface_grain(scene.surface)));
  model.set_fade_id(
      FeelId("shape").with_surface(scene.surface, medium).with(settings.strength).value());
  return model;
}

}  // namespace felt
