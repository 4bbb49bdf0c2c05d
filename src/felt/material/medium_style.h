#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"

namespace felt {

/// What is drawn in place of a solid line.
enum class StyleKind : std::uint8_t {
  kPlain,    ///< the line itself
  kDashes,   ///< dashes, or dots
  kDouble,   ///< two thin lines, one on each side
  kRepeat,   ///< a shape that is repeated along the line
  kStretch,  ///< a shape that is stretched over the whole line
  kHatch,    ///< the line and, if it is closed, parallel lines inside
};

/// The ends of an open line that have arrow heads.
enum class StyleArrows : std::uint8_t { kNone, kStart, kEnd, kBoth };

/// The names of the values of both enumerations, in their order.
inline constexpr std::array<std::string_view, 6> kStyleKinds = {"plain",  "dashes",  "double",
                                                                "repeat", "stretch", "hatch"};
inline constexpr std::array<std::string_view, 4> kStyleArrows = {"none", "start", "end", "both"};

/// Largest size of MediumStyle::shape, which must fit into one line of a material's text.
inline constexpr std::size_t kMaxStyleShapeBytes = 400;

/// The default shape: pointed at both ends.
inline constexpr std::string_view kLensShape = "M0 0C.3 -.5 .7 -.5 1 0C.7 .5 .3 .5 0 0Z";

/// How a medium stylises its lines (Vansichem et al. 2001, the shapes of its brushes; the
/// parameters are Feltline's own). A style never inks a point outside the plain line, except that
/// kHatch also inks the area that a line encloses. Lengths in `widths` are multiples of the width
/// that the line has at each point, so that a style is wider and longer where the line is wider.
/// render/styled_outline.h explains how styles fit lines.
struct MediumStyle {
  StyleKind kind = StyleKind::kPlain;
  double length = 3.0;  ///< of a dash or of one repeat, in widths
  double gap = 1.5;     ///< between dashes or repeats, in widths
  double thin = 1.0;    ///< width of dashes, rails and of a line with an arrow, as a share of the
                        ///< line's width
  StyleArrows arrows = StyleArrows::kNone;
  double arrow_length = 1.5;  ///< of an arrow head, in widths
  double angle_deg = 45.0;    ///< of the hatching on the page, from +x to +y
  double spacing_mm = 2.0;    ///< between lines of the hatching
  /// The shape of kRepeat and kStretch, as path data (read_style_shape). x is 0 at the start and 1
  /// at the end of one repeat, y is -0.5 at the left and 0.5 at the right edge of the line.
  std::string shape{kLensShape};

  friend bool operator==(const MediumStyle&, const MediumStyle&) = default;
};

/// Closed contours that are filled together with the non-zero rule.
struct StyleShape {
  /// Each contour is a row of 3n + 1 control points of joined cubics; the last point is the first.
  std::vector<std::vector<Point>> contours;
};

/// Reads a shape from path data of SVG with the commands M, L, H, V, C and Z; small letters are
/// relative, and spaces or commas separate numbers. Contours are closed. Fails if there is another
/// command, if a number is missing or not within 0..1 (x) and -0.5..0.5 (y), or if the text has no
/// contour that encloses an area or is too long. The message names the character, if there is one.
Result<StyleShape> read_style_shape(std::string_view text);

}  // namespace felt
