#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/scene.h"

namespace felt {

/// Returns the force model of the eraser: the surface under the medium "eraser". It has 2.4 times
/// the friction of a pencil but the same friction law (R41), so a pen at rest does not creep (R42).
/// The model is the same in every mode, while hovering and in contact.
inline ForceModel make_eraser_force(const EraserSettings& settings, const Scene& scene) {
  const Medium material =
      scaled_medium(medium_of(scene, "eraser"), settings.strength, settings.strength);
  ForceModel model(
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface)));
  model.set_fade_id(FeelId("eraser")
                        .with_surface(scene.surface, medium_of(scene, "eraser"))
                        .with(settings.strength)
                        .value());
  return model;
}

}  // namespace felt
