#include "felt/io/svg/svg_style.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "felt/io/svg/svg_css.h"
#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

constexpr std::size_t kCount = static_cast<std::size_t>(SvgProperty::kCount);

/// Property names in the order of SvgProperty, which is alphabetical.
constexpr std::array<std::string_view, kCount> kNames{"background-color",
                                                      "clip-path",
                                                      "color",
                                                      "cx",
                                                      "cy",
                                                      "d",
                                                      "display",
                                                      "fill",
                                                      "fill-opacity",
                                                      "fill-rule",
                                                      "filter",
                                                      "font-size",
                                                      "height",
                                                      "marker",
                                                      "marker-end",
                                                      "marker-mid",
                                                      "marker-start",
                                                      "mask",
                                                      "mix-blend-mode",
                                                      "opacity",
                                                      "overflow",
                                                      "paint-order",
                                                      "r",
                                                      "rotate",
                                                      "rx",
                                                      "ry",
                                                      "scale",
                                                      "solid-color",
                                                      "stop-color",
                                                      "stop-opacity",
                                                      "stroke",
                                                      "stroke-dasharray",
                                                      "stroke-dashoffset",
                                                      "stroke-linecap",
                                                      "stroke-linejoin",
                                                      "stroke-miterlimit",
                                                      "stroke-opacity",
                                                      "stroke-width",
                                                      "transform",
                                                      "transform-origin",
                                                      "translate",
                                                      "vector-effect",
                                                      "visibility",
                                                      "width",
                                                      "x",
                                                      "y",
                                                      "zoom"};

constexpr std::size_t kMaxDashes = 1000;

std::optional<std::size_t> property_of(std::string_view name) noexcept {
  const auto at = std::lower_bound(kNames.begin(), kNames.end(), name);
  if (at == kNames.end() || *at != name) return std::nullopt;
  return static_cast<std::size_t>(at - kNames.begin());
}

/// Returns true for values that inherit from the parent or reset the property.
bool is_inherit(std::string_view value) noexcept {
  return svg_same_word(value, "inherit") || svg_same_word(value, "unset") ||
         svg_same_word(value, "revert") || svg_same_word(value, "revert-layer");
}
bool is_initial(std::string_view value) noexcept {
  return svg_same_word(value, "initial");
}

std::optional<std::vector<double>> dash_list(std::string_view text, const SvgUnits& units);

/// Returns true if a paint, colour, opacity or width can be read. A declaration with an unreadable
/// value does not replace an earlier one. Values with variables are checked after the variables are
/// replaced.
bool is_readable(SvgProperty p, std::string_view value) {
  if (is_inherit(value) || is_initial(value)) return true;
  if (value.find("var(") != std::string_view::npos) return true;
  switch (p) {
    case SvgProperty::kStrokeWidth:
      return svg_length(value, SvgAxis::kDiagonal, SvgUnits()).has_value();
    case SvgProperty::kStrokeDasharray:
      return dash_list(value, SvgUnits()).has_value();
    case SvgProperty::kFill:
    case SvgProperty::kStroke:
      return svg_paint(value).has_value();
    case SvgProperty::kBackgroundColor:
    case SvgProperty::kColor:
    case SvgProperty::kSolidColor:
    case SvgProperty::kStopColor:
      return svg_color(value).has_value() || svg_same_word(value, "currentColor");
    case SvgProperty::kOpacity:
    case SvgProperty::kFillOpacity:
    case SvgProperty::kStrokeOpacity:
    case SvgProperty::kStopOpacity:
      return svg_share(value).has_value();
    default:
      return true;
  }
}

bool is_geometry(SvgProperty p) noexcept {
  using P = SvgProperty;
  return p == P::kCx || p == P::kCy || p == P::kHeight || p == P::kR || p == P::kRx ||
         p == P::kRy || p == P::kWidth || p == P::kX || p == P::kY;
}

/// In CSS a length needs a unit; without one it is valid only in an attribute.
bool is_css_length(std::string_view value) noexcept {
  const char last = value.back();
  return value == "0" || last == '%' || last == ')' || (last >= 'a' && last <= 'z') ||
         (last >= 'A' && last <= 'Z');
}

bool is_color(SvgProperty p) noexcept {
  return p == SvgProperty::kFill || p == SvgProperty::kStroke || p == SvgProperty::kColor ||
         p == SvgProperty::kStopColor || p == SvgProperty::kSolidColor;
}

/// Sets an inherited property. `read` returns the value, or nullopt if it has an error.
template <class T, class Read>
void compute(std::string_view value, T& computed, const T& initial, Read read) {
  if (value.empty() || is_inherit(value)) return;
  if (is_initial(value)) {
    computed = initial;
  } else if (const std::optional<T> got = read(value)) {
    computed = *got;
  }
}

std::optional<SvgCap> cap_of(std::string_view v) {
  if (v == "butt") return SvgCap::kButt;
  if (v == "round") return SvgCap::kRound;
  if (v == "square") return SvgCap::kSquare;
  return std::nullopt;
}

std::optional<SvgJoin> join_of(std::string_view v) {
  if (v == "miter" || v == "miter-clip" || v == "arcs") return SvgJoin::kMiter;
  if (v == "round") return SvgJoin::kRound;
  if (v == "bevel") return SvgJoin::kBevel;
  return std::nullopt;
}

std::optional<double> plain_number(std::string_view text) {
  SvgScan scan(svg_trimmed(text));
  double value = 0.0;
  return scan.number(value) && scan.at_end() ? std::optional(value) : std::nullopt;
}

/// Parses a list of dashes. Returns nullopt if the list has an error and must be ignored. An empty
/// list means a solid line.
std::optional<std::vector<double>> dash_list(std::string_view text, const SvgUnits& units) {
  std::vector<double> dashes;
  double sum = 0.0;
  SvgScan scan(svg_trimmed(text));
  if (svg_same_word(scan.rest(), "none")) return dashes;
  while (!scan.empty()) {
    const std::string_view from = scan.rest();
    while (!scan.empty() && scan.peek() != ',' && !is_svg_space(scan.peek())) {
      scan.take(scan.peek());
    }
    const std::optional<double> length =
        svg_length(from.substr(0, from.size() - scan.rest().size()), SvgAxis::kDiagonal, units);
    if (!length || !(*length >= 0.0) || dashes.size() == kMaxDashes) return std::nullopt;
    dashes.push_back(*length);
    sum += *length;
    scan.skip_comma();
  }
  if (!(sum > 0.0)) dashes.clear();
  if (dashes.size() % 2 == 1) {
    const std::vector<double> once = dashes;
    dashes.insert(dashes.end(), once.begin(), once.end());
  }
  return dashes;
}

/// Reads a font size: a keyword of CSS 2.1, section 15.7, or a length. A percentage is relative to
/// the parent's size.
std::optional<double> font_size(std::string_view value, double parent, const SvgUnits& units) {
  struct Word {
    std::string_view name;
    double size;
  };
  constexpr std::array<Word, 7> kWords{{{"xx-small", 9.0},
                                        {"x-small", 10.0},
                                        {"small", 13.0},
                                        {"medium", 16.0},
                                        {"large", 18.0},
                                        {"x-large", 24.0},
                                        {"xx-large", 32.0}}};
  for (const Word& w : kWords) {
    if (w.name == value) return w.size;
  }
  if (value == "larger") return 1.2 * parent;
  if (value == "smaller") return parent / 1.2;
  if (value.back() == '%') {
    const std::optional<double> share = plain_number(value.substr(0, value.size() - 1));
    return share ? std::optional(0.01 * *share * parent) : std::nullopt;
  }
  return svg_length(value, SvgAxis::kDiagonal, units);
}

void apply_paint(const SvgDeclared& d, SvgStyle& s) {
  const SvgStyle initial;
  compute(d[SvgProperty::kColor], s.color, initial.color, svg_color);
  compute(d[SvgProperty::kFill], s.fill, initial.fill, svg_paint);
  compute(d[SvgProperty::kStroke], s.stroke, initial.stroke, svg_paint);
  compute(d[SvgProperty::kFillOpacity], s.fill_opacity, 1.0, svg_share);
  compute(d[SvgProperty::kStrokeOpacity], s.stroke_opacity, 1.0, svg_share);
  compute(d[SvgProperty::kFillRule], s.even_odd, false, [](std::string_view v) {
    return v == "evenodd"   ? std::optional(true)
           : v == "nonzero" ? std::optional(false)
                            : std::nullopt;
  });
  compute(d[SvgProperty::kVisibility], s.visible, true, [](std::string_view v) {
    return v == "visible"                       ? std::optional(true)
           : (v == "hidden" || v == "collapse") ? std::optional(false)
                                                : std::nullopt;
  });
  const auto marks = [](std::string_view v) { return std::optional(v != "none"); };
  for (const SvgProperty p : {SvgProperty::kMarker, SvgProperty::kMarkerStart,
                              SvgProperty::kMarkerMid, SvgProperty::kMarkerEnd}) {
    compute(d[p], s.has_marker, false, marks);
  }
  compute(d[SvgProperty::kPaintOrder], s.reorders_paint, false, [](std::string_view v) {
    return std::optional(v != "normal" && v.substr(0, 4) != "fill");
  });
}

void apply_line(const SvgDeclared& d, SvgStyle& s, const SvgUnits& units) {
  const auto length = [&](std::string_view v) { return svg_length(v, SvgAxis::kDiagonal, units); };
  compute(d[SvgProperty::kStrokeWidth], s.stroke_width, 1.0, [&](std::string_view v) {
    const std::optional<double> width = length(v);
    return width && *width >= 0.0 ? width : std::nullopt;
  });
  compute(d[SvgProperty::kStrokeLinecap], s.cap, SvgCap::kButt, cap_of);
  compute(d[SvgProperty::kStrokeLinejoin], s.join, SvgJoin::kMiter, join_of);
  compute(d[SvgProperty::kStrokeMiterlimit], s.miter_limit, 4.0, [](std::string_view v) {
    const std::optional<double> limit = plain_number(v);
    return limit && *limit >= 1.0 ? limit : std::nullopt;
  });
  using Dashes = std::shared_ptr<const std::vector<double>>;
  compute(d[SvgProperty::kStrokeDasharray], s.dashes, Dashes(),
          [&](std::string_view v) -> std::optional<Dashes> {
            std::optional<std::vector<double>> list = dash_list(v, units);
            if (!list || list->empty()) return Dashes();
            return std::make_shared<const std::vector<double>>(*std::move(list));
          });
  compute(d[SvgProperty::kStrokeDashoffset], s.dash_offset, 0.0, length);
}

}  // namespace

std::string_view SvgDeclared::value_of(std::string_view name) const noexcept {
  const std::optional<std::size_t> p = property_of(name);
  return p ? values_[*p] : std::string_view();
}

namespace {

/// Collects the declarations on one element; the one with the highest rank wins.
class Declarations {
 public:
  explicit Declarations(SvgDeclared& declared) : declared_(declared) {}

  void say(std::string_view name, std::string_view value, std::uint64_t rank) {
    if (value.empty()) return;
    if (name.substr(0, 2) == "--") return say_variable(name, value, rank);
    const std::optional<std::size_t> p = property_of(name);
    if (!p || ranks_[*p] > rank) return;
    const auto property = static_cast<SvgProperty>(*p);
    if (rank > 0 && is_geometry(property) && !is_css_length(value)) return;
    if (!is_readable(property, value)) {
      unread_[*p] = true;
      return;
    }
    declared_.set(property, value);
    ranks_[*p] = rank;
  }

  /// Call after the last declaration. Replaces variables and finds properties without a readable
  /// value.
  void finish(SvgStyleSheet& style_sheet) {
    if (!own_.empty()) {
      SvgVariables all = inherited(style_sheet);
      for (auto& [name, value] : own_) all.insert_or_assign(std::string(name), value.second);
      declared_.variables = std::make_shared<const SvgVariables>(std::move(all));
    }
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto p = static_cast<SvgProperty>(i);
      if (declared_[p].find("var(") != std::string_view::npos) replace_variables(p, style_sheet);
      if (!unread_[i] || !declared_[p].empty()) continue;
      declared_.unread = kNames[i];
      if (is_color(p)) declared_.set(p, "black");
    }
  }

 private:
  static constexpr std::size_t kMaxVariables = 1000;

  [[nodiscard]] const SvgVariables& inherited(const SvgStyleSheet& style_sheet) const {
    return declared_.variables ? *declared_.variables : style_sheet.root_variables();
  }

  void say_variable(std::string_view name, std::string_view value, std::uint64_t rank) {
    if (own_.size() == kMaxVariables && own_.find(name) == own_.end()) return;
    auto& [known_rank, known] = own_[name];
    if (known_rank <= rank) known = value;
    known_rank = std::max(known_rank, rank);
  }

  void replace_variables(SvgProperty p, SvgStyleSheet& style_sheet) {
    const auto value =
        svg_with_variables(declared_[p], inherited(style_sheet), style_sheet.variable_bytes_left());
    const std::string_view kept =
        value ? style_sheet.keep(svg_trimmed(*value)) : std::string_view();
    declared_.set(p, kept.empty() || !is_readable(p, kept) ? std::string_view() : kept);
    unread_[static_cast<std::size_t>(p)] = declared_[p].empty();
  }

  SvgDeclared& declared_;
  std::array<std::uint64_t, kCount> ranks_{};
  std::array<bool, kCount> unread_{};
  std::map<std::string_view, std::pair<std::uint64_t, std::string>> own_;
};

}  // namespace

bool svg_declared(const pugi::xml_node& node, SvgStyleSheet& style_sheet, std::string& clean_style,
                  SvgDeclared& declared) {
  constexpr std::uint64_t kInline = std::uint64_t{1} << 60, kImportant = std::uint64_t{1} << 61;
  constexpr std::array<std::string_view, 7> kNoAttributes{
      "background-color", "marker", "mix-blend-mode", "rotate", "scale", "translate", "zoom"};
  Declarations all(declared);
  for (const pugi::xml_attribute& a : node.attributes()) {
    const std::string_view name = a.name();
    const bool counts =
        std::find(kNoAttributes.begin(), kNoAttributes.end(), name) == kNoAttributes.end() &&
        name.substr(0, 2) != "--";
    if (counts) all.say(name, svg_trimmed(a.value()), 0);
  }
  const bool within_budget =
      style_sheet.match(node, [&](const SvgDeclaration& d, std::uint64_t precedence) {
        all.say(d.name, d.value, precedence + 1 + (d.important ? kImportant : 0));
      });
  std::string_view style = node.attribute("style").value();
  if (style.find("/*") != std::string_view::npos) {
    clean_style = svg_without_comments(style);
    style = clean_style;
  }
  svg_declarations(style, [&](const SvgDeclaration& d) {
    all.say(d.name, d.value, kInline + (d.important ? kImportant : 0));
  });
  all.finish(style_sheet);
  return within_budget;
}

SvgStyle svg_style(const SvgDeclared& declared, const SvgStyle& parent, SvgUnits units) {
  SvgStyle s = parent;
  units.font_size = parent.font_size;
  compute(declared[SvgProperty::kFontSize], s.font_size, 16.0, [&](std::string_view v) {
    const std::optional<double> size = font_size(v, parent.font_size, units);
    return size && *size >= 0.0 ? size : std::nullopt;
  });
  units.font_size = s.font_size;
  apply_paint(declared, s);
  apply_line(declared, s, units);
  const std::string_view opacity = declared[SvgProperty::kOpacity];
  s.opacity = svg_same_word(opacity, "inherit") ? parent.opacity : svg_share(opacity).value_or(1.0);
  s.displayed = !svg_same_word(declared[SvgProperty::kDisplay], "none");
  const std::string_view overflow = declared[SvgProperty::kOverflow];
  s.overflows = overflow == "visible" || overflow == "auto";
  s.scales_line = !svg_same_word(declared[SvgProperty::kVectorEffect], "non-scaling-stroke");
  return s;
}

}  // namespace felt
