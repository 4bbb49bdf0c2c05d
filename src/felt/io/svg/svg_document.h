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

/// A parsed file with its tree, ids, prefixes and style sheets, as read_svg_scene() needs them.
class SvgDocument {
 public:
  /// Parses a file. Fails if it is not XML, not SVG, or beyond a limit. The message states the line
  /// and the reason.
  static Result<std::unique_ptr<SvgDocument>> parse(std::string_view text);

  [[nodiscard]] pugi::xml_node root() const { return root_; }
  [[nodiscard]] std::int64_t line_of(const pugi::xml_node& node) const {
    return input_.line_of(node);
  }
  /// Returns the first element with this id, or a null node.
  [[nodiscard]] pugi::xml_node find(std::string_view id) const;
  /// Return an attribute in the namespace of Inkscape, Feltline or Sodipodi. The data() of the
  /// result is null if the attribute is missing.
  [[nodiscard]] std::string_view inkscape(const pugi::xml_node& node, const char* name) const;
  [[nodiscard]] std::string_view ours(const pugi::xml_node& node, const char* name) const;
  [[nodiscard]] std::string_view sodipodi(const pugi::xml_node& node, const char* name) const;
  /// Returns the name of an SVG element without its prefix; empty for other elements.
  /// `default_is_svg` is true if names without a prefix are SVG at this point.
  [[nodiscard]] std::string_view svg_name(const pugi::xml_node& node, bool default_is_svg) const;
  SvgStyleSheet& style_sheet() noexcept { return style_sheet_; }
  /// Returns true if the file refers to an external style sheet (xml-stylesheet).
  [[nodiscard]] bool names_outer_style() const noexcept { return names_outer_style_; }
  /// Returns true if the file defines a colour profile, to which icc-color() refers.
  [[nodiscard]] bool has_color_profile() const noexcept { return has_color_profile_; }

 private:
  explicit SvgDocument(XmlInput input);
  Result<void> look_through();
  void note_prefixes(const pugi::xml_node& node);

  XmlInput input_;
  pugi::xml_node root_;
  std::unordered_map<std::string_view, pugi::xml_node> ids_;
  std::string svg_prefix_, inkscape_prefix_, felt_prefix_, sodipodi_prefix_;
  std::set<std::string, std::less<>> more_svg_prefixes_;  // prefixes declared below the root
  SvgStyleSheet style_sheet_;
  bool names_outer_style_ = false;
  bool has_color_profile_ = false;
};

/// Returns the value of `href`, with or without a prefix; empty if the attribute is missing.
std::string_view svg_href(const pugi::xml_node& node);

}  // namespace felt
