#include <QLineF>
#include <QPen>
#include <algorithm>
#include <cmath>

#include "desktop/canvas/marks.h"
#include "felt/render/plot.h"
#include "felt/tools/overlay_look.h"

namespace felt::desktop {
namespace {

using Kind = Mark::Kind;

constexpr double kDash = 4.5, kGap = 3.6;
constexpr double kMaxDashedPx = 4000.0;  // a larger ring looks like a straight line, and painting
                                         // its dashes would take long
constexpr double kHaloPx = 1.5;          // width of the halo on each side of a line

QPen halo_pen(double width, const MarkLook& look) {
  return {look.halo(), width + 2 * kHaloPx, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin};
}

QPen role_pen(const Mark& mark, const MarkLook& look) {
  const RoleLook role = look_of(mark.role);
  QPen pen(look.color(mark.role), role.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (role.dashed && mark.size < kMaxDashedPx) {
    pen.setDashPattern({kDash / role.width, kGap / role.width});
    pen.setDashOffset(std::fmod(mark.phase, kDash + kGap) / role.width);
  } else {
    pen.setCapStyle(Qt::RoundCap);
  }
  return pen;
}

/// Paints an arrow with its head at the end of `way`.
void paint_arrow(QPainter& painter, const QLineF& way, QPen pen, const MarkLook& look,
                 double head_px) {
  const QPointF to = way.p2();
  QPolygonF head;
  if (way.length() > 3.0) {
    const double back = std::min(head_px, 0.6 * way.length());
    const QPointF along = QPointF(way.dx(), way.dy()) * (back / way.length());
    const QPointF aside(-0.5 * along.y(), 0.5 * along.x());
    head << to - along + aside << to << to - along - aside;
  }
  pen.setCapStyle(Qt::RoundCap);
  QPen halo = halo_pen(pen.widthF(), look);
  halo.setCapStyle(Qt::RoundCap);
  for (const QPen& each : {halo, pen}) {
    painter.setPen(each);
    painter.drawLine(way);
    if (!head.isEmpty()) painter.drawPolyline(head);
  }
}

void paint_ring(QPainter& painter, const Mark& mark, const MarkLook& look) {
  const RoleLook role = look_of(mark.role);
  if (role.has_halo) {
    painter.setPen(halo_pen(role.width, look));
    painter.drawEllipse(mark.points[0], mark.size, mark.size);
  }
  painter.setPen(role_pen(mark, look));
  painter.drawEllipse(mark.points[0], mark.size, mark.size);
}

void paint_dot(QPainter& painter, const Mark& mark, const MarkLook& look) {
  painter.setPen(QPen(look.halo(), 2 * kHaloPx));
  painter.setBrush(look.color(mark.role));
  painter.drawEllipse(mark.points[0], 3.6, 3.6);
  painter.setPen(QPen(look.plate(), 1.0));
  painter.drawEllipse(mark.points[0], 3.6, 3.6);
}

void paint_label(QPainter& painter, const Mark& mark, const MarkLook& look, const QFont& font) {
  const QRectF plate(mark.points[0], mark.points[1]);
  painter.setPen(QPen(mixed(look.plate(), look.text(), 0.25), 1.0));
  painter.setBrush(look.plate());
  painter.drawRoundedRect(plate.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  painter.setPen(look.text());
  painter.setFont(font);
  painter.drawText(plate, Qt::AlignCenter, mark.text);
}

/// Paints a thin ring with the diameter of the line that would be drawn, and its centre.
void paint_nib(QPainter& painter, const Mark& mark, const MarkLook& look) {
  const QPointF at = mark.points[0];
  if (mark.size > 0.0) {
    const double radius = std::max(mark.size, 2.5);
    painter.setPen(QPen(look.halo(), 3.0));
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(look.text(), 1.0));
    painter.drawEllipse(at, radius, radius);
  }
  painter.setPen(QPen(look.halo(), 1.5));
  painter.setBrush(look.text());
  painter.drawEllipse(at, 1.6, 1.6);
}

void paint_hand(QPainter& painter, const Mark& mark, const MarkLook& look) {
  painter.setPen(halo_pen(1.0, look));
  painter.drawLine(mark.points[0], mark.points[1]);
  painter.setPen(QPen(look.color(mark.role), 1.0));
  painter.drawLine(mark.points[0], mark.points[1]);
  painter.setBrush(look.plate());
  painter.drawEllipse(mark.points[0], 2.0, 2.0);
}

/// Paints a bar that is filled from its foot; it shows how hard the surface pushes the pen out.
void paint_normal(QPainter& painter, const Mark& mark, const MarkLook& look) {
  const QLineF whole(mark.points[0], mark.points[1]);
  QPen pen(look.halo(), 6.0, Qt::SolidLine, Qt::RoundCap);
  painter.setPen(pen);
  painter.drawLine(whole);
  pen.setWidthF(3.0);
  pen.setColor(mixed(look.plate(), look.text(), 0.22));
  painter.setPen(pen);
  painter.drawLine(whole);
  pen.setColor(look.force());
  painter.setPen(pen);
  painter.drawLine(whole.p1(), whole.p1() - QPointF(0, std::abs(mark.size)));
}

}  // namespace

QColor mixed(QColor a, QColor b, double share_of_b) {
  const auto mix = [share_of_b](int x, int y) { return qRound(x + share_of_b * (y - x)); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

MarkLook::MarkLook(QColor paper) : paper_(paper) {
  const QColor over = mixed(Qt::white, paper_, static_cast<double>(paper_.alphaF()));
  paper_ = over;
  on_dark_ = qGray(over.rgb()) < 110;
  halo_ = on_dark_ ? QColor(0, 0, 0, 150) : QColor(255, 255, 255, 190);
  plate_ = on_dark_ ? QColor(44, 46, 52) : QColor(255, 255, 255);
  text_ = on_dark_ ? QColor(236, 236, 240) : QColor(28, 28, 32);
}

QColor MarkLook::seen(std::size_t palette_index) const {
  const Rgba c = plot_color(palette_index);
  const QColor color(c.r, c.g, c.b);
  return on_dark_ ? mixed(color, Qt::white, 0.35) : color;
}

QColor MarkLook::color(Overlay::Role role) const {
  return seen(look_of(role).color);
}

QColor MarkLook::band(Overlay::Role role) const {
  return mixed(paper_, seen(look_of(role).color), 0.45);
}

QColor MarkLook::force() const {
  return seen(1);
}

void paint_mark(QPainter& painter, const Mark& mark, const MarkLook& look, const QFont& font) {
  painter.setBrush(Qt::NoBrush);
  switch (mark.kind) {
    case Kind::kLines:
      if (look_of(mark.role).has_halo) {
        painter.setPen(halo_pen(look_of(mark.role).width, look));
        painter.drawPolyline(mark.points);
      }
      painter.setPen(role_pen(mark, look));
      painter.drawPolyline(mark.points);
      return;
    case Kind::kArrow:
      return paint_arrow(painter, {mark.points[0], mark.points[1]}, role_pen(mark, look), look,
                         9.0);
    case Kind::kForce:
      return paint_arrow(painter, {mark.points[0], mark.points[1]}, QPen(look.force(), 2.0), look,
                         8.0);
    case Kind::kRing:
      return paint_ring(painter, mark, look);
    case Kind::kDot:
      return paint_dot(painter, mark, look);
    case Kind::kLabel:
      return paint_label(painter, mark, look, font);
    case Kind::kNib:
      return paint_nib(painter, mark, look);
    case Kind::kHand:
      return paint_hand(painter, mark, look);
    case Kind::kNormal:
      return paint_normal(painter, mark, look);
  }
}

}  // namespace felt::desktop
