#include "desktop/panels/layer_thumbnails.h"

#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <vector>

#include "felt/render/page_painter.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

constexpr int kDelayMs = 400;
constexpr int kPictureSide = 128;

}  // namespace

LayerThumbnails::LayerThumbnails(Studio& studio, QObject* parent)
    : QObject(parent), studio_(studio) {
  timer_.setSingleShot(true);
  timer_.setInterval(kDelayMs);
  connect(&timer_, &QTimer::timeout, this, &LayerThumbnails::paint_now);
  connect(&studio, &Studio::edited, this, &LayerThumbnails::follow);
  connect(&studio, &Studio::opened, this, &LayerThumbnails::forget_all);
  forget_all();
}

QPixmap LayerThumbnails::of(LayerId layer) const {
  const auto found = pixmaps_.find(layer);
  return found == pixmaps_.end() ? QPixmap() : found->second;
}

void LayerThumbnails::follow(const Edit& edit) {
  for (const LayerChange& c : edit.layers) dirty_.insert(c.id);
  for (const StrokeChange& c : edit.changes) {
    if (c.before) dirty_.insert(c.before_place.layer);
    if (c.after) dirty_.insert(c.after_place.layer);
  }
  timer_.start();
}

void LayerThumbnails::forget_all() {
  pixmaps_.clear();
  for (const Layer& layer : studio_.session().document().layers()) dirty_.insert(layer.id);
  timer_.start();
}

void LayerThumbnails::paint_now() {
  timer_.stop();
  const Document& document = studio_.session().document();
  for (const LayerId id : dirty_) {
    const Layer* layer = document.layer(id);
    if (layer) pixmaps_[id] = paint(*layer);
    if (!layer) pixmaps_.erase(id);
  }
  dirty_.clear();
  std::erase_if(pictures_, [&](const auto& entry) {
    const auto layers = document.layers();
    return std::none_of(layers.begin(), layers.end(), [&](const Layer& l) {
      return l.picture && l.picture->data == entry.first;
    });
  });
  Q_EMIT painted();
}

QPixmap LayerThumbnails::paint(const Layer& layer) {
  const Page& page = studio_.page();
  const double ratio = qGuiApp->devicePixelRatio();
  const double scale =
      ratio * std::min(kSize.width() / page.width_mm, kSize.height() / page.height_mm);
  const QSize size = (QSizeF(page.width_mm, page.height_mm) * scale).toSize().expandedTo({1, 1});
  QPixmap pixmap(size);
  pixmap.fill(QColor(page.paper.r, page.paper.g, page.paper.b));
  QPainter painter(&pixmap);
  if (layer.picture) {
    QImage& small = pictures_[layer.picture->data];
    const std::string& png = layer.picture->data->png;
    if (small.isNull() && small.loadFromData(QByteArray::fromRawData(
                              png.data(), static_cast<qsizetype>(png.size())))) {
      small =
          small.scaled(kPictureSide, kPictureSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    }
    const Affine& m = layer.picture->place;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(QTransform(m.a, m.b, m.c, m.d, m.e, m.f) *
                         QTransform::fromScale(scale, scale));
    painter.drawImage(QRectF(0, 0, layer.picture->data->width_px, layer.picture->data->height_px),
                      small);
    painter.resetTransform();
  }
  std::vector<StrokePtr> strokes;
  const std::size_t count = layer.strokes.size();
  for (std::size_t i = count - std::min(count, kMaxStrokes); i < count; ++i) {
    strokes.push_back(studio_.session().document().find(layer.strokes[i]));
  }
  Result<Image> ink = render_page(strokes, {.dpi = scale * kMmPerInch,
                                            .area = page.area(),
                                            .paper = {255, 255, 255, 0},
                                            .grain = Grain::solid(studio_.session().materials())});
  if (ink) {
    const Pixels pixels = ink->pixels();
    painter.drawImage(
        0, 0,
        QImage(pixels.data, pixels.width, pixels.height, static_cast<qsizetype>(pixels.stride),
               QImage::Format_RGBA8888_Premultiplied));
  }
  painter.end();
  pixmap.setDevicePixelRatio(ratio);
  return pixmap;
}

}  // namespace felt::desktop
