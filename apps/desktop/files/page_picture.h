#pragma once

#include <QImage>
#include <span>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/geometry/rect.h"
#include "felt/render/grain.h"
#include "felt/render/image.h"
#include "felt/stroke/stroke.h"

namespace felt::desktop {

/// Draws strokes as a picture for widgets and the clipboard. The picture shows `area` (in mm) at
/// `px_per_mm`, on a surface with this grain. Returns an empty picture if the picture would be too
/// large.
QImage page_picture(std::span<const StrokePtr> strokes, const Rect& area, double px_per_mm,
                    Rgba paper, const Grain& grain = Grain());

/// Draws the same picture, as large as possible within `size` pixels.
QImage page_thumbnail(std::span<const StrokePtr> strokes, const Rect& area, QSize size, Rgba paper,
                      const Grain& grain = Grain());

/// Converts a picture of the library to a QImage.
QImage to_qimage(Image image);

}  // namespace felt::desktop
