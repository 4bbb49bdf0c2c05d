#include "felt/io/svg/svg_document.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "felt/io/svg/svg_entities.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_text.h"

namespace felt {
namespace {

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
                "is no SVG: its first element is '" + std::string(name.substr(0, 100)) + "'");
  }
  std::unique_ptr<SvgDocument> document(new SvgDocument(*std::move(input)));
  document->names_outer_style_ =
      text.substr(0, text.find("<svg")).find("<?xml-stylesheet") != std::string_view::npos;
  if (auto ok = document->look_through(); !ok) return tl::unexpected(ok.error());
  return document;
}

/// Attributes, ids and style sheets of all elements.
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
    if (is_style_sheet(node)) {
      sheet_.add(xml_text_of(node));
    }
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

/// Prefixes may be declared on any element. One that means the same everywhere is enough for what
/// programs write.
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
