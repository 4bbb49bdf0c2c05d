#pragma once

#include <vector>

#include "felt/io/gpl_palette.h"

namespace felt::desktop {

/// Returns the colours of a setting of panel_setting_keys.h. Skips texts that are not colours.
std::vector<NamedColor> stored_colors(const char* key);
/// Stores the colours without their names.
void store_colors(const char* key, const std::vector<NamedColor>& colors);

}  // namespace felt::desktop
