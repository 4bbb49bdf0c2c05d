#pragma once

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/scene.h"

namespace felt {

/// What the hand feels with an eraser: the sheet, and rubber on it, which drags 2.4 times as much
/// as a pencil by the same law (R41) and does not creep (R42). The same in every mode, in the air
/// and on the sheet.
inline ForceModel make_eraser_force(const EraserSettings& settings, const Scene& scene) {
  const Medium material =
      felt_with(medium_of(scene, "eraser"), settings.strength, settings.strength);
  ForceModel model(
      make_sheet_force(scene.surface, material, scene.device, surface_grain(scene.surface)));
  model.set_fade_id(FeelId("eraser")
                        .with_sheet(scene.surface, medium_of(scene, "eraser"))
                        .with(settings.strength)
                        .value());
  return model;
}

}  // namespace felt
