#pragma once

namespace felt::desktop::panel_keys {

/// Recently used colours, the newest first: "#rrggbb" or "#rrggbbaa" each.
inline constexpr const char* kRecentColors = "panels/recent_colors";
/// The user's own colours, in the same form.
inline constexpr const char* kOwnColors = "panels/own_colors";
/// Paths of the .gpl files that were opened.
inline constexpr const char* kPaletteFiles = "panels/palette_files";
/// Title of the shown palette; the pencil box if it no longer exists.
inline constexpr const char* kPalette = "panels/palette";

}  // namespace felt::desktop::panel_keys
