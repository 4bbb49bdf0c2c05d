#pragma once

/// The settings of pens (engine/settings.h), with their defaults.
namespace felt::desktop::pen_keys {

/// True if the pressure of a tablet pen changes the width of lines. If false, every tablet pen
/// draws with half pressure.
inline constexpr auto kPressureOn = "pens/pressure";
inline constexpr bool kPressureOnDefault = true;
/// The pen counts as touching if its pressure is above this value, 0..0.5 of the tablet's range. If
/// the value is 0, the tablet decides whether the pen touches.
inline constexpr auto kThreshold = "pens/pressure_threshold";
inline constexpr double kThresholdDefault = 0.0;
/// The two handles of the pressure curve; each coordinate is 0..1.
inline constexpr auto kFirstHandleX = "pens/pressure_curve_x1";
inline constexpr auto kFirstHandleY = "pens/pressure_curve_y1";
inline constexpr auto kSecondHandleX = "pens/pressure_curve_x2";
inline constexpr auto kSecondHandleY = "pens/pressure_curve_y2";
/// How the pressure of a mouse, or of a pen that does not sense pressure, is determined:
/// "constant", or "speed" (slower motion gives more pressure).
inline constexpr auto kMousePressure = "pens/mouse_pressure";
inline constexpr auto kMousePressureDefault = "constant";
/// The roles of the two buttons on the side of the pen, and of the right mouse button, by name
/// (ButtonRole).
inline constexpr auto kLowerButton = "pens/lower_button";
inline constexpr auto kLowerButtonDefault = "eraser";
inline constexpr auto kUpperButton = "pens/upper_button";
inline constexpr auto kUpperButtonDefault = "pan";
inline constexpr auto kRightButton = "pens/right_button";
inline constexpr auto kRightButtonDefault = "eraser";
/// Action of one finger: "pan", "draw" or "off" (touch is ignored).
inline constexpr auto kTouch = "pens/touch";
inline constexpr auto kTouchDefault = "pan";
/// A tap with two fingers undoes, one with three fingers redoes.
inline constexpr auto kTouchTaps = "pens/touch_taps";
inline constexpr bool kTouchTapsDefault = false;
/// A pen or finger that rests on the surface after it has touched it opens the ring of tools.
inline constexpr auto kLongPress = "pens/long_press";
inline constexpr bool kLongPressDefault = false;

}  // namespace felt::desktop::pen_keys
