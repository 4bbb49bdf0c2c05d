#include "felt/stroke/outline/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/outline/envelope.h"

namespace felt {
namespace {

/// The share of the tolerance for the centre line; the rest is for the arcs around it.
constexpr double kShare = 0.5;

/// The tolerance of tones between dabs: one of 50 steps from none to full.
constexpr double kToneTolerance = 0.02;

/// Returns the largest angle that an edge of a polygon may span if the polygon is to stay within
/// the tolerance of a circle of radius r.
double arc_step(double r, double tolerance) noexcept {
  constexpr double kCoarsest = std::numbers::pi / 4;
  return tolerance < 0.1 * r ? std::min(kCoarsest, 2.0 * std::acos(1.0 - tolerance / r))
                             : kCoarsest;
}

/// Returns true if both dabs ink the same area; the outline ignores tones.
bool is_same(const Dab& a, const Dab& b) noexcept {
  return a.center == b.center && a.radius_mm == b.radius_mm;
}

Stretch backwards(const Stretch& s) noexcept {
  return {s.frame.backwards(), s.length_mm};
}

}  // namespace

StrokeOutliner::StrokeOutliner() = default;
StrokeOutliner::~StrokeOutliner() = default;
StrokeOutliner::StrokeOutliner(StrokeOutliner&&) noexcept = default;
StrokeOutliner& StrokeOutliner::operator=(StrokeOutliner&&) noexcept = default;

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

/// Copies the dabs without repetitions and computes the edges between them.
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
    // If only the width changes, the direction is undefined. Any direction is valid, so the last
    // one is kept.
    if (length > 0.0) tangent = normalized(way);
    edges_.push_back({EnvelopeFrame::of(tangent, b.radius_mm - a.radius_mm, length), length});
  }
}

/// Appends the left side of the row in `direction` (+1 or -1). For an open row, also appends the
/// cap around the last dab, which leads to the start of the other side.
void StrokeOutliner::trace_side(bool closed, int direction) {
  const std::size_t count = edges_.size();
  const auto edge = [&](std::size_t i) {
    return direction > 0 ? edges_[i] : backwards(edges_[count - 1 - i]);
  };
  const auto dab_before =
      [&](std::size_t i) -> const Dab& {  // the dab before edge i in this direction
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
  // A gentle bend: one point between the normals is enough. Its error is r (1 - cos(turn / 2)),
  // which is less than r (1 - cos turn) / 3.7 below 60 degrees.
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

/// Appends an arc around the dab from `normal`, including both ends.
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

int flatten_steps(const Cubic& c, double span, double tolerance_mm) noexcept {
  // |f''| is largest at one of the ends, where it is 6 times a second difference of the control
  // points.
  const double bend = std::max(norm_squared((c.p[2] - c.p[1]) - (c.p[1] - c.p[0])),
                               norm_squared((c.p[3] - c.p[2]) - (c.p[2] - c.p[1])));
  const double steps = span * std::sqrt(0.75 * std::sqrt(bend) / tolerance_mm);
  if (!(steps < kMaxFlattenSteps)) return kMaxFlattenSteps;
  return std::max(1, static_cast<int>(std::ceil(steps)));
}

namespace {

/// Does the work of flatten(). `ends` may be null.
void flatten_into(const Stroke& stroke, int first, int last, double tolerance_mm,
                  std::vector<Dab>& out, std::vector<std::size_t>* ends) {
  const auto knots = stroke.widths();
  const int largest = std::max(1, kMaxStrokeSteps / stroke.segment_count());
  out.clear();
  out.push_back({stroke.segment(first).p[0], 0.5 * stroke.width_mm(first), stroke.tone(first)});
  DrawnProfile profile(stroke, first);
  for (const DrawnPiece* piece = profile.next(); piece && piece->segment < last;
       piece = profile.next()) {
    const WidthKnot &a = knots[piece->knot], &b = knots[piece->knot + 1];
    const int i = piece->segment;
    const double t0 = piece->t0, t1 = piece->t1;
    const Cubic c = stroke.segment(i);
    const int for_center = flatten_steps(c, t1 - t0, tolerance_mm);
    const int steps = std::min(
        largest,
        piece->tone.steps(kToneTolerance, piece->radius_mm.steps(tolerance_mm, for_center)));
    const double slope = 0.5 * (b.width_mm - a.width_mm) / (b.u - a.u);
    const double tone_slope = (b.tone - a.tone) / (b.u - a.u);
    const auto line_at = [&](Point center, double u) {
      return Dab{center, 0.5 * a.width_mm + slope * (u - a.u),
                 std::clamp(a.tone + tone_slope * (u - a.u), 0.0, 1.0)};
    };
    std::size_t next = out.size();
    out.resize(next + static_cast<std::size_t>(steps));
    const bool bends = !piece->radius_mm.is_straight() || !piece->tone.is_straight();
    for (int s = 1; s < steps; ++s) {
      const double t = t0 + (t1 - t0) * s / steps;
      Dab& dab = out[next++] = line_at(evaluate(c, t), i + t);
      if (!bends) continue;
      const double x = (t - t0) / (t1 - t0);
      dab.radius_mm += piece->radius_mm.at(x);
      dab.tone = std::clamp(dab.tone + piece->tone.at(x), 0.0, 1.0);
    }
    out.back() = line_at(t1 < 1.0 ? evaluate(c, t1) : c.p[3], i + 1);
    if (b.u <= i + 1) {
      out.back().radius_mm = 0.5 * b.width_mm;
      out.back().tone = b.tone;
    }
    // The last piece of a segment ends it.
    if (ends) (*ends)[static_cast<std::size_t>(i - first)] = out.size() - 1;
  }
}

}  // namespace

void flatten(const Stroke& stroke, double tolerance_mm, std::vector<Dab>& out) {
  flatten(stroke, 0, stroke.segment_count(), tolerance_mm, out);
}

void flatten(const Stroke& stroke, int first, int last, double tolerance_mm,
             std::vector<Dab>& out) {
  flatten_into(stroke, first, last, tolerance_mm, out, nullptr);
}

void flatten(const Stroke& stroke, int first, int last, double tolerance_mm, std::vector<Dab>& out,
             std::vector<std::size_t>& ends) {
  ends.assign(static_cast<std::size_t>(last - first), 0);
  flatten_into(stroke, first, last, tolerance_mm, out, &ends);
}

}  // namespace felt
