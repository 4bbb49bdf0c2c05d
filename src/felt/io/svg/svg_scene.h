#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/blend_mode.h"
#include "felt/geometry/affine.h"
#include "felt/io/svg/svg_frame.h"
#include "felt/io/svg/svg_path_builder.h"
#include "felt/io/svg/svg_style.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The shapes that an SVG file paints, after its references, styles, units, viewports and
/// transforms were applied. This is the first of two steps of reading; the second converts them to
/// ink (svg_ink.h).

struct SvgFill {
  Rgba color;
  bool even_odd = false;
};

/// Style of the line of a shape. Lengths are in the units of its contours.
struct SvgLine {
  Rgba color;
  double width = 1.0;
  SvgCap cap = SvgCap::kButt;
  SvgJoin join = SvgJoin::kMiter;
  double miter_limit = 4.0;
  std::vector<double> dashes;  ///< empty: solid; otherwise an even number with a sum above 0
  double dash_offset = 0.0;
};

/// The values of the attributes that store a stroke of variable width: those of Inkscape's
/// PowerStroke and our own. They are views into the text of the file, and empty if the attribute is
/// missing.
struct SvgVariableWidth {
  std::string_view center_line;  ///< inkscape:original-d
  std::string_view offset_points, interpolator, interpolator_beta, scale_width, start_cap, end_cap;
  bool has_effect = false;
  bool has_pattern = false;  ///< it has the effect Pattern Along Path
  std::string_view id, number, medium, closed, joints, points, widths, tones;
  bool is_ours = false;
  Rgba color;  ///< colour of the ink: the fill of the path, even if it is fully transparent
};

/// A painted shape. `contours` are in the user units of the shape, because the width of its line is
/// in user units. `to_mm` transforms user units to the page.
struct SvgShape {
  std::string_view element, id;
  std::int64_t line_number = 0;  ///< from 1; 0 if unknown
  std::vector<SvgContour> contours;
  Affine to_mm;
  std::optional<SvgFill> fill;
  std::optional<SvgLine> line;
  std::optional<SvgVariableWidth> variable_width;
  std::string_view pieces;        ///< felt:fill: the references of a fill of ours
  std::optional<SvgFrame> frame;  ///< the area that the viewports of the shape show
  bool is_cut = false;            ///< has a clip path or mask, which was ignored
  /// The transparent group of the shape, or 0. Consecutive shapes of one group are transparent as a
  /// whole, by `group_opacity`, which is not part of their colours.
  std::size_t group = 0;
  double group_opacity = 1.0;
};

/// A picture. `to_mm` transforms its user units to the page.
struct SvgImage {
  std::string_view element, id;
  std::int64_t line_number = 0;
  std::string_view href;
  double x = 0.0, y = 0.0;
  std::optional<double> width, height;  ///< absent: by the size of the picture
  std::string_view aspect;              ///< preserveAspectRatio
  Affine to_mm;
  double opacity = 1.0;  ///< of the picture and of its transparent groups
  std::optional<SvgFrame> frame;
};

/// A layer of Inkscape, a group with a blend mode, or the content outside all layers.
struct SvgLayer {
  /// A layer of Inkscape that contains layers.
  struct Group {
    std::string_view label;
    std::size_t number = 0;
    bool visible = true;
    bool locked = false;
    double opacity = 1.0;
    BlendMode blend = BlendMode::kNormal;
  };

  std::string_view label;
  std::size_t number = 0;  ///< 0: content outside all layers
  bool visible = true;
  bool locked = false;
  double opacity = 1.0;
  BlendMode blend = BlendMode::kNormal;
  std::optional<Group> group;
};

/// Properties of the root element.
struct SvgRoot {
  std::optional<double> width_mm, height_mm;
  bool is_ours = false;
  bool begins_at_zero = true;               ///< the top left corner is at (0, 0) of the page
  std::string_view page;                    ///< felt:page, if the file is ours
  std::string_view surface;                 ///< felt:surface, if the file is ours
  std::vector<std::string_view> materials;  ///< felt:material1 and so on, if the file is ours
};

/// Receives the content that read_svg_scene() finds, in painting order.
class SvgSceneSink {
 public:
  virtual ~SvgSceneSink() = default;
  virtual void root(const SvgRoot& root) = 0;
  /// Begins a layer. All content up to the next call is in this layer.
  virtual void layer(const SvgLayer& layer) = 0;
  virtual void shape(SvgShape shape) = 0;
  virtual void image(const SvgImage& image) = 0;
  /// Sets the colour of the paper. This is the colour of the background rectangle in a file that
  /// Feltline wrote, or the background colour in other files.
  virtual void paper(Rgba color) = 0;
  /// Ends the content. This is the last call during which the views are valid.
  virtual void end() = 0;
  /// Reports content that is not shown as the file specifies. `line` has the same meaning as
  /// SvgShape::line_number.
  virtual void notice(std::int64_t line, std::string element, std::string what) = 0;
};

/// Walks through the elements of a file, without recursion, and passes their content to the sink.
/// The views passed to the sink are valid until this returns. Fails if the file is not XML or SVG,
/// was written by a newer Feltline, or exceeds a limit. The message states the line and the reason.
Result<void> read_svg_scene(std::string_view text, SvgSceneSink& sink);

/// Returns "path 'leaf'", or "path" without an id.
std::string svg_element_text(std::string_view element, std::string_view id);

}  // namespace felt
