#include "desktop/pens/pen_settings.h"

#include "desktop/engine/settings.h"
#include "desktop/pens/pen_setting_keys.h"

namespace felt::desktop {
namespace {

QString text(const char* key, const char* fallback) {
  return Settings::the().text(QString::fromLatin1(key), QString::fromLatin1(fallback));
}

TouchMode touch_mode(const QString& name) {
  for (const TouchMode mode : {TouchMode::kDraw, TouchMode::kOff}) {
    if (name == name_of(mode)) return mode;
  }
  return TouchMode::kPan;
}

}  // namespace

QString name_of(TouchMode mode) {
  switch (mode) {
    case TouchMode::kDraw:
      return QStringLiteral("draw");
    case TouchMode::kOff:
      return QStringLiteral("off");
    case TouchMode::kPan:
      break;
  }
  return QStringLiteral("pan");
}

PenSettings PenSettings::load() {
  using namespace pen_keys;
  PenSettings settings;
  settings.pressure_on = Settings::the().flag(QString::fromLatin1(kPressureOn), kPressureOnDefault);
  settings.curve = PressureCurve::load();
  settings.mouse = text(kMousePressure, kMousePressureDefault) == QStringLiteral("speed")
                       ? MousePressure::kBySpeed
                       : MousePressure::kConstant;
  settings.lower = button_role(text(kLowerButton, kLowerButtonDefault));
  settings.upper = button_role(text(kUpperButton, kUpperButtonDefault));
  settings.right = button_role(text(kRightButton, kRightButtonDefault));
  settings.touch = touch_mode(text(kTouch, kTouchDefault));
  settings.touch_taps = Settings::the().flag(QString::fromLatin1(kTouchTaps), kTouchTapsDefault);
  settings.long_press = Settings::the().flag(QString::fromLatin1(kLongPress), kLongPressDefault);
  return settings;
}

}  // namespace felt::desktop
