#include "desktop/files/page_picture.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/render/page_painter.h"
#include "felt/render/view.h"

namespace felt::desktop {

QImage to_qimage(Image image) {
  auto* kept = new Image(std::move(image));
  const Pixels pixels = kept->pixels();
  return QImage(
      pixels.data, pixels.width, pixels.height, pixels.stride,
      QImage::Format_RGBA8888_Premultiplied, [](void* held) { delete static_cast<Image*>(held); },
      kept);
}

QImage page_picture(std::span<const StrokePtr> strokes, const Rect& area, double px_per_mm,
                    Rgba paper, const Grain& grain) {
  Result<Image> image = render_page(
      strokes, {.dpi = px_per_mm * kMmPerInch, .area = area, .paper = paper, .grain = grain});
  return image ? to_qimage(*std::move(image)) : QImage();
}

QImage page_thumbnail(std::span<const StrokePtr> strokes, const Rect& area, QSize size, Rgba paper,
                      const Grain& grain) {
  if (!(area.width() > 0.0) || !(area.height() > 0.0)) return {};
  const double scale = std::min(size.width() / area.width(), size.height() / area.height());
  return page_picture(strokes, area, scale, paper, grain);
}

}  // namespace felt::desktop
