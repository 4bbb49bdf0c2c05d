#pragma once

#include "desktop/engine/grain_setting.h"

/// The canvas's settings (engine/settings.h), with their defaults.
namespace felt::desktop::canvas_keys {

/// True if forces hold the shown nib back, as a visual substitute for feeling them.
inline constexpr auto kPseudoHaptics = "canvas/pseudo_haptics";
inline constexpr bool kPseudoHapticsDefault = true;

/// True if an arrow at the nib shows direction and strength of the force.
inline constexpr auto kForceArrow = "canvas/force_arrow";
inline constexpr bool kForceArrowDefault = true;

/// True if dry ink shows the relief of the surface. Pictures can show it; outlines in files
/// cannot.
inline constexpr auto kGrain = kShowsGrain;
inline constexpr bool kGrainDefault = kShowsGrainDefault;

}  // namespace felt::desktop::canvas_keys
