#pragma once

#include <optional>
#include <string_view>

#include "felt/geometry/affine.h"
#include "felt/geometry/rect.h"

namespace felt {

inline constexpr double kSvgPxPerInch = 96.0;
inline constexpr double kSvgMmPerPx = 25.4 / kSvgPxPerInch;

/// What a percentage is a share of.
enum class SvgAxis { kX, kY, kDiagonal };

/// What relative lengths refer to, all in user units.
struct SvgUnits {
  double font_size = 16.0;
  double root_font_size = 16.0;
  double view_width = 0.0;  ///< of the nearest viewport
  double view_height = 0.0;
  double root_width = 0.0;  ///< of the outermost one
  double root_height = 0.0;
};

/// "12", "3mm", "50%", ... in user units. None: no length, or a unit that SVG does not have.
std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgUnits& units);

/// A size on paper: "210mm" -> 210, "96" -> 25.4. None for percentages and what is no length.
std::optional<double> svg_paper_mm(std::string_view text);

/// "x y width height"; None where it is not four numbers with a size above 0.
std::optional<Rect> svg_view_box(std::string_view text);

/// How a view box fills a viewport of width x height from (0, 0) on (preserveAspectRatio).
Affine svg_view_transform(const Rect& box, double width, double height, std::string_view aspect);

/// A list of transforms, by the attribute's grammar or that of CSS. None: it has an error, and the
/// whole list counts as not there.
std::optional<Affine> svg_transform(std::string_view text);

/// The place that `transform-origin` names, in user units; (0, 0) where it names none.
Vec svg_transform_origin(std::string_view text, const SvgUnits& units);

}  // namespace felt
