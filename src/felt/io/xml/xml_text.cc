#include "felt/io/xml/xml_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "felt/base/utf8.h"
#include "felt/document/visible_strokes.h"

namespace felt {
namespace {

/// Returns true if the character is a Char of XML 1.0.
bool allowed_in_xml(std::uint32_t code) noexcept {
  return code == 0x9 || code == 0xa || code == 0xd ||
         (code >= 0x20 && code != 0xfffe && code != 0xffff);
}

std::string hex_code(std::uint32_t code) {
  std::array<char, 8> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), code, 16).ptr;
  return "U+" + std::string(digits.data(), end);
}

}  // namespace

Result<void> append_xml_attribute(std::string& out, std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::string_view rest = text;
    std::uint32_t code = 0;
    if (!next_code_point(text, code)) {
      return fail(ErrorCode::kInvalidData, "text that is not UTF-8 cannot be written as XML");
    }
    if (!allowed_in_xml(code)) {
      return fail(ErrorCode::kInvalidData, "XML cannot contain the character " + hex_code(code));
    }
    switch (code) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      // Parsers would turn these characters into spaces if they were not escaped.
      case '\t':
        escaped += "&#9;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      case '\r':
        escaped += "&#13;";
        break;
      default:
        escaped.append(rest.substr(0, rest.size() - text.size()));
    }
  }
  out += escaped;
  return {};
}

std::string xml_stroke_name(const Drawing& drawing, StrokeId id) {
  std::string name = name_in_file(drawing, id), attribute;
  return append_xml_attribute(attribute, name) ? name : stroke_name(id);
}

namespace {

/// Returns true if DrawingBuilder would give other ids to the strokes of a file that has only their
/// names.
bool need_numbers(const Drawing& drawing) {
  if (!drawing.names || drawing.names->empty()) return false;
  // As in DrawingBuilder: names give ids, and the other strokes get ids above the largest of them.
  std::vector<std::pair<StrokeId, StrokeId>>
      ids;  // of each stroke, and the one that its name gives
  std::uint64_t last = 0;
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) {
      ids.emplace_back(id, stroke_id_of_name(xml_stroke_name(drawing, id)));
      last = std::max(last, ids.back().second.value);
    }
    for (const FillId id : layer.fills) last = std::max(last, id.value);
  }
  std::set<StrokeId> taken;
  return std::any_of(ids.begin(), ids.end(), [&](const auto& both) {
    const auto& [id, named] = both;
    const bool gets_it = named.value > 0 && taken.insert(named).second;
    return id != (gets_it ? named : StrokeId{++last});
  });
}

}  // namespace

XmlStrokeNames::XmlStrokeNames(const Drawing& drawing)
    : drawing_(drawing), has_numbers_(need_numbers(drawing)) {}

XmlStrokeNames::Names XmlStrokeNames::of(StrokeId id) const {
  Names names{xml_stroke_name(drawing_, id), ""};
  if (has_numbers_ && names.name != stroke_name(id)) names.number = stroke_name(id);
  return names;
}

}  // namespace felt
