#pragma once

#include "desktop/engine/grain_setting.h"

/// The canvas's settings (engine/settings.h), with their defaults.
namespace felt::desktop::canvas_keys {

/// True if the drawn nib lags behind the pen in the direction of the force, so that a mouse or
/// tablet user sees the forces (pseudo-haptics).
inline constexpr auto kPseudoHaptics = "canvas/pseudo_haptics";
inline constexpr bool kPseudoHapticsDefault = true;

/// True if an arrow at the nib shows direction and strength of the force.
inline constexpr auto kForceArrow = "canvas/force_arrow";
inline constexpr bool kForceArrowDefault = true;

/// True if dry ink shows the relief of the surface. Exported pictures can show it, but exported
/// outlines cannot.
inline constexpr auto kGrain = kShowsGrain;
inline constexpr bool kGrainDefault = kShowsGrainDefault;

}  // namespace felt::desktop::canvas_keys
