#pragma once

namespace felt::desktop::panel_keys {

/// Colours that were drawn with, the newest first: "#rrggbb" or "#rrggbbaa" each.
inline constexpr const char* kRecentColors = "panels/recent_colors";
/// Colours that a person keeps: the same.
inline constexpr const char* kOwnColors = "panels/own_colors";
/// .gpl files that were opened, by path.
inline constexpr const char* kPaletteFiles = "panels/palette_files";
/// The palette shown, by its title; the pencil box where it is no longer there.
inline constexpr const char* kPalette = "panels/palette";

}  // namespace felt::desktop::panel_keys
