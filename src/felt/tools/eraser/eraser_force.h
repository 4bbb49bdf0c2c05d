#pragma once

#include <cstdint>
#include <utility>

#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/push_clicks.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/eraser/guard_ridge.h"
#include "felt/tools/feel_id.h"
#include "felt/tools/guided_feel.h"
#include "felt/tools/pressing.h"
#include "felt/tools/scene.h"

namespace felt {

/// The pressure from which the option "press_through" erases whole lines. A share of full pressure
/// that a hand does not reach by chance, and still below the force that a device can hold (F1).
inline constexpr double kPressThrough = 0.8;

/// Returns the force model of the eraser: the surface under the medium "eraser". It has 2.4 times
/// the friction of a pencil but the same friction law (R41), so a pen at rest does not creep (R42).
/// The model is the same in every mode, while hovering and in contact. With the option
/// "press_through", the pen clicks where whole lines begin to be erased. `guard` adds the push of a
/// line that was not meant.
inline ForceModel make_eraser_force(const EraserSettings& settings, const Scene& scene,
                                    const GuardRidge& guard = {}) {
  Medium material = scaled_medium(medium_of(scene, "eraser"), settings.strength, settings.strength);
  if (guard.force()) material = guided_medium(std::move(material));
  PushClicks click;
  const Pressing pressing(scene.surface, scene.device);
  if (settings.press_through && pressing.is_felt()) click.add(pressing.depth_mm_at(kPressThrough));
  ForceModel model(Compose(
      make_surface_force(scene.surface, material, scene.device, surface_grain(scene.surface)),
      click));
  const bool is_guarded = guard.force() && model.add(*guard.force());
  model.set_fade_id(FeelId("eraser")
                        .with_surface(scene.surface, medium_of(scene, "eraser"))
                        .with(settings.strength)
                        .with(std::uint64_t{click.size()})
                        .with(std::uint64_t{is_guarded ? guard.number() : 0})
                        .value());
  return model;
}

}  // namespace felt
