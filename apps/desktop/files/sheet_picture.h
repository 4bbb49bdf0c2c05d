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

/// Strokes as a picture for widgets and the clipboard: `area` in mm, `px_per_mm` of them, on a
/// sheet of that grain. Empty where it would be too large.
QImage sheet_picture(std::span<const StrokePtr> strokes, const Rect& area, double px_per_mm,
                     Rgba paper, const Grain& grain = Grain());

/// The same, as large as fits into `size` pixels.
QImage sheet_thumbnail(std::span<const StrokePtr> strokes, const Rect& area, QSize size, Rgba paper,
                       const Grain& grain = Grain());

/// A picture of the library as one of Qt.
QImage to_qimage(Image image);

}  // namespace felt::desktop
