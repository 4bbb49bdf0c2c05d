#include "felt/io/xml/material_texts.h"

#include <algorithm>

#include "felt/io/limits.h"
#include "felt/io/xml/xml_text.h"

namespace felt {

bool is_material_text(std::string_view text) {
  std::string as_xml;
  return !text.empty() && text.size() <= limits::kMaxMaterialTextBytes &&
         append_xml_attribute(as_xml, text).has_value();
}

bool add_material_text(std::vector<std::string>& texts, std::string_view text) {
  if (!is_material_text(text)) return false;
  if (std::find(texts.begin(), texts.end(), text) != texts.end()) return true;
  if (texts.size() >= limits::kMaxMaterialTexts) return false;
  texts.emplace_back(text);
  return true;
}

}  // namespace felt
