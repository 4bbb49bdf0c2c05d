#pragma once

namespace felt::desktop::feel_keys {

/// Master strength of all forces, 0..1.
inline constexpr auto kStrength = "feel/strength";
inline constexpr double kStrengthDefault = 1.0;
/// Largest force that the user wants to feel, in N; the upper limit is 3.
inline constexpr auto kForceLimit = "feel/force_limit_n";
inline constexpr double kForceLimitDefault = 3.0;
/// Id of the surface.
inline constexpr auto kMaterial = "feel/material";
/// True if the sound of the pen on the surface is on.
inline constexpr auto kSound = "feel/sound";
inline constexpr bool kSoundDefault = false;
/// Volume, 0..1.
inline constexpr auto kSoundVolume = "feel/sound_volume";
inline constexpr double kSoundVolumeDefault = 0.7;
/// True if the edge of the page, or of the box of the selection, is felt as a ridge. Off at first.
inline constexpr auto kPageEdge = "feel/page_edge";
inline constexpr auto kSelectionEdge = "feel/selection_edge";
/// True if the contours of pictures in locked layers are felt as grooves.
inline constexpr auto kContours = "feel/contours";
inline constexpr bool kContoursDefault = true;

}  // namespace felt::desktop::feel_keys
