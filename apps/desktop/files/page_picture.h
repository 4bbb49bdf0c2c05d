#pragma once

#include <QImage>
#include <cstddef>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/geometry/rect.h"
#include "felt/render/grain.h"
#include "felt/render/image.h"

namespace felt::desktop {

/// Draws the visible layers of a document as a picture for widgets and the clipboard. The picture
/// shows `area` (in mm) at `px_per_mm`, on a surface with this grain. Returns an empty picture if
/// the picture would be too large, or if a picture of a layer is damaged.
QImage page_picture(const Document& document, const Rect& area, double px_per_mm, Rgba paper,
                    const Grain& grain = Grain(), PictureChoice pictures = PictureChoice::kMarked);

/// Draws the same picture, as large as possible within `size` pixels.
QImage page_thumbnail(const Document& document, const Rect& area, QSize size, Rgba paper,
                      const Grain& grain = Grain(),
                      PictureChoice pictures = PictureChoice::kMarked);

/// Returns the document without its lowest strokes, if it has more than `max` of them. For small
/// pictures, which must not take long.
Document with_newest_strokes(Document document, std::size_t max);

/// Converts a picture of the library to a QImage.
QImage to_qimage(Image image);

}  // namespace felt::desktop
