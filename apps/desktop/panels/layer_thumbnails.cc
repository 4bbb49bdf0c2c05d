#include "desktop/panels/layer_thumbnails.h"

#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "felt/render/page_painter.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

constexpr int kDelayMs = 400;
constexpr int kPictureSide = 128;
/// A usual line covers a fifteenth of a pixel of such a small picture. Ink is shown as if it lay in
/// so many layers one over the other, at least and at most, and between these in so many that the
/// darkest pixel has kDarkest.
constexpr double kMinLayers = 12.0, kMaxLayers = 100.0, kDarkest = 0.75;

/// Makes pale ink visible. Opaque ink and the colours stay.
void darken(QImage& ink) {
  int most = 0;
  for (int y = 0; y < ink.height(); ++y) {
    const uchar* byte = ink.constScanLine(y);
    for (int x = 0; x < ink.width(); ++x) most = std::max<int>(most, byte[4 * x + 3]);
  }
  const double clear = std::clamp(1.0 - most / 255.0, 1e-3, 1.0 - 1e-3);
  const double layers =
      std::clamp(std::log(1.0 - kDarkest) / std::log(clear), kMinLayers, kMaxLayers);
  for (int y = 0; y < ink.height(); ++y) {
    uchar* byte = ink.scanLine(y);
    for (int x = 0; x < ink.width(); ++x, byte += 4) {
      if (byte[3] == 0 || byte[3] == 255) continue;
      const double alpha = byte[3] / 255.0;
      const double gain = (1.0 - std::pow(1.0 - alpha, layers)) / alpha;
      for (int i = 0; i < 4; ++i) byte[i] = static_cast<uchar>(std::min(gain * byte[i], 255.0));
    }
  }
}

/// Calls `use` with all indices below `count`, or with at most kMaxShown that are spread evenly.
template <class Use>
void for_some(std::size_t count, Use use) {
  const std::size_t step = (count + LayerThumbnails::kMaxShown - 1) / LayerThumbnails::kMaxShown;
  for (std::size_t i = 0; i < count; i += step) use(i);
}

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
  for (const FillChange& c : edit.fills) {
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

/// Returns the fills and strokes of a layer, or a null image if they cannot be drawn.
QImage LayerThumbnails::ink_of(const Layer& layer, double px_per_mm) const {
  const Document& document = studio_.session().document();
  Result<PagePainter> page =
      PagePainter::create({}, {.dpi = px_per_mm * kMmPerInch,
                               .area = studio_.page().area(),
                               .paper = {255, 255, 255, 0},
                               .grain = Grain::solid(studio_.session().materials())});
  if (!page) return {};
  const Pixels pixels = page->image().pixels();
  Rasterizer rasterizer;
  for_some(layer.fills.size(), [&](std::size_t i) {
    rasterizer.draw_fill(*document.find_fill(layer.fills[i]), page->view(), pixels.rect(), pixels);
  });
  for_some(layer.strokes.size(),
           [&](std::size_t i) { page->draw(*document.find(layer.strokes[i])); });
  return QImage(pixels.data, pixels.width, pixels.height, static_cast<qsizetype>(pixels.stride),
                QImage::Format_RGBA8888_Premultiplied)
      .copy();
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
  if (QImage ink = ink_of(layer, scale); !ink.isNull()) {
    darken(ink);
    painter.drawImage(0, 0, ink);
  }
  painter.end();
  pixmap.setDevicePixelRatio(ratio);
  return pixmap;
}

}  // namespace felt::desktop
