#include "desktop/materials/stroke_preview.h"

#include <QPainter>

#include "desktop/feel/material_words.h"

namespace felt::desktop {

StrokePreview::StrokePreview(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Three strokes: light, firm, hard"));
  worker_.setMaxThreadCount(1);
  wanted_.forces.assign(kForces.begin(), kForces.end());
}

StrokePreview::~StrokePreview() = default;

QSize StrokePreview::sizeHint() const {
  return {280, 120};
}

QSize StrokePreview::minimumSizeHint() const {
  return {200, 90};
}

void StrokePreview::show_medium(const Medium& medium, const SurfaceMaterial& surface) {
  wanted_.medium = medium;
  wanted_.surface = surface;
  wanted_.paper = QColor::fromRgb(surface.color_rgb & 0xFFFFFFU);
  wanted_.ink = readable_ink(QColor::fromRgb(medium.color_rgb & 0xFFFFFFU), wanted_.paper);
  setAccessibleDescription(tr("%1 on %2").arg(medium_label(medium), material_label(surface)));
  setToolTip(accessibleDescription());
  has_wish_ = true;
  draw();
}

void StrokePreview::draw() {
  if (!has_wish_ || size().isEmpty()) return;
  wanted_.size = size();
  wanted_.dpr = devicePixelRatioF();
  is_stale_ = is_busy_;
  if (is_busy_) return;
  is_busy_ = true;
  worker_.start([this, request = wanted_] {
    const QImage picture = draw_medium(request);
    QMetaObject::invokeMethod(
        this,
        [this, picture] {
          is_busy_ = false;
          picture_ = picture;
          update();
          if (is_stale_) {
            draw();
          } else {
            Q_EMIT drawn();
          }
        },
        Qt::QueuedConnection);
  });
}

void StrokePreview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  draw();
}

void StrokePreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), wanted_.paper);
  if (!picture_.isNull()) painter.drawImage(rect(), picture_);
  QColor edge = palette().color(QPalette::Text);
  edge.setAlphaF(0.35F);
  painter.setPen(edge);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace felt::desktop
