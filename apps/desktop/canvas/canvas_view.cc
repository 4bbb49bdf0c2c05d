#include "desktop/canvas/canvas_view.h"

#include <algorithm>
#include <cmath>

namespace felt::desktop {

QTransform CanvasView::transform() const {
  QTransform m;
  m.translate(size_.width() / 2, size_.height() / 2);
  m.scale(mirrored_ ? -px_per_mm_ : px_per_mm_, px_per_mm_);
  m.rotate(mirrored_ ? -angle_deg_ : angle_deg_);
  m.translate(-center_.x, -center_.y);
  return m;
}

Point CanvasView::to_mm(QPointF px) const {
  const QPointF mm = transform().inverted().map(px);
  return {mm.x(), mm.y()};
}

QPointF CanvasView::to_px(Point mm) const {
  return transform().map(QPointF(mm.x, mm.y));
}

Rect CanvasView::visible_mm() const {
  const QRectF all = transform().inverted().mapRect(QRectF({0, 0}, size_));
  return {all.left(), all.top(), all.right(), all.bottom()};
}

void CanvasView::pan(QPointF px) {
  center_ = to_mm(QPointF(size_.width() / 2, size_.height() / 2) - px);
}

void CanvasView::zoom(double factor, QPointF at) {
  const Point fixed = to_mm(at);
  set_scale(px_per_mm_ * factor);
  pan(at - to_px(fixed));
}

void CanvasView::turn(double degrees, QPointF at) {
  const Point fixed = to_mm(at);
  set_angle(angle_deg_ + degrees);
  pan(at - to_px(fixed));
}

void CanvasView::set_angle(double degrees) {
  angle_deg_ = std::remainder(degrees, 360.0);
}

void CanvasView::mirror() {
  mirrored_ = !mirrored_;
}

void CanvasView::fit(const Rect& mm, double margin_px) {
  if (mm.empty()) return;
  center_ = {(mm.x0 + mm.x1) / 2, (mm.y0 + mm.y1) / 2};
  QTransform turned;
  turned.rotate(angle_deg_);
  const QRectF box = turned.mapRect(QRectF(mm.x0, mm.y0, mm.width(), mm.height()));
  const double width = std::max(1.0, size_.width() - 2 * margin_px);
  const double height = std::max(1.0, size_.height() - 2 * margin_px);
  set_scale(std::min(width / std::max(box.width(), 1e-6), height / std::max(box.height(), 1e-6)));
}

void CanvasView::set_scale(double px_per_mm) {
  px_per_mm_ = std::clamp(px_per_mm, kLeastPxPerMm, kMostPxPerMm);
}

}  // namespace felt::desktop
