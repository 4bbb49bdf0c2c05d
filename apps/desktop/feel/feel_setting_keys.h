#pragma once

namespace felt::desktop::feel_keys {

/// Master strength of all forces, 0..1.
inline constexpr auto kStrength = "feel/strength";
inline constexpr double kStrengthDefault = 1.0;
/// The most that a person wants to feel, N; 3 is the most that there is.
inline constexpr auto kForceLimit = "feel/force_limit_n";
inline constexpr double kForceLimitDefault = 3.0;
/// Id of the sheet's material.
inline constexpr auto kMaterial = "feel/material";
/// The rubbing of the pen is heard.
inline constexpr auto kSound = "feel/sound";
inline constexpr bool kSoundDefault = false;
/// How loud, 0..1.
inline constexpr auto kSoundVolume = "feel/sound_volume";
inline constexpr double kSoundVolumeDefault = 0.7;

}  // namespace felt::desktop::feel_keys
