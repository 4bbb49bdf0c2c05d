#include "desktop/canvas/canvas_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt::desktop {
namespace {

/// Returns the vector turned clockwise. The result is exact for multiples of 90 degrees.
Vec turned(Vec v, double degrees) {
  if (degrees == 0.0) return v;
  if (std::abs(degrees) == 180.0) return -v;
  if (degrees == 90.0) return {-v.y, v.x};
  if (degrees == -90.0) return {v.y, -v.x};
  const double a = degrees * std::numbers::pi / 180.0;
  return {v.x * std::cos(a) - v.y * std::sin(a), v.x * std::sin(a) + v.y * std::cos(a)};
}

}  // namespace

QTransform CanvasView::transform() const {
  QTransform m;
  m.translate(size_.width() / 2, size_.height() / 2);
  m.scale(mirrored_ ? -px_per_mm_ : px_per_mm_, px_per_mm_);
  m.rotate(mirrored_ ? -angle_deg_ : angle_deg_);
  m.translate(-center_.x, -center_.y);
  return m;
}

Point CanvasView::to_mm(QPointF px) const {
  Vec v{(px.x() - size_.width() / 2) / px_per_mm_, (px.y() - size_.height() / 2) / px_per_mm_};
  if (mirrored_) v.x = -v.x;
  return center_ + turned(v, mirrored_ ? angle_deg_ : -angle_deg_);
}

QPointF CanvasView::to_px(Point mm) const {
  Vec v = turned(mm - center_, mirrored_ ? -angle_deg_ : angle_deg_);
  if (mirrored_) v.x = -v.x;
  return {size_.width() / 2 + px_per_mm_ * v.x, size_.height() / 2 + px_per_mm_ * v.y};
}

Rect CanvasView::visible_mm() const {
  Rect all;
  for (const QPointF corner : {QPointF(0, 0), QPointF(size_.width(), 0), QPointF(0, size_.height()),
                               QPointF(size_.width(), size_.height())}) {
    all.extend(to_mm(corner));
  }
  return all;
}

void CanvasView::pan(QPointF px) {
  center_ = to_mm(QPointF(size_.width() / 2, size_.height() / 2) - px);
}

void CanvasView::zoom(double factor, QPointF at) {
  if (!(factor > 0.0)) return;
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
  if (std::isfinite(degrees)) angle_deg_ = std::remainder(degrees, 360.0);
}

void CanvasView::mirror() {
  mirrored_ = !mirrored_;
  set_angle(-angle_deg_);  // a rotation to the left becomes one to the right
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
  if (px_per_mm > 0.0) px_per_mm_ = std::clamp(px_per_mm, kMinPxPerMm, kMaxPxPerMm);
}

}  // namespace felt::desktop
