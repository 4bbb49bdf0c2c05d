#pragma once

#include <functional>
#include <memory>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "felt/base/result.h"
#include "felt/io/svg/svg_css.h"
#include "felt/io/xml/xml_input.h"

namespace felt {

inline constexpr std::string_view kSvgElementNamespace = "http://www.w3.org/2000/svg";

/// A parsed file with what has to be known of all of it before the walk.
class SvgDocument {
 public:
  /// Error: no XML, no SVG, or beyond a limit; the message names line and reason.
  static Result<std::unique_ptr<SvgDocument>> parse(std::string_view text);

  [[nodiscard]] pugi::xml_node root() const { return root_; }
  [[nodiscard]] std::int64_t line_of(const pugi::xml_node& node) const {
    return input_.line_of(node);
  }
  /// The first element with this id, or a null node.
  [[nodiscard]] pugi::xml_node find(std::string_view id) const;
  /// An attribute in the namespace of Inkscape or in ours; its data() is null if there is none.
  [[nodiscard]] std::string_view inkscape(const pugi::xml_node& node, const char* name) const;
  [[nodiscard]] std::string_view ours(const pugi::xml_node& node, const char* name) const;
  [[nodiscard]] std::string_view sodipodi(const pugi::xml_node& node, const char* name) const;
  /// The name of an element of SVG without its prefix; empty for elements of others.
  /// `default_is_svg` says whether names without a prefix are of SVG where it stands.
  [[nodiscard]] std::string_view svg_name(const pugi::xml_node& node, bool default_is_svg) const;
  SvgStyleSheet& sheet() noexcept { return sheet_; }
  /// The file names a style sheet in another one (xml-stylesheet).
  [[nodiscard]] bool names_outer_style() const noexcept { return names_outer_style_; }

 private:
  explicit SvgDocument(XmlInput input);
  Result<void> look_through();
  void note_prefixes(const pugi::xml_node& node);

  XmlInput input_;
  pugi::xml_node root_;
  std::unordered_map<std::string_view, pugi::xml_node> ids_;
  std::string svg_prefix_, inkscape_prefix_, felt_prefix_, sodipodi_prefix_;
  std::set<std::string, std::less<>> more_svg_prefixes_;  // declared below the root
  SvgStyleSheet sheet_;
  bool names_outer_style_ = false;
};

/// The value of `href`, with whatever prefix or none; empty where there is none.
std::string_view svg_href(const pugi::xml_node& node);

}  // namespace felt
