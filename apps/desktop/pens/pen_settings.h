#pragma once

#include <QString>
#include <array>
#include <cstdint>

#include "desktop/pens/button_role.h"
#include "desktop/pens/pressure_curve.h"
#include "felt/devices/simulated/pointer_hand.h"

namespace felt::desktop {

/// The action of one finger on the canvas.
enum class TouchMode : std::uint8_t { kPan, kDraw, kOff };

/// The settings of pens, in a form that is quick to read for every event. Call load() again after
/// a setting of pens/ has changed. A value type.
struct PenSettings {
  bool pressure_on = true;
  PressureCurve curve;
  MousePressure mouse = MousePressure::kConstant;
  ButtonRole lower = ButtonRole::kEraser;
  ButtonRole upper = ButtonRole::kPan;
  ButtonRole right = ButtonRole::kEraser;
  TouchMode touch = TouchMode::kPan;
  bool touch_taps = false;  ///< two fingers undo, three redo
  bool long_press = false;  ///< a press that rests opens the ring (LongPress)

  static PenSettings load();
};

/// Returns the mode's name in the settings: "pan", "draw", "off".
QString name_of(TouchMode mode);

}  // namespace felt::desktop
