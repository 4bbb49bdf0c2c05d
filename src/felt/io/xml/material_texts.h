#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace felt {

/// Whether a drawing may carry this as the text of a material: 1 to limits::kMaxMaterialTextBytes
/// bytes of UTF-8 that XML can hold. What it says is not looked at.
bool is_material_text(std::string_view text);

/// Adds a text that is not there yet. False: it is none, or there are limits::kMaxMaterialTexts.
bool add_material_text(std::vector<std::string>& texts, std::string_view text);

}  // namespace felt
