#pragma once

namespace felt::desktop::panel_keys {

/// Recently used colours, the newest first: "#rrggbb" or "#rrggbbaa" each.
inline constexpr const char* kRecentColors = "panels/recent_colors";
/// The user's own colours, in the same form.
inline constexpr const char* kOwnColors = "panels/own_colors";
/// Paths of the .gpl files that the user opened.
inline constexpr const char* kPaletteFiles = "panels/palette_files";
/// Title of the shown palette. If that palette no longer exists, the pencil box is shown.
inline constexpr const char* kPalette = "panels/palette";

}  // namespace felt::desktop::panel_keys
