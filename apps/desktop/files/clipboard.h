#pragma once

#include <QMimeData>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/geometry/rect.h"
#include "felt/io/import.h"

namespace felt::desktop {

/// MIME type of Feltline's own strokes on the clipboard: lines of .ndjson, without loss.
inline constexpr const char* kStrokesMime = "application/x-feltline-strokes";
/// MIME type of the media that the strokes use and that Feltline does not ship: the texts of these
/// media as a JSON array of strings. It is added to kStrokesMime if needed.
inline constexpr const char* kMaterialsMime = "application/x-feltline-materials";

/// Returns clipboard data for the visible strokes of a drawing and its materials. The data has
/// Feltline's own types, image/svg+xml, and a picture at 300 dots per inch (fewer if the picture
/// would be very large). SVG and picture are made on request.
std::unique_ptr<QMimeData> strokes_mime(Drawing drawing);
/// Returns SVG or picture alone, for programs that would otherwise choose the wrong one.
std::unique_ptr<QMimeData> svg_mime(const Drawing& drawing);
std::unique_ptr<QMimeData> png_mime(const Drawing& drawing);

/// Reads a clipboard: Feltline's own strokes, otherwise SVG, InkML or lines of JSON of any
/// program, by their types or as text. Returns an empty drawing if the clipboard has none of them.
/// The texts of materials are not checked and may be invalid. Fails if the data is damaged.
Result<Imported> drawing_of(const QMimeData& data);

/// Returns the area that this ink covers, with a margin of 1 mm.
Rect ink_area(const Rect& ink);

}  // namespace felt::desktop
