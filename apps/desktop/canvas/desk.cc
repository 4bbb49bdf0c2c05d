#include "desktop/canvas/desk.h"

#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <array>

namespace felt::desktop {
namespace {

constexpr double kShadowDownPx = 2.0;
constexpr std::array<double, 8> kShadowPx{2, 4, 7, 10, 13, 16, 19, 22};  // line widths of the
                                                                         // outlines that together
                                                                         // form the shadow
constexpr int kShadowAlpha = 6;                                          // alpha of each layer

}  // namespace

void Desk::set_palette(const QPalette& palette) {
  const QColor window = palette.color(QPalette::Window);
  is_dark_ = window.lightness() < 128;
  color_ = is_dark_ ? window.darker(130) : window.darker(112);
}

QColor Desk::paper() const {
  const Rgba& p = page_.paper;
  const auto over = [&p](int c) { return (c * p.a + 255 * (255 - p.a)) / 255; };
  return {over(p.r), over(p.g), over(p.b)};
}

void Desk::paint(QPainter& painter, const QRect& part, const CanvasView& view) const {
  QPolygonF page;
  for (const Point p : {Point{0, 0}, Point{page_.width_mm, 0},
                        Point{page_.width_mm, page_.height_mm}, Point{0, page_.height_mm}}) {
    page << view.to_px(p);
  }
  const Rect inner = page_.area().inflated(-2.0 / view.px_per_mm());
  const QRectF all(part);
  const auto is_inside = [&](QPointF px) { return inner.contains(view.to_mm(px)); };
  if (is_inside(all.topLeft()) && is_inside(all.topRight()) && is_inside(all.bottomLeft()) &&
      is_inside(all.bottomRight())) {
    painter.fillRect(part, paper());
    return;
  }
  painter.fillRect(part, color_);
  const double reach = kShadowPx.back() + kShadowDownPx;
  if (!page.boundingRect().adjusted(-reach, -reach, reach, reach).intersects(all)) return;
  paint_edge(painter, page);
  painter.setPen(Qt::NoPen);
  painter.setBrush(paper());
  painter.drawPolygon(page);
}

/// Paints a shadow that fades outwards. In a dark theme, also paints a hairline, because the paper
/// may have the colour of the background.
void Desk::paint_edge(QPainter& painter, const QPolygonF& page) const {
  painter.setBrush(Qt::NoBrush);
  const QPolygonF below = page.translated(0, kShadowDownPx);
  for (const double width : kShadowPx) {
    QPen pen(QColor(0, 0, 0, is_dark_ ? 2 * kShadowAlpha : kShadowAlpha), width);
    pen.setJoinStyle(Qt::RoundJoin);
    painter.setPen(pen);
    painter.drawPolygon(below);
  }
  const QColor line = is_dark_ ? QColor(255, 255, 255, 40) : QColor(0, 0, 0, 40);
  painter.setPen(QPen(line, 2.0));
  painter.drawPolygon(page);
}

}  // namespace felt::desktop
