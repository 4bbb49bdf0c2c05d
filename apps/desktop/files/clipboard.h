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

/// Type of our own strokes on the clipboard: lines of .ndjson, exact.
inline constexpr const char* kStrokesMime = "application/x-feltline-strokes";
/// Beside it, where they are of media that Feltline does not bring: the texts of these media, an
/// array of strings of JSON.
inline constexpr const char* kMaterialsMime = "application/x-feltline-materials";

/// Puts the visible strokes of a drawing and its materials on the clipboard: in our own types, as
/// image/svg+xml and as a picture at 300 dots per inch (less if that would be a very large one).
/// The last two are made when somebody asks for them.
std::unique_ptr<QMimeData> strokes_mime(Drawing drawing);
/// One of the two alone, for programs that choose the wrong one.
std::unique_ptr<QMimeData> svg_mime(const Drawing& drawing);
std::unique_ptr<QMimeData> png_mime(const Drawing& drawing);

/// Reads a clipboard: our own strokes, else SVG, InkML or lines of JSON of any program, by their
/// types or as text. Returns an empty drawing if it has none of them. Nobody vouches for the texts
/// of materials: one may say no material. Error: it is damaged.
Result<Imported> drawing_of(const QMimeData& data);

/// Returns the area that this ink covers, with a margin of a millimetre.
Rect ink_area(const Rect& ink);

}  // namespace felt::desktop
