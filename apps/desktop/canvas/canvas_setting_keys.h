#pragma once

#include "desktop/engine/grain_setting.h"

/// The canvas's settings (engine/settings.h), with their defaults.
namespace felt::desktop::canvas_keys {

/// Show the nib held back by the forces, as a visual substitute for feeling them.
inline constexpr auto kPseudoHaptics = "canvas/pseudo_haptics";
inline constexpr bool kPseudoHapticsDefault = true;

/// Show direction and strength of the force as an arrow at the nib.
inline constexpr auto kForceArrow = "canvas/force_arrow";
inline constexpr bool kForceArrowDefault = true;

/// Show the relief of the surface in dry ink. Pictures can show it; outlines in files cannot.
inline constexpr auto kGrain = kShowsGrain;
inline constexpr bool kGrainDefault = kShowsGrainDefault;

}  // namespace felt::desktop::canvas_keys
