#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace felt {

/// Returns true if a drawing may contain `text` as the text of a material: 1 to
/// limits::kMaxMaterialTextBytes bytes of UTF-8 that XML can hold. Does not check whether the text
/// describes a material.
bool is_material_text(std::string_view text);

/// Adds a text to `texts` unless `texts` contains it already. Returns false if is_material_text()
/// is false for the text, or if a new text would exceed limits::kMaxMaterialTexts.
bool add_material_text(std::vector<std::string>& texts, std::string_view text);

}  // namespace felt
