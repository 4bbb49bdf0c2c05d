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
/// media as a JSON array of strings. The clipboard has this type only if the strokes use such
/// media.
inline constexpr const char* kMaterialsMime = "application/x-feltline-materials";

/// Returns clipboard data for the visible strokes of a drawing and its materials. The data has
/// Feltline's own types, image/svg+xml, and a picture at 300 dots per inch (fewer if the picture
/// would be very large). The SVG and the picture are made only when a program requests them.
std::unique_ptr<QMimeData> strokes_mime(Drawing drawing);
/// These functions return data with only the SVG or only the picture, for programs that would
/// otherwise choose the wrong type.
std::unique_ptr<QMimeData> svg_mime(const Drawing& drawing);
std::unique_ptr<QMimeData> png_mime(const Drawing& drawing);

/// Reads a drawing from a clipboard: Feltline's own strokes if there are any, otherwise SVG, InkML
/// or lines of JSON from any program. These are recognised by their MIME types or, in plain text,
/// by their content. Returns an empty drawing if the clipboard contains none of these. The texts of
/// materials are not checked and may be invalid. Fails if the data is damaged.
Result<Imported> drawing_of(const QMimeData& data);

/// Returns `ink`, the bounds of the ink, enlarged by 1 mm on each side.
Rect ink_area(const Rect& ink);

}  // namespace felt::desktop
