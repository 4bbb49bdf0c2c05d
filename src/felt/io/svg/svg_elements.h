#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/geometry/rect.h"
#include "felt/stroke/outline/outline_path.h"
#include "felt/stroke/stroke.h"

namespace felt {

struct GrainMask;
struct StrokeStyle;

/// These functions write the pieces of an SVG file of a sketch (docs/formats/svg.md). Most of them
/// append to `out`. Equal values give equal bytes.

/// Namespace of the attributes for our model, and the version that is written. In version 1, every
/// number was a decimal with 17 digits, in mm.
inline constexpr std::string_view kSvgNamespace = "https://feltline.org/ns/1";
inline constexpr std::string_view kSvgVersion = "2";

/// Prefix of the ids of masks that show the grain of a stroke.
inline constexpr std::string_view kSvgMaskId = "grain";

/// Size in bytes of the head of a file. It is the same for every area, so that a writer can write a
/// provisional head first and overwrite it when the area is known.
inline constexpr std::size_t kSvgHeadBytes = 640;

/// Paths are written in mm, rounded to steps of 0.001 mm. The user unit is 1 mm and not 0.001 mm,
/// because Inkscape computes a PowerStroke with an accuracy of 0.01 user units, and fails if the
/// stroke is very much wider than that.
inline constexpr double kSvgStepsPerMm = 1e3;

/// The medium of strokes that specify none.
inline constexpr std::string_view kSvgUsualMaterial = "pencil";

/// Widths and tones are stored as exact differences from this value (exact_numbers.h).
inline constexpr double kSvgWidthGuess = 1.0;

/// Appends the XML declaration and the start of the root element, which shows `area` in mm at its
/// true size. Then appends the paper, a filled rectangle, unless its alpha is 0. `model` is empty
/// or the result of svg_model_text(), the attributes of the root element.
void append_svg_head(std::string& out, const Rect& area, Rgba paper, std::string_view model = {});

/// Returns the attributes of the root element that describe a drawing, each followed by a space:
/// the page ("297 210 #ffffffff", or "none" if `page` is null), and the drawing's surface and
/// materials if it has any. Fails if XML cannot hold a surface name or text.
Result<std::string> svg_model_text(const Drawing& drawing, const Page* page);

/// Begins a layer in Inkscape's form. `number` makes the id of its element unique. Fails, and
/// appends nothing, if XML cannot hold the name.
Result<void> append_svg_layer_begin(std::string& out, const Layer& layer, std::size_t number);

/// Begins a group of layers, as a layer that contains layers. Fails, and appends nothing, if XML
/// cannot hold the name.
Result<void> append_svg_layer_group_begin(std::string& out, const LayerGroup& group);

/// Appends a picture as an image element that contains its file.
void append_svg_picture(std::string& out, const LayerPicture& picture);

/// Begins a group for strokes outside all layers.
void append_svg_group_begin(std::string& out);
/// Ends a layer or group.
void append_svg_group_end(std::string& out);

/// Names of a stroke in a file.
struct SvgStrokeNames {
  std::string_view name;      ///< name_in_file()
  std::string_view number{};  ///< stroke_name(), if a reader would give the stroke another id
};

/// Appends one stroke: a filled path that any viewer shows correctly, with Inkscape's PowerStroke
/// and our attributes. `number` makes the element ids unique. `tolerance_mm` applies to the
/// outline; our attributes are exact. If `mask` is set, the path gets this mask, which shows the
/// grain; the path itself does not change. If `style` is set, the path is the stylised ink
/// (styled_path()), and a style with a shape has Inkscape's effect Pattern Along Path instead of a
/// PowerStroke. Call it inside a layer or group. Fails, and appends nothing, if XML cannot hold the
/// names or medium, or if a coordinate is beyond 1e9 mm.
Result<void> append_svg_stroke(std::string& out, const SvgStrokeNames& names, const Stroke& stroke,
                               std::size_t number, double tolerance_mm,
                               const GrainMask* mask = nullptr, const StrokeStyle* style = nullptr);

/// Appends one fill: a path with the even-odd rule. Its numbers are exact, and our attribute holds
/// its references. Call it inside a layer or group, before the strokes. Fails, and appends nothing,
/// if a coordinate is beyond 1e9 mm.
Result<void> append_svg_fill(std::string& out, std::string_view id, const Fill& fill);

/// Ends the root element.
void append_svg_tail(std::string& out);

/// Appends the path data of an outline in mm, with relative commands. All points are first rounded
/// to whole steps of 0.001 mm, so that rounding errors do not add up. Requires coordinates within
/// 1e9 mm.
void append_path_data(std::string& out, const OutlinePath& path);

}  // namespace felt
