#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/affine.h"
#include "felt/geometry/rect.h"
#include "felt/io/svg/svg_path.h"
#include "felt/io/svg/svg_style.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// An SVG file resolved into what it paints: references, styles, units, viewports and transforms
/// are worked out. The first of two steps of reading; the second makes ink of it (svg_ink.h).

struct SvgFill {
  Rgba color;
  bool even_odd = false;
};

/// How the line of a shape is drawn; lengths in the units of its contours.
struct SvgLine {
  Rgba color;
  double width = 1.0;
  SvgCap cap = SvgCap::kButt;
  SvgJoin join = SvgJoin::kMiter;
  double miter_limit = 4.0;
  std::vector<double> dashes;  ///< empty: solid; else an even number of them, with a sum above 0
  double dash_offset = 0.0;
};

/// The attributes by which a stroke of variable width travels: Inkscape's PowerStroke and ours, as
/// they are written. Views into the file, empty where there are none.
struct SvgVariableWidth {
  std::string_view center_line;  ///< inkscape:original-d
  std::string_view offset_points, interpolator, interpolator_beta, scale_width, start_cap, end_cap;
  bool has_effect = false;
  std::string_view id, material, closed, joints, points, widths, tones;
  bool is_ours = false;
  Rgba color;  ///< of its ink: the filling of the path, also where that is fully transparent
};

/// A painted shape. `contours` are in its user units and `to_mm` takes them to the sheet, since
/// what a line of it looks like is made in user units.
struct SvgShape {
  std::string_view element, id;
  std::int64_t line_number = 0;  ///< from 1; 0 where it is not known
  std::vector<SvgContour> contours;
  Affine to_mm;
  std::optional<SvgFill> fill;
  std::optional<SvgLine> line;
  std::optional<SvgVariableWidth> variable_width;
  std::optional<Rect> frame;  ///< what of it its viewport shows, in mm
  bool is_cut = false;        ///< by a clip path or mask, which was ignored
};

/// A layer of Inkscape, or what stands in none.
struct SvgLayer {
  std::string_view label;
  std::size_t number = 0;  ///< 0: what stands in none
  bool visible = true;
  bool locked = false;
};

/// What the root says of the whole.
struct SvgRoot {
  std::optional<double> width_mm, height_mm;
  bool is_ours = false;
  bool begins_at_zero = true;  ///< whether the top left corner is at (0, 0) of the sheet
  std::string_view page;       ///< felt:page, where it is ours
  std::string_view surface;    ///< felt:surface, likewise
  std::vector<std::string_view> materials;  ///< felt:material1 and on, likewise
};

/// Who takes what the walk finds, in painting order.
class SvgSceneSink {
 public:
  virtual ~SvgSceneSink() = default;
  virtual void root(const SvgRoot& root) = 0;
  /// What follows stands in this layer.
  virtual void layer(const SvgLayer& layer) = 0;
  virtual void shape(SvgShape shape) = 0;
  /// The paper: a rectangle that we wrote, or the background of the whole.
  virtual void paper(Rgba color) = 0;
  /// Something that is not painted as the file says. `line` as SvgShape::line_number.
  virtual void notice(std::int64_t line, std::string element, std::string what) = 0;
};

/// Walks a file, without recursion. Views that the sink is given are valid until this returns.
/// Error: no XML or no SVG, a newer one of ours, or a limit; the message names line and reason.
Result<void> read_svg_scene(std::string_view text, SvgSceneSink& sink);

/// "path 'leaf'", or "path".
std::string svg_element_text(std::string_view element, std::string_view id);

}  // namespace felt
