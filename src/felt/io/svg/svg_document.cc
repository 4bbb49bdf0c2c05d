#include "felt/io/svg/svg_document.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "felt/base/result.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

/// Returns true if a document type with an internal subset precedes the first element.
bool has_svg_entities(std::string_view text) noexcept;

/// Returns the text with its document type replaced by spaces (line ends are kept), and with the
/// entities that the document type defines as text replaced. Some drawing programs use such
/// entities for their namespaces. Entities inside entities are replaced too. Entities that refer to
/// a file are left as they are and have no effect. Fails if the entities add more than
/// limits::kMaxSvgEntityBytes or are nested too deep, or if the document type has no end.
Result<std::string> svg_with_entities(std::string_view text);

constexpr std::string_view kDoctype = "<!DOCTYPE";

/// Returns the position of the document type; npos if the first element precedes it.
std::size_t find_doctype(std::string_view text) noexcept {
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string_view::npos) {
    const std::string_view rest = text.substr(at);
    if (rest.substr(0, kDoctype.size()) == kDoctype) return at;
    const bool is_comment = rest.substr(0, 4) == "<!--", is_instruction = rest.substr(0, 2) == "<?";
    if (!is_comment && !is_instruction) return std::string_view::npos;
    at = text.find(is_comment ? "-->" : "?>", at + (is_comment ? 4 : 2));
  }
  return at;
}

/// Returns the start of the definitions of the document type, or npos if it has none.
std::size_t find_definitions(std::string_view text, std::size_t doctype) noexcept {
  if (doctype == std::string_view::npos) return doctype;
  char quote = 0;
  for (std::size_t i = doctype; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '[') {
      return i + 1;
    } else if (text[i] == '>') {
      break;
    }
  }
  return std::string_view::npos;
}

/// Reads the definitions of a document type.
class Definitions {
 public:
  Definitions(std::string_view text, std::size_t at) : text_(text), at_(at) {}

  /// Returns the position after the document type; npos if it does not end.
  std::size_t read() {
    while (at_ < text_.size() && text_[at_] != ']') {
      if (text_.substr(at_, 4) == "<!--") {
        skip("<!--", "-->");
      } else if (text_.substr(at_, 2) == "<?") {
        skip("<?", "?>");
      } else if (text_[at_] == '<') {
        definition();
      } else {
        ++at_;
      }
    }
    const std::size_t end = text_.find('>', at_);
    return end == std::string_view::npos ? end : end + 1;
  }

  [[nodiscard]] const std::map<std::string_view, std::string_view>& entities() const noexcept {
    return entities_;
  }

 private:
  /// Skips markup that begins with `start` here and ends with `end`. The end must not overlap the
  /// start, so "<!-->" does not end.
  void skip(std::string_view start, std::string_view end) {
    const std::size_t found = text_.find(end, at_ + start.size());
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }

  /// Reads <!ENTITY name "text">.
  void definition() {
    const std::size_t begin = at_;
    char quote = 0;
    for (; at_ < text_.size() && (quote != 0 || text_[at_] != '>'); ++at_) {
      if (quote != 0) {
        if (text_[at_] == quote) quote = 0;
      } else if (text_[at_] == '"' || text_[at_] == '\'') {
        quote = text_[at_];
      }
    }
    SvgScan scan(text_.substr(begin, at_ - begin));
    if (at_ < text_.size()) ++at_;
    if (!scan.take("<!ENTITY")) return;
    scan.skip_spaces();
    const std::string_view name = scan.name();
    scan.skip_spaces();
    const char mark = scan.peek();
    if (name.empty() || (mark != '"' && mark != '\'') || !scan.take(mark)) return;
    entities_.emplace(name, scan.until(mark));
  }

  std::string_view text_;
  std::size_t at_;
  std::map<std::string_view, std::string_view> entities_;
};

/// Replaces entities, including nested ones, within a budget for the whole file.
class Expander {
 public:
  using Entities = std::map<std::string_view, std::string_view>;
  explicit Expander(const Entities& entities) : entities_(entities) {}

  /// Returns false if the file's budget is exceeded or entities are nested too deep.
  bool append(std::string_view text, std::string& result, int nesting) {
    constexpr int kMaxNesting = 16;
    added_ += text.size();
    if (nesting > kMaxNesting || added_ > limits::kMaxSvgEntityBytes) return false;
    while (true) {
      const std::size_t mark = std::min(text.find('&'), text.size());
      result += text.substr(0, mark);
      text.remove_prefix(mark);
      if (text.empty()) return true;
      SvgScan scan(text.substr(1, 256));
      const auto entity = entities_.find(scan.name());
      if (entity == entities_.end() || !scan.take(';')) {
        result += '&';
        text.remove_prefix(1);
        continue;
      }
      if (!append(entity->second, result, nesting + 1)) return false;
      text.remove_prefix(1 + scan.taken());
    }
  }

 private:
  const Entities& entities_;
  std::size_t added_ = 0;
};

bool has_svg_entities(std::string_view text) noexcept {
  return find_definitions(text, find_doctype(text)) != std::string_view::npos;
}

Result<std::string> svg_with_entities(std::string_view text) {
  const std::size_t begin = find_doctype(text);
  Definitions definitions(text, find_definitions(text, begin));
  const std::size_t end = definitions.read();
  if (end == std::string_view::npos) {
    return fail(ErrorCode::kInvalidData, "is not XML: its document type does not end");
  }
  std::string result(text.substr(0, begin));
  const std::string_view doctype = text.substr(begin, end - begin);
  result.append(static_cast<std::size_t>(std::count(doctype.begin(), doctype.end(), '\n')), '\n');
  Expander expander(definitions.entities());
  std::string_view rest = text.substr(end);
  while (!rest.empty()) {
    const std::size_t mark = std::min(rest.find('&'), rest.size());
    result += rest.substr(0, mark);
    rest.remove_prefix(mark);
    if (rest.empty()) break;
    SvgScan scan(rest.substr(1, 256));
    const auto entity = definitions.entities().find(scan.name());
    if (entity == definitions.entities().end() || !scan.take(';')) {
      result += '&';
      rest.remove_prefix(1);
      continue;
    }
    if (!expander.append(entity->second, result, 0)) {
      return fail(ErrorCode::kLimitExceeded,
                  "has entities that add more than 1 MiB, or are nested more than 16 deep");
    }
    rest.remove_prefix(1 + scan.taken());
  }
  return result;
}

constexpr std::string_view kInkscapeNamespace = "http://www.inkscape.org/namespaces/inkscape";
constexpr std::string_view kSodipodiNamespace =
    "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd";

std::string_view attribute_of(const pugi::xml_node& node, const std::string& prefix,
                              const char* name) {
  if (prefix.empty()) return {};
  const pugi::xml_attribute attribute = node.attribute((prefix + name).c_str());
  return attribute ? std::string_view(attribute.value()) : std::string_view();
}

bool is_style_sheet(const pugi::xml_node& node) {
  if (xml_local_name(node.name()) != "style") return false;
  const std::string_view type = svg_trimmed(node.attribute("type").value());
  return type.empty() || svg_same_word(type, "text/css");
}

}  // namespace

SvgDocument::SvgDocument(XmlInput input) : input_(std::move(input)), root_(input_.root()) {
  const std::string_view name = root_.name();
  svg_prefix_ = name.substr(0, name.size() - xml_local_name(name).size());
  if (svg_prefix_.empty()) svg_prefix_ = xml_prefix_of(root_, kSvgElementNamespace);
  inkscape_prefix_ = xml_prefix_of(root_, kInkscapeNamespace);
  sodipodi_prefix_ = xml_prefix_of(root_, kSodipodiNamespace);
  felt_prefix_ = xml_prefix_of(root_, kSvgNamespace);
}

Result<std::unique_ptr<SvgDocument>> SvgDocument::parse(std::string_view text) {
  std::string resolved;
  if (has_svg_entities(text)) {
    Result<std::string> with_entities = svg_with_entities(text);
    if (!with_entities) return tl::unexpected(with_entities.error());
    resolved = *std::move(with_entities);
    text = resolved;
  }
  Result<XmlInput> input = XmlInput::parse(text);
  if (!input) return tl::unexpected(input.error());
  const std::string_view name = input->root().name();
  if (xml_local_name(name) != "svg") {
    return fail(ErrorCode::kInvalidData,
                "is not an SVG: its first element is '" + std::string(name.substr(0, 100)) + "'");
  }
  std::unique_ptr<SvgDocument> document(new SvgDocument(*std::move(input)));
  document->names_outer_style_ =
      text.substr(0, text.find("<svg")).find("<?xml-stylesheet") != std::string_view::npos;
  if (auto ok = document->look_through(); !ok) return tl::unexpected(ok.error());
  return document;
}

/// Collects attributes, ids and style sheets of all elements.
Result<void> SvgDocument::look_through() {
  pugi::xml_node node = root_;
  while (true) {
    const auto attributes = node.attributes();
    const auto count = std::distance(attributes.begin(), attributes.end());
    if (static_cast<std::size_t>(count) > limits::kMaxSvgAttributes) {
      return fail(ErrorCode::kLimitExceeded, "line " + std::to_string(line_of(node)) + ": " +
                                                 XmlInput::describe(node) +
                                                 " has more than 1000 attributes");
    }
    note_prefixes(node);
    if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace(id.value(), node);
    if (is_style_sheet(node)) style_sheet_.add(xml_text_of(node));
    if (xml_local_name(node.name()) == "color-profile") has_color_profile_ = true;
    pugi::xml_node next =
        node.find_child([](const auto& n) { return n.type() == pugi::node_element; });
    while (!next && node != root_) {
      next = node.next_sibling();
      while (next && next.type() != pugi::node_element) next = next.next_sibling();
      if (next) break;
      node = node.parent();
    }
    if (!next) return {};
    node = next;
  }
}

/// Prefixes may be declared on any element. We assume that a prefix has one meaning in the whole
/// file, which holds for the files that programs write.
void SvgDocument::note_prefixes(const pugi::xml_node& node) {
  for (const pugi::xml_attribute& a : node.attributes()) {
    const std::string_view name = a.name(), space = a.value();
    if (name.substr(0, 6) != "xmlns:") continue;
    const std::string prefix = std::string(name.substr(6)) + ":";
    if (space == kSvgElementNamespace && prefix != svg_prefix_) more_svg_prefixes_.insert(prefix);
    if (space == kInkscapeNamespace && inkscape_prefix_.empty()) inkscape_prefix_ = prefix;
    if (space == kSodipodiNamespace && sodipodi_prefix_.empty()) sodipodi_prefix_ = prefix;
    if (space == kSvgNamespace && felt_prefix_.empty()) felt_prefix_ = prefix;
  }
}

pugi::xml_node SvgDocument::find(std::string_view id) const {
  const auto at = ids_.find(id);
  return at == ids_.end() ? pugi::xml_node() : at->second;
}

std::string_view SvgDocument::inkscape(const pugi::xml_node& node, const char* name) const {
  return attribute_of(node, inkscape_prefix_, name);
}

std::string_view SvgDocument::ours(const pugi::xml_node& node, const char* name) const {
  return attribute_of(node, felt_prefix_, name);
}

std::string_view SvgDocument::sodipodi(const pugi::xml_node& node, const char* name) const {
  return attribute_of(node, sodipodi_prefix_, name);
}

std::string_view SvgDocument::svg_name(const pugi::xml_node& node, bool default_is_svg) const {
  const std::string_view name = node.name();
  const std::size_t colon = name.rfind(':');
  if (colon == std::string_view::npos) return default_is_svg ? name : std::string_view();
  const std::string_view prefix = name.substr(0, colon + 1);
  const bool is_svg =
      prefix == svg_prefix_ || more_svg_prefixes_.find(prefix) != more_svg_prefixes_.end();
  return is_svg ? name.substr(colon + 1) : std::string_view();
}

std::string_view svg_href(const pugi::xml_node& node) {
  if (const pugi::xml_attribute href = node.attribute("href")) return href.value();
  for (const pugi::xml_attribute& a : node.attributes()) {
    if (xml_local_name(a.name()) == "href") return a.value();
  }
  return {};
}

}  // namespace felt
