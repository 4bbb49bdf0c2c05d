#pragma once

#include "desktop/engine/grain_setting.h"

/// What the settings keep of the canvas (engine/settings.h), with the defaults.
namespace felt::desktop::canvas_keys {

/// A nib that the forces hold back, shown instead of felt.
inline constexpr auto kPseudoHaptics = "canvas/pseudo_haptics";
inline constexpr bool kPseudoHapticsDefault = true;

/// An arrow at the nib: which way the force goes, and how strong it is.
inline constexpr auto kForceArrow = "canvas/force_arrow";
inline constexpr bool kForceArrowDefault = true;

/// Dry ink shows the relief of the sheet, as pictures can and outlines in files cannot.
inline constexpr auto kGrain = kShowsGrain;
inline constexpr bool kGrainDefault = kShowsGrainDefault;

}  // namespace felt::desktop::canvas_keys
