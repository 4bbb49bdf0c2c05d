#pragma once

#include <optional>
#include <string_view>

#include "felt/geometry/affine.h"
#include "felt/geometry/rect.h"

namespace felt {

inline constexpr double kSvgPxPerInch = 96.0;
inline constexpr double kSvgMmPerPx = 25.4 / kSvgPxPerInch;

/// The length in the viewport that a percentage refers to: its width, its height, or its diagonal
/// as SVG defines it.
enum class SvgAxis { kX, kY, kDiagonal };

/// The lengths that relative units refer to, all in user units.
struct SvgUnits {
  double font_size = 16.0;
  double root_font_size = 16.0;
  double view_width = 0.0;  ///< of the nearest viewport
  double view_height = 0.0;
  double root_width = 0.0;  ///< of the outermost viewport
  double root_height = 0.0;
};

/// Parses "12", "3mm", "50%", ... and returns user units. Returns nullopt if the text is not a
/// length or has a unit that SVG does not define.
std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgUnits& units);

/// Parses a length and returns it in mm: 210 for "210mm", and 25.4 for "96". Returns nullopt for
/// percentages and for anything that is not a length.
std::optional<double> svg_paper_mm(std::string_view text);

/// Parses "x y width height". Returns nullopt unless the text has four numbers, with a width and
/// height above 0.
std::optional<Rect> svg_view_box(std::string_view text);

/// Returns the transform that fits a view box into a viewport of width x height at (0, 0)
/// (preserveAspectRatio).
Affine svg_view_transform(const Rect& box, double width, double height, std::string_view aspect);

/// Parses a list of transforms in the grammar of the attribute or of CSS. Returns nullopt if it has
/// an error; the whole list is then ignored.
std::optional<Affine> svg_transform(std::string_view text);

/// Returns the position that `transform-origin` specifies, in user units; (0, 0) if it specifies
/// none.
Vec svg_transform_origin(std::string_view text, const SvgUnits& units);

}  // namespace felt
