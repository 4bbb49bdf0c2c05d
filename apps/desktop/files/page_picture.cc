#include "desktop/files/page_picture.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/document/edit_builder.h"
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

QImage page_picture(const Document& document, const Rect& area, double px_per_mm, Rgba paper,
                    const Grain& grain, PictureChoice pictures) {
  Result<Image> image = render_page(
      document, {.dpi = px_per_mm * kMmPerInch, .area = area, .paper = paper, .grain = grain},
      pictures);
  return image ? to_qimage(*std::move(image)) : QImage();
}

QImage page_thumbnail(const Document& document, const Rect& area, QSize size, Rgba paper,
                      const Grain& grain, PictureChoice pictures) {
  if (!(area.width() > 0.0) || !(area.height() > 0.0)) return {};
  const double scale = std::min(size.width() / area.width(), size.height() / area.height());
  return page_picture(document, area, scale, paper, grain, pictures);
}

Document with_newest_strokes(Document document, std::size_t max) {
  if (document.stroke_count() <= max) return document;
  std::size_t extra = document.stroke_count() - max;
  EditBuilder builder(document);
  for (const Layer& layer : document.layers()) {
    const std::size_t count = std::min(extra, layer.strokes.size());
    for (std::size_t i = 0; i < count; ++i) builder.remove(layer.strokes[i]);
    extra -= count;
  }
  const Edit edit = std::move(builder).build("Remove");
  return document.apply(edit) ? document : Document();
}

}  // namespace felt::desktop
