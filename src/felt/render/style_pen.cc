#include "felt/render/style_pen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

namespace felt {
namespace {

/// Shapes are flattened with at most this many lines for each curve.
constexpr int kMaxShapeSteps = 64;
/// A point of a rail is inside a bend if its distance from the centre line is below this share of
/// the rail's offset. Rounding and flattening stay far below the rest.
constexpr double kOffsetShare = 0.98;
/// Points of the centre line that are compared with a point of a rail.
constexpr std::size_t kMaxCompared = 96;
/// Largest number of times that lines of a hatching enter or leave the area.
constexpr double kMaxCrossings = 65'536.0;

double area_of(std::span<const Point> contour) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const Point a = contour[i], b = contour[(i + 1) % contour.size()];
    sum +=
        (a.x - contour[0].x) * (b.y - contour[0].y) - (b.x - contour[0].x) * (a.y - contour[0].y);
  }
  return 0.5 * sum;
}

void append(Outline& to, const Outline& from) {
  const std::size_t size = to.points.size();
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (const std::size_t end : from.ends) to.ends.push_back(size + end);
}

/// Turns all contours around. The order of the contours does not matter.
void reverse(Outline& outline) {
  const std::size_t size = outline.points.size();
  std::reverse(outline.points.begin(), outline.points.end());
  outline.ends.pop_back();
  std::reverse(outline.ends.begin(), outline.ends.end());
  for (std::size_t& end : outline.ends) end = size - end;
  outline.ends.push_back(size);
}

Dab dab_of(const SpinePoint& p, double thin) noexcept {
  return {p.center, thin * p.radius, p.tone};
}

}  // namespace

StylePen::StylePen() {
  const std::array<Dab, 2> row{Dab{{0.0, 0.0}, 1.0, 1.0}, Dab{{4.0, 0.0}, 1.0, 1.0}};
  const Outline& outline = outliner_.trace(row, false, 0.1);
  orientation_ = area_of(outline.contour(0)) < 0.0 ? -1.0 : 1.0;
}

void StylePen::begin(const Spine& spine, double tolerance, StyledInk& ink) {
  spine_ = &spine;
  tolerance_ = tolerance;
  ink_ = &ink;
  ink.outline.clear();
  ink.hatching.clear();
}

bool StylePen::is_full() const noexcept {
  return ink_->outline.points.size() >= StrokeStyler::kMaxPoints;
}

/// Draws the row of dabs, and clears it.
void StylePen::append_row() {
  if (!row_.empty() && !is_full()) append(ink_->outline, outliner_.trace(row_, false, tolerance_));
  row_.clear();
}

/// Appends the dabs of a part of the line that does not cross the seam.
void StylePen::append_points(StyleSpan span, double thin) {
  row_.push_back(dab_of(spine_->at(span.from), thin));
  const auto points = spine_->points();
  for (std::size_t i = spine_->next(span.from); i < points.size() && points[i].along < span.to;
       ++i) {
    row_.push_back(dab_of(points[i], thin));
  }
  row_.push_back(dab_of(spine_->at(span.to), thin));
}

void StylePen::line(StyleSpan span, double thin) {
  const double end = spine_->end();
  if (spine_->closed() && span.from >= end) span = {span.from - end, span.to - end};
  append_points({span.from, std::min(span.to, end)}, thin);
  if (spine_->closed() && span.to > end) append_points({0.0, std::min(span.to - end, end)}, thin);
  append_row();
}

void StylePen::rails(StyleSpan span, double thin) {
  const double share = std::min(thin, 0.5);
  rail(span, share, -1.0);
  rail(span, share, 1.0);
}

/// Returns true if a dab of a rail is nearer to the centre line than its offset, because the bend
/// around it is tighter than the offset. Only the part of the line near the point `near` counts, so
/// that a line may cross itself.
bool StylePen::is_inside_bend(const Dab& dab, double offset, std::size_t near) const noexcept {
  return meets_line(dab, offset, near, 1) || meets_line(dab, offset, near, -1);
}

/// Looks at the points after (`way` 1) or before (-1) the point `near`.
bool StylePen::meets_line(const Dab& dab, double offset, std::size_t near, int way) const noexcept {
  const auto points = spine_->points();
  const std::size_t count = points.size();
  const double reach = 4.0 * offset, limit = kOffsetShare * offset;
  const std::size_t first = way > 0 ? 0 : count - 1, last = count - 1 - first;
  double seam = 0.0;
  std::size_t i = near;
  for (std::size_t k = std::min(kMaxCompared, count - 1); k > 0; --k) {
    if (i == last && !spine_->closed()) return false;
    if (i == last) seam = points.back().length;
    i = i == last ? first : i + static_cast<std::size_t>(way);  // wraps around for -1
    if (seam + way * (points[i].length - points[near].length) > reach) return false;
    if (distance_squared(points[i].center, dab.center) < limit * limit) return true;
  }
  return false;
}

/// Draws the rail on one side: the offset curve without the parts that are inside of bends.
void StylePen::rail(StyleSpan span, double share, double side) {
  const auto points = spine_->points();
  rail_.clear();
  is_kept_.clear();
  const auto add = [&](const SpinePoint& p, std::size_t near) {
    const double offset = (1.0 - share) * p.radius;
    rail_.push_back({p.center + side * offset * p.normal, share * p.radius, p.tone});
    is_kept_.push_back(!is_inside_bend(rail_.back(), offset, near));
  };
  const bool is_ring = spine_->closed();
  const std::size_t first = is_ring ? 0 : spine_->next(span.from);
  const std::size_t end = is_ring ? points.size() : spine_->first(span.to);
  if (!is_ring) add(spine_->at(span.from), first > 0 ? first - 1 : 0);
  for (std::size_t i = first; i < end; ++i) add(points[i], i);
  if (!is_ring) add(spine_->at(span.to), std::min(end, points.size() - 1));
  join_rail(is_ring);
}

/// Draws the dabs of a rail that are kept. Where a part was left out inside of a bend, the parts on
/// both sides meet, because they cross there.
void StylePen::join_rail(bool is_ring) {
  const std::size_t count = rail_.size();
  std::size_t begin = 0;  // of a ring: after a part that was left out
  while (is_ring && begin < count && is_kept_[begin]) ++begin;
  if (begin == count) begin = 0;
  const auto is_near = [](const Dab& a, const Dab& b) {
    return distance(a.center, b.center) <= 4.0 * b.radius_mm;
  };
  std::optional<Dab> first;  // of all dabs
  bool was_kept = false;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (begin + k) % count;
    if (is_kept_[i]) {
      if (!was_kept && !row_.empty() && !is_near(row_.back(), rail_[i])) append_row();
      if (!first) first = rail_[i];
      row_.push_back(rail_[i]);
    }
    was_kept = is_kept_[i];
  }
  if (is_ring && first && !row_.empty() && is_near(row_.back(), *first)) {
    row_.push_back(*first);
  }
  append_row();
}

/// Returns the position of a point of a shape. Shapes on both sides of a corner meet in the middle
/// of the bend.
Point StylePen::place(Point p) const noexcept {
  if (spine_->closed() && p.x > spine_->end()) p.x -= spine_->end();
  const std::optional<std::size_t> joint = spine_->joint(p.x);
  return beside(joint ? spine_->points()[*joint] : spine_->at(p.x), p.y);
}

/// Appends the points of a straight edge of a shape, bent with the line, without the first.
void StylePen::bend(Point from, Point to, std::vector<Point>& out) const {
  const double size = spine_->end();
  if (spine_->closed() && std::max(from.x, to.x) > size) {
    if (std::min(from.x, to.x) >= size) {
      return bend({from.x - size, from.y}, {to.x - size, to.y}, out);
    }
    // At the seam, the edge has the position `size` on one side and 0 on the other.
    const double y = std::lerp(from.y, to.y, (size - from.x) / (to.x - from.x));
    const bool leaves = from.x < to.x;
    bend(leaves ? from : Point{from.x - size, from.y}, {leaves ? size : 0.0, y}, out);
    return bend({leaves ? 0.0 : size, y}, leaves ? Point{to.x - size, to.y} : to, out);
  }
  append_inner(from, to, out);
  out.push_back(place(to));
}

/// Appends the points of an edge that are between its ends: one for each point of the spine.
void StylePen::append_inner(Point from, Point to, std::vector<Point>& out) const {
  if (from.x == to.x) return;
  const auto points = spine_->points();
  const double low = std::min(from.x, to.x), high = std::max(from.x, to.x);
  const std::optional<std::size_t> joint = spine_->joint(low);
  const std::size_t begin = joint ? *joint + 1 : spine_->first(low);
  const std::size_t end = spine_->joint(high).value_or(spine_->first(high));
  for (std::size_t k = begin; k < end; ++k) {
    const SpinePoint& p = points[from.x < to.x ? k : begin + end - 1 - k];
    out.push_back(beside(p, std::lerp(from.y, to.y, (p.along - from.x) / (to.x - from.x))));
  }
}

/// Replaces contour_ by a contour of a shape over `span`. `width` is that of the line.
void StylePen::bend_contour(std::span<const Point> curves, StyleSpan span, double width) {
  const double size = span.to - span.from;
  Point from{span.from + size * curves[0].x, curves[0].y};
  contour_.assign(1, place(from));
  for (std::size_t i = 0; i + 3 < curves.size(); i += 3) {
    const Cubic u{{curves[i], curves[i + 1], curves[i + 2], curves[i + 3]}};
    Cubic c = u;
    for (Point& p : c.p) p = {width * size * p.x, width * p.y};
    const int steps = std::min(kMaxShapeSteps, flatten_steps(c, 1.0, tolerance_));
    for (int k = 1; k <= steps; ++k) {
      const Point p = k < steps ? evaluate(u, static_cast<double>(k) / steps) : u.p[3];
      const Point to{span.from + size * p.x, std::clamp(p.y, -0.5, 0.5)};
      bend(from, to, contour_);
      from = to;
    }
  }
}

void StylePen::shape(StyleSpan span, const StyleShape& shape) {
  if (is_full()) return;
  const double middle = std::min(span.from, span.to) + 0.5 * std::fabs(span.to - span.from);
  const double width = 2.0 * spine_->at(middle).radius;
  double area = 0.0;
  bent_.clear();
  for (const std::vector<Point>& curves : shape.contours) {
    bend_contour(curves, span, width);
    area += area_of(contour_);
    bent_.points.insert(bent_.points.end(), contour_.begin(), contour_.end());
    bent_.ends.push_back(bent_.points.size());
  }
  if (area * orientation_ < 0.0) reverse(bent_);
  append(ink_->outline, bent_);
}

/// The lines are numbered from the start of the line, and line k is (k + 1/2) spacings from it, so
/// that the hatching moves with the line and no line runs along an edge that begins there. An edge
/// that crosses line k adds a crossing; between the crossings 2 i and 2 i + 1 the line is inside
/// (even-odd rule).
void StylePen::hatching(double angle_deg, double spacing, double thin) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  const Vec along{std::cos(angle), std::sin(angle)}, across = perp(along);
  const auto points = spine_->points();
  const Point origin = points.front().center;
  const auto height = [&](std::size_t i) {
    return dot(points[i % points.size()].center - origin, across);
  };
  double travel = 0.0, radius = 0.0, tone = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    travel += std::fabs(height(i + 1) - height(i));
    radius += points[i].radius / static_cast<double>(points.size());
    tone += points[i].tone / static_cast<double>(points.size());
  }
  const double step = std::max(spacing, travel / kMaxCrossings);
  if (!(step > 0.0) || !std::isfinite(travel)) return;
  crossings_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SpinePoint &a = points[i], &b = points[(i + 1) % points.size()];
    const double from = height(i), to = height(i + 1);
    const double high = std::max(from, to) / step - 0.5;
    auto k = static_cast<std::int64_t>(std::ceil(std::min(from, to) / step - 0.5));
    for (; static_cast<double>(k) < high; ++k) {
      const double at = (static_cast<double>(k) + 0.5) * step;
      const double t = std::clamp((at - from) / (to - from), 0.0, 1.0);
      crossings_.push_back({k, dot(lerp(a.center, b.center, t) - origin, along),
                            std::min(thin * radius, std::lerp(a.radius, b.radius, t))});
    }
  }
  std::sort(crossings_.begin(), crossings_.end());
  for (std::size_t i = 0; i + 1 < crossings_.size() && !is_full();) {
    const Crossing &in = crossings_[i], &out = crossings_[i + 1];
    if (out.line != in.line) {  // rounding lost a crossing
      ++i;
      continue;
    }
    const Point base = origin + (static_cast<double>(in.line) + 0.5) * step * across;
    for (const Crossing& end : {in, out}) {
      row_.push_back({base + end.at * along, end.radius, tone});
      ink_->hatching.push_back(row_.back());
    }
    append_row();
    i += 2;
  }
}

}  // namespace felt
