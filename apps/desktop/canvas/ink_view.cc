#include "desktop/canvas/ink_view.h"

#include <QImage>

#include "felt/render/raster.h"

namespace felt::desktop {

struct InkView::State {
  Document document;
  std::optional<Edit> preview;
  CanvasView view;
  double dpr = 1.0;
  Rasterizer rasterizer;
};

InkView::InkView(QObject* parent) : QObject(parent), state_(std::make_unique<State>()) {}
InkView::~InkView() = default;

void InkView::set_document(const Document& document) {
  state_->document = document;
  Q_EMIT changed({});
}

void InkView::apply(const Edit& edit) {
  static_cast<void>(state_->document.apply(edit));
  Q_EMIT changed({});
}

void InkView::show(const std::optional<Edit>& preview) {
  if (!preview && !state_->preview) return;
  state_->preview = preview;
  Q_EMIT changed({});
}

void InkView::set_view(const CanvasView& view, double dpr) {
  state_->view = view;
  state_->dpr = dpr;
}

void InkView::set_grain(const Grain&) {}
void InkView::set_outline_mode(bool) {}
bool InkView::is_up_to_date() const {
  return true;
}
void InkView::finish() {}

void InkView::paint(QPainter& painter, const QRect& part) {
  Document seen = state_->document;
  if (state_->preview) static_cast<void>(seen.apply(*state_->preview));
  QImage image(part.size() * state_->dpr, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  image.setDevicePixelRatio(state_->dpr);
  const Pixels pixels{image.bits(), image.width(), image.height(), image.bytesPerLine(),
                      PixelOrder::kBgra};
  const View view{state_->view.to_mm(part.topLeft()), state_->view.px_per_mm() * state_->dpr};
  for (const Layer& layer : seen.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      state_->rasterizer.draw(*seen.find(id), view, pixels.rect(), pixels);
    }
  }
  painter.drawImage(part.topLeft(), image);
}

}  // namespace felt::desktop
