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

/// The pieces of text that an SVG file of a sketch is made of (docs/formats/svg.md). Each function
/// appends to `out`. Equal values give equal bytes.

/// Namespace of the attributes that carry our model, and the version that is written. Version 1 had
/// every number as a decimal of 17 digits, in mm.
inline constexpr std::string_view kSvgNamespace = "https://feltline.org/ns/1";
inline constexpr std::string_view kSvgVersion = "2";

/// What the ids of masks begin with that show the grain of a stroke.
inline constexpr std::string_view kSvgMaskId = "grain";

/// Bytes that the head of a file takes, whatever area it states, so that it can be put in place
/// when the area is known at last.
inline constexpr std::size_t kSvgHeadBytes = 640;

/// Paths are written in mm, rounded to steps of 0.001 mm. The unit stays 1 mm: Inkscape computes a
/// PowerStroke to 0.01 user units and fails if that is much less than the stroke's width.
inline constexpr double kSvgStepsPerMm = 1e3;

/// The material of strokes that name none.
inline constexpr std::string_view kSvgUsualMaterial = "pencil";

/// What the exact numbers of widths and tones are differences from.
inline constexpr double kSvgWidthGuess = 1.0;

/// XML declaration and start of the root element, which shows `area` in mm at its true size; then
/// the paper, a filled rectangle, unless its alpha is 0. `model`, where it is not empty, says what
/// page the model has, as svg_model_text gives it.
void append_svg_head(std::string& out, const Rect& area, Rgba paper, std::string_view model = {});

/// The attributes of the root that describe a drawing: `page` ("297 210 #ffffffff", or "none" if it
/// is null), its surface and its materials if it has any, each followed by a blank. Error: a
/// surface or text that XML cannot hold.
Result<std::string> svg_model_text(const Drawing& drawing, const SheetPage* page);

/// Start of a layer, as Inkscape has them; `number` makes its element id unique. Nothing is
/// appended on error: a name that XML cannot hold.
Result<void> append_svg_layer_begin(std::string& out, const Layer& layer, std::size_t number);

/// Start of strokes that are in no layer.
void append_svg_group_begin(std::string& out);
/// End of a layer or group.
void append_svg_group_end(std::string& out);

/// One stroke: a filled path that any viewer shows right, with Inkscape's PowerStroke and our own
/// attributes on it. `number` makes the element ids unique. `tolerance_mm` is for the outline; the
/// model is written exactly. Nothing is appended on error: an id or material that XML cannot
/// hold, a coordinate beyond 1e9 mm. With a `mask` the path is seen through it; the path itself is
/// the same. It stands in a layer or group of the functions above.
Result<void> append_svg_stroke(std::string& out, std::string_view id, const Stroke& stroke,
                               std::size_t number, double tolerance_mm,
                               const GrainMask* mask = nullptr);

/// End of the root element.
void append_svg_tail(std::string& out);

/// Path data of an outline in steps: relative commands, whole numbers, so that rounding does not
/// add up. Requires coordinates within 1e9 mm.
void append_path_data(std::string& out, const OutlinePath& path);

}  // namespace felt
