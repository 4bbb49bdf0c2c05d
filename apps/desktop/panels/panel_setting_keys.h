#pragma once

namespace felt::desktop::panel_keys {

/// A list of recently used colours, the newest first, each as "#rrggbb" or "#rrggbbaa".
inline constexpr const char* kRecentColors = "panels/recent_colors";
/// A list of the colours in the user's own palette, in the same form.
inline constexpr const char* kOwnColors = "panels/own_colors";
/// Paths of the .gpl files that the user opened.
inline constexpr const char* kPaletteFiles = "panels/palette_files";
/// Title of the shown palette. If that palette no longer exists, the pencil box is shown.
inline constexpr const char* kPalette = "panels/palette";
/// True if the tactile check is for an embosser instead of swell paper.
inline constexpr const char* kTactileEmbossed = "panels/tactile_embossed";

}  // namespace felt::desktop::panel_keys
