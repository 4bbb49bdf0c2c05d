#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/svg/svg_color.h"
#include "felt/io/svg/svg_length.h"
#include "felt/io/svg/svg_variables.h"

namespace pugi {
class xml_node;
}

namespace felt {

class SvgStyleSheet;

/// The properties that affect the ink or cause a notice.
enum class SvgProperty : std::uint8_t {
  kBackgroundColor,
  kClipPath,
  kColor,
  kCx,
  kCy,
  kD,
  kDisplay,
  kFill,
  kFillOpacity,
  kFillRule,
  kFilter,
  kFontSize,
  kHeight,
  kMarker,
  kMarkerEnd,
  kMarkerMid,
  kMarkerStart,
  kMask,
  kMixBlendMode,
  kOpacity,
  kOverflow,
  kPaintOrder,
  kR,
  kRotate,
  kRx,
  kRy,
  kScale,
  kSolidColor,
  kStopColor,
  kStopOpacity,
  kStroke,
  kStrokeDasharray,
  kStrokeDashoffset,
  kStrokeLinecap,
  kStrokeLinejoin,
  kStrokeMiterlimit,
  kStrokeOpacity,
  kStrokeWidth,
  kTransform,
  kTransformOrigin,
  kTranslate,
  kVectorEffect,
  kVisibility,
  kWidth,
  kX,
  kY,
  kZoom,
  kCount,
};

/// The declared value of each property of one element, or an empty text if the property is not
/// declared. The values are views into the file or its style sheet.
class SvgDeclared {
 public:
  /// Returns the value of a property by its name; empty if the name is not a property.
  [[nodiscard]] std::string_view value_of(std::string_view name) const noexcept;
  /// The custom properties ("--name") that apply to the element. If null, those of the root apply.
  std::shared_ptr<const SvgVariables> variables;
  /// The name of a property that was declared only with unreadable values, or "" if there is no
  /// such property.
  std::string_view unread;

  [[nodiscard]] std::string_view operator[](SvgProperty p) const noexcept {
    return values_[static_cast<std::size_t>(p)];
  }
  void set(SvgProperty p, std::string_view value) noexcept {
    values_[static_cast<std::size_t>(p)] = value;
  }

 private:
  std::array<std::string_view, static_cast<std::size_t>(SvgProperty::kCount)> values_{};
};

/// Collects the declarations of an element in CSS order: presentation attributes, then rules, then
/// its style attribute, then `!important` ones. If the style attribute has comments, the text
/// without comments is stored in `clean_style`, which must outlive the result. Before the call,
/// `declared.variables` must be the custom properties of the parent; afterwards, they are those of
/// the element. An unreadable colour becomes black. Returns false if SvgStyleSheet::match returns
/// false.
bool svg_declared(const pugi::xml_node& node, SvgStyleSheet& style_sheet, std::string& clean_style,
                  SvgDeclared& declared);

enum class SvgCap : std::uint8_t { kButt, kRound, kSquare };
enum class SvgJoin : std::uint8_t { kMiter, kRound, kBevel };

/// The computed style of an element. Lengths are in user units of the element.
struct SvgStyle {
  // Inherited properties.
  Rgba color{0, 0, 0, 255};
  SvgPaint fill{.kind = SvgPaint::Kind::kColor};
  SvgPaint stroke{};
  double fill_opacity = 1.0;
  double stroke_opacity = 1.0;
  bool even_odd = false;
  double stroke_width = 1.0;
  SvgCap cap = SvgCap::kButt;
  SvgJoin join = SvgJoin::kMiter;
  double miter_limit = 4.0;
  std::shared_ptr<const std::vector<double>> dashes;  ///< null for a solid line
  double dash_offset = 0.0;
  bool visible = true;
  bool has_marker = false;
  bool reorders_paint = false;
  double font_size = 16.0;
  // Properties that are not inherited.
  bool displayed = true;
  double opacity = 1.0;
  bool overflows = false;
  bool scales_line = true;  ///< vector-effect is not non-scaling-stroke
};

/// Computes the style of an element with these declarations inside a parent with style `parent`.
SvgStyle svg_style(const SvgDeclared& declared, const SvgStyle& parent, SvgUnits units);

}  // namespace felt
