#include <QFontMetricsF>
#include <QLineF>
#include <QRegion>
#include <algorithm>
#include <cmath>
#include <optional>

#include "desktop/canvas/marks.h"

namespace felt::desktop {
namespace {

using Kind = Mark::Kind;

constexpr int kPointsOfAPart = 24;  // a long line is split into parts, which are compared and
                                    // painted separately
constexpr double kAroundPx = 4.0;   // margin around a mark's points for halo, line width and edges
constexpr double kBeyondPx = 64.0;  // margin around the widget; marks beyond it are not visible
constexpr double kDotPx = 7.0;
constexpr double kPlateGapPx = 10.0;
constexpr double kPlatePadPx = 4.0;
constexpr double kArrowPx = 46.0;    // length of the arrow for an infinite force
constexpr double kArrowHalfN = 0.7;  // the force for which the arrow has half that length
constexpr double kMinForceN = 0.02;  // smaller forces are not shown
constexpr double kBarPx = 26.0;
constexpr double kBarAsidePx = 15.0;

QRect around(const QPolygonF& points, double margin) {
  return points.boundingRect().adjusted(-margin, -margin, margin, margin).toAlignedRect();
}

/// Returns the part of a line within a rectangle (Liang and Barsky).
std::optional<QLineF> clipped(const QLineF& line, const QRectF& in) {
  double t0 = 0.0, t1 = 1.0;
  const double dx = line.dx(), dy = line.dy();
  const double sides[4][2] = {{-dx, line.x1() - in.left()},
                              {dx, in.right() - line.x1()},
                              {-dy, line.y1() - in.top()},
                              {dy, in.bottom() - line.y1()}};
  for (const auto& [way, room] : sides) {
    if (way == 0.0 && room < 0.0) return std::nullopt;
    if (way < 0.0) t0 = std::max(t0, room / way);
    if (way > 0.0) t1 = std::min(t1, room / way);
  }
  if (!(t0 <= t1)) return std::nullopt;
  return QLineF(line.pointAt(t0), line.pointAt(t1));
}

class Lister {
 public:
  Lister(const CanvasView& view, const QFont& font, Marks& marks)
      : view_(view),
        metrics_(font),
        widget_(QPointF(0, 0), view.size()),
        seen_(widget_.adjusted(-kBeyondPx, -kBeyondPx, kBeyondPx, kBeyondPx)),
        marks_(marks) {}

  void outline(const Overlay::Outline& outline) {
    QPolygonF points;
    for (const Point& p : outline.points) points << view_.to_px(p);
    if (outline.closed && points.size() > 1) points << points.front();
    lines(points, outline.role);
  }
  void ring(const Overlay::Ring& ring) {
    const QPointF center = view_.to_px(ring.center);
    const double radius = ring.radius_mm * view_.px_per_mm();
    const QRectF box(center - QPointF(radius, radius), center + QPointF(radius, radius));
    if (!box.intersects(seen_)) return;
    Mark mark{Kind::kRing, ring.role, {center}, radius};
    mark.box = box.adjusted(-kAroundPx, -kAroundPx, kAroundPx, kAroundPx).toAlignedRect();
    marks_.push_back(mark);
  }
  void line(const Overlay::Line& line) {
    const QPointF from = view_.to_px(line.from), to = view_.to_px(line.to);
    if (line.role != Overlay::Role::kVector) return lines({from, to}, line.role);
    if (!clipped({from, to}, seen_)) return;
    Mark mark{Kind::kArrow, line.role, {from, to}};
    mark.box = around(mark.points, kAroundPx + 8.0).intersected(seen_.toAlignedRect());
    marks_.push_back(mark);
  }
  void dot(const Overlay::Dot& dot) {
    const QPointF at = view_.to_px(dot.at);
    if (!seen_.contains(at)) return;
    Mark mark{Kind::kDot, dot.role, {at}};
    mark.box = around(mark.points, kDotPx);
    marks_.push_back(mark);
  }
  /// Places a label beside its point, on the side on which the widget has space.
  void label(const Overlay::Label& label) {
    const QPointF at = view_.to_px(label.at);
    if (!seen_.contains(at)) return;
    const QString text = QString::fromStdString(label.text);
    const QSizeF size(std::ceil(metrics_.horizontalAdvance(text)) + 2 * kPlatePadPx + 2,
                      std::ceil(metrics_.height()) + kPlatePadPx);
    QPointF corner = at + QPointF(kPlateGapPx, -kPlateGapPx - size.height());
    if (corner.x() + size.width() > widget_.right())
      corner.rx() = at.x() - kPlateGapPx - size.width();
    if (corner.y() < 0) corner.ry() = at.y() + kPlateGapPx;
    corner = {std::round(corner.x()), std::round(corner.y())};
    Mark mark{Kind::kLabel, {}, {corner, corner + QPointF(size.width(), size.height())}};
    mark.text = text;
    mark.box = around(mark.points, 2.0);
    marks_.push_back(mark);
  }

 private:
  /// Adds the visible part of a line in pieces, each with the phase of its dashes. Therefore a
  /// growing long line is repainted only at its end, and the dashes of the invisible part of a
  /// line are not computed.
  void lines(const QPolygonF& points, Overlay::Role role) {
    Mark part{Kind::kLines, role, {}};
    double length = 0.0;
    const auto flush = [&] {
      if (part.points.size() < 2) return;
      part.box = around(part.points, kAroundPx);
      marks_.push_back(part);
      part.points.clear();
    };
    for (qsizetype i = 0; i + 1 < points.size(); ++i) {
      const QLineF whole(points[i], points[i + 1]);
      const std::optional<QLineF> shown = clipped(whole, seen_);
      if (shown && shown->p1() == whole.p1() && !part.points.empty()) {
        part.points << shown->p2();
      } else {
        flush();
        part.points.clear();
        if (shown) {
          part.points << shown->p1() << shown->p2();
          part.phase = length + QLineF(whole.p1(), shown->p1()).length();
        }
      }
      length += whole.length();
      if (part.points.size() >= kPointsOfAPart) {
        const QPointF last = part.points.back();
        flush();
        part.points = {last};
        part.phase = length;
      }
      if (shown && shown->p2() != whole.p2()) flush();
    }
    flush();
  }

  const CanvasView& view_;
  QFontMetricsF metrics_;
  QRectF widget_, seen_;
  Marks& marks_;
};

}  // namespace

void list_overlay(const Overlay& overlay, const CanvasView& view, const QFont& font, Marks& marks) {
  Lister list(view, font, marks);
  for (const auto& outline : overlay.outlines) list.outline(outline);
  for (const auto& ring : overlay.rings) list.ring(ring);
  for (const auto& line : overlay.lines) list.line(line);
  for (const auto& dot : overlay.dots) list.dot(dot);
  for (const auto& label : overlay.labels) list.label(label);
}

void list_pen(const PenMark& pen, Marks& marks) {
  const auto add = [&marks](Mark mark, double margin) {
    mark.box = around(mark.points, margin);
    marks.push_back(std::move(mark));
  };
  if (QLineF(pen.hand, pen.nib).length() > 1.0) {
    add({Kind::kHand, Overlay::Role::kTether, {pen.hand, pen.nib}}, kAroundPx);
  }
  const double strength = std::hypot(pen.force_n.x(), pen.force_n.y());
  if (strength > kMinForceN) {
    const double length = kArrowPx * strength / (strength + kArrowHalfN);
    const QPointF way = pen.force_n * (length / strength);
    add({Kind::kForce, Overlay::Role::kVector, {pen.nib, pen.nib + way}}, 8.0);
  }
  if (std::abs(pen.out_n) > kMinForceN) {
    const double height = kBarPx * pen.out_n / (std::abs(pen.out_n) + kArrowHalfN);
    const QPointF foot = pen.nib + QPointF(kBarAsidePx, kBarPx / 2);
    add({Kind::kNormal, Overlay::Role::kVector, {foot, foot - QPointF(0, kBarPx)}, height}, 5.0);
  }
  Mark nib{Kind::kNib, Overlay::Role::kHandle, {pen.nib}, pen.radius};
  add(nib, std::max(pen.radius, 5.0) + kAroundPx);
}

void add_difference(const Marks& before, const Marks& after, QRegion& region) {
  const auto heads = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  auto old_end = before.end(), new_end = after.end();
  while (old_end != heads.first && new_end != heads.second && *(old_end - 1) == *(new_end - 1)) {
    --old_end;
    --new_end;
  }
  constexpr std::ptrdiff_t kMaxRects = 12;
  const auto add = [&region](auto from, auto to) {
    QRect all;
    for (auto mark = from; mark != to; ++mark) {
      if (to - from <= kMaxRects) region += mark->box;
      all |= mark->box;
    }
    if (to - from > kMaxRects) region += all;
  };
  add(heads.first, old_end);
  add(heads.second, new_end);
}

}  // namespace felt::desktop
