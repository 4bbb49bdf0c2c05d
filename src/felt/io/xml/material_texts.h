#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace felt {

/// Returns true if a drawing may carry `text` as the text of a material: 1 to
/// limits::kMaxMaterialTextBytes bytes of UTF-8 that XML can hold. Does not check its meaning.
bool is_material_text(std::string_view text);

/// Adds a text unless it is already there. Returns false if it is not a material text, or if there
/// are limits::kMaxMaterialTexts already.
bool add_material_text(std::vector<std::string>& texts, std::string_view text);

}  // namespace felt
