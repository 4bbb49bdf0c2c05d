#pragma once

/// The settings of pens (engine/settings.h), with their defaults.
namespace felt::desktop::pen_keys {

/// True if pressure changes the width of lines. If false, every pen draws with half pressure.
inline constexpr auto kPressureOn = "pens/pressure";
inline constexpr bool kPressureOnDefault = true;
/// The pressure from which on the pen counts as touching, 0..0.5 of the tablet's range.
inline constexpr auto kThreshold = "pens/pressure_threshold";
inline constexpr double kThresholdDefault = 0.0;
/// The two handles of the pressure curve; each coordinate is 0..1.
inline constexpr auto kFirstHandleX = "pens/pressure_curve_x1";
inline constexpr auto kFirstHandleY = "pens/pressure_curve_y1";
inline constexpr auto kSecondHandleX = "pens/pressure_curve_x2";
inline constexpr auto kSecondHandleY = "pens/pressure_curve_y2";
/// How a pen that does not sense pressure gets one: "constant", or "speed" (slower motion gives
/// more pressure).
inline constexpr auto kMousePressure = "pens/mouse_pressure";
inline constexpr auto kMousePressureDefault = "constant";
/// The roles of the buttons (ButtonRole's names): the two on the pen's side, and the mouse's right
/// one.
inline constexpr auto kLowerButton = "pens/lower_button";
inline constexpr auto kLowerButtonDefault = "eraser";
inline constexpr auto kUpperButton = "pens/upper_button";
inline constexpr auto kUpperButtonDefault = "pan";
inline constexpr auto kRightButton = "pens/right_button";
inline constexpr auto kRightButtonDefault = "eraser";
/// Action of one finger: "pan", "draw" or "off" (no touch at all).
inline constexpr auto kTouch = "pens/touch";
inline constexpr auto kTouchDefault = "pan";

}  // namespace felt::desktop::pen_keys
