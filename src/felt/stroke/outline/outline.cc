#include "felt/stroke/outline/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

/// The tolerance is shared between the centre line and the arcs around it.
constexpr double kShare = 0.5;

/// Largest angle of a polygon's edge within the tolerance of a circle of radius r.
double arc_step(double r, double tolerance) noexcept {
  constexpr double kCoarsest = std::numbers::pi / 4;
  return tolerance < 0.1 * r ? std::min(kCoarsest, 2.0 * std::acos(1.0 - tolerance / r))
                             : kCoarsest;
}

/// Inks the same; the outline does not know tones.
bool is_same(const Dab& a, const Dab& b) noexcept {
  return a.center == b.center && a.radius_mm == b.radius_mm;
}

Stretch backwards(const Stretch& s) noexcept {
  return {s.frame.backwards(), s.length_mm};
}

}  // namespace

const Outline& StrokeOutliner::trace(const Stroke& stroke, double tolerance_mm) {
  flatten(stroke, kShare * tolerance_mm, flattened_);
  return trace(flattened_, stroke.closed(), tolerance_mm);
}

const Outline& StrokeOutliner::trace(std::span<const Dab> dabs, bool closed, double tolerance_mm) {
  tolerance_mm_ = (1.0 - kShare) * tolerance_mm;
  outline_.clear();
  link(dabs, closed);
  if (dabs_.size() == 1) {
    arc(dabs_.front(), {1.0, 0.0}, -2.0 * std::numbers::pi);
    close_contour();
  } else if (!dabs_.empty()) {
    trace_side(closed, +1);
    if (closed) close_contour();
    trace_side(closed, -1);
    close_contour();
  }
  return outline_;
}

/// Takes over the dabs without repetitions and finds the edges between them.
void StrokeOutliner::link(std::span<const Dab> dabs, bool closed) {
  dabs_.clear();
  for (const Dab& dab : dabs) {
    if (dabs_.empty() || !is_same(dab, dabs_.back())) dabs_.push_back(dab);
  }
  if (closed && dabs_.size() > 1 && is_same(dabs_.front(), dabs_.back())) dabs_.pop_back();
  edges_.clear();
  if (dabs_.size() < 2) return;
  const std::size_t count = dabs_.size() - (closed ? 0 : 1);
  Vec tangent{1.0, 0.0};
  for (std::size_t i = 0; i < count; ++i) {
    const Dab& a = dabs_[i];
    const Dab& b = dabs_[i + 1 == dabs_.size() ? 0 : i + 1];
    const Vec way = b.center - a.center;
    const double length = norm(way);
    // A change of width on the spot has no direction of its own; any will do.
    if (length > 0.0) tangent = normalized(way);
    edges_.push_back({EnvelopeFrame::of(tangent, b.radius_mm - a.radius_mm, length), length});
  }
}

/// Appends the left side of the row walked in `direction` (+1 or -1) and, where the row ends, the
/// cap around its last dab, which brings the walk to where the other side begins.
void StrokeOutliner::trace_side(bool closed, int direction) {
  const std::size_t count = edges_.size();
  const auto edge = [&](std::size_t i) {
    return direction > 0 ? edges_[i] : backwards(edges_[count - 1 - i]);
  };
  const auto dab_before = [&](std::size_t i) -> const Dab& {  // of edge i, in walking order
    return direction > 0 ? dabs_[i] : dabs_[(count - i) % dabs_.size()];
  };
  Stretch from = edge(closed ? count - 1 : 0);
  for (std::size_t i = closed ? 0 : 1; i < count; ++i) {
    const Stretch to = edge(i);
    turn(dab_before(i), from, to, direction);
    from = to;
  }
  if (!closed) arc(dab_before(count), from.frame.normal(), -2.0 * from.frame.normal_angle());
}

void StrokeOutliner::turn(const Dab& dab, const Stretch& from, const Stretch& to, int direction) {
  const Vec n = from.frame.normal(), m = to.frame.normal();
  const double r = dab.radius_mm;
  const double cosine = dot(n, m);
  // A gentle bend: one point between the normals, r (1 - cos(turn / 2)) off, which is less than
  // r (1 - cos turn) / 3.7 below 60 degrees.
  if (cosine > 0.5 && r * (1.0 - cosine) <= 3.7 * tolerance_mm_ &&
      dot(from.frame.tangent, to.frame.tangent) > 0.0 &&
      (cross(n, m) <= 0.0 || has_room(from, to, r))) {
    outline_.points.push_back(dab.center + r * normalized(n + m));
    return;
  }
  const Turn turn = turn_between(from, to, r, direction);
  if (turn.kind == Turn::Kind::kArc) {
    arc(dab, n, turn.sweep);
    return;
  }
  outline_.points.push_back(dab.center + r * n);
  if (turn.kind == Turn::Kind::kPivot) outline_.points.push_back(dab.center);
  outline_.points.push_back(dab.center + r * m);
}

/// Appends an arc around the dab from `normal`, both ends included.
void StrokeOutliner::arc(const Dab& dab, Vec normal, double sweep) {
  const double step = arc_step(dab.radius_mm, tolerance_mm_);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::fabs(sweep) / step - 1e-9)));
  const double c = std::cos(sweep / steps), s = std::sin(sweep / steps);
  outline_.points.push_back(dab.center + dab.radius_mm * normal);
  for (int i = 0; i < steps; ++i) {
    normal = c * normal + s * perp(normal);
    outline_.points.push_back(dab.center + dab.radius_mm * normal);
  }
}

void StrokeOutliner::close_contour() {
  outline_.ends.push_back(outline_.points.size());
}

Outline outline_of(const Stroke& stroke, double tolerance_mm) {
  StrokeOutliner outliner;
  return outliner.trace(stroke, tolerance_mm);
}

}  // namespace felt
