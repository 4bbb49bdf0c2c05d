#include "felt/motion/oriented_pair.h"

#include <array>
#include <cmath>
#include <utility>

#include "felt/motion/group_motion.h"
#include "felt/motion/line_features.h"
#include "felt/motion/stroke_shape.h"
#include "felt/stroke/edit/join.h"
#include "felt/stroke/edit/split.h"

namespace felt {
namespace {

constexpr double kCount = static_cast<double>(kShapePoints);
/// A seam is moved to a joint that is at most this share of the length away.
constexpr double kSeamSnapShare = 0.01;
/// If the other seam is a corner, to a corner this near.
constexpr double kCornerSnapShare = 0.06;

/// Returns the part of a stroke between two shares of its length.
std::optional<Stroke> part_of(const Stroke& stroke, double start, double end) {
  if (start <= 0.0 && end >= 1.0) return stroke;
  const StepLengths lengths(stroke);
  Result<Stroke> part = sub_stroke(stroke, lengths.u_at(start * lengths.length_mm()),
                                   lengths.u_at(end * lengths.length_mm()));
  if (!part) return std::nullopt;
  return *std::move(part);
}

bool has_corner_at_seam(const Stroke& stroke) noexcept {
  return stroke.joint(0) != JointKind::kSmooth;
}

/// Returns the parameter of a joint near u, or u. Prefers a corner if `to_corner`.
double near_joint(const Stroke& stroke, double u, bool to_corner) {
  const StepLengths lengths(stroke);
  const double at = lengths.length_at(u), whole = lengths.length_mm();
  double best = u, least = kSeamSnapShare * whole;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const double apart = std::fabs(std::remainder(lengths.length_at(i) - at, whole));
    const bool is_corner = to_corner && stroke.joint(i) == JointKind::kCorner;
    const double counted = is_corner ? apart * kSeamSnapShare / kCornerSnapShare : apart;
    if (counted >= least) continue;
    least = counted;
    best = i;
  }
  return best;
}

/// Returns a closed stroke cut open at u, or at its seam if that leaves a segment too short.
Stroke opened(const Stroke& stroke, double u) {
  const double n = stroke.segment_count();
  for (const double at : {u, std::round(u)}) {
    if (Result<Stroke> open = sub_stroke(stroke, at >= n ? 0.0 : at, at >= n ? 0.0 : at)) {
      return *std::move(open);
    }
  }
  return sub_stroke(stroke, 0.0, 0.0).value();
}

/// Returns where a closed stroke should begin, as a share of its length, so that it fits `other`,
/// which is at its place. `share` is a first guess.
double better_seam(const Stroke& stroke, const StrokeShape& other, double share) {
  const StepLengths lengths(stroke);
  const double around = other.closed ? kCount : kCount - 1.0;
  double best = share, least = 1e300;
  for (int step = -4; step <= 4; ++step) {
    const double start = share + 0.25 * step / kCount;
    double sum = 0.0;
    for (std::size_t i = 0; i < kShapePoints; ++i) {
      const double at = start + static_cast<double>(i) / around;
      const double mm = (at - std::floor(at)) * lengths.length_mm();
      sum += distance_squared(stroke.position(lengths.u_at(mm)), other.points[i]);
    }
    if (sum >= least) continue;
    least = sum;
    best = start - std::floor(start);
  }
  return best;
}

/// Returns the closed stroke with its seam where it fits `other`; if `other` is open, cut open
/// there.
Stroke with_seam_for(const Stroke& stroke, const StrokeShape& other, bool to_corner) {
  // Both run in the same direction, so only the start is looked for.
  const StrokeShape own = shape_of(stroke);
  double best = 0.0, least = 1e300;
  for (std::size_t shift = 0; shift < kShapePoints; ++shift) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kShapePoints; ++i) {
      sum += distance_squared(other.points[i], own.points[(shift + i) % kShapePoints]);
    }
    if (sum >= least) continue;
    least = sum;
    best = static_cast<double>(shift) / kCount;
  }
  const StepLengths lengths(stroke);
  const double share = better_seam(stroke, other, best);
  const double u = near_joint(stroke, lengths.u_at(share * lengths.length_mm()), to_corner);
  Stroke open = opened(stroke, u);
  if (!other.closed) return open;
  Result<Stroke> ring = closed(open);
  return ring ? *std::move(ring) : stroke;
}

/// Returns the direction in which a shape runs around: the sign of its area.
double area_of(const StrokeShape& shape) noexcept {
  double sum = 0.0;
  Vec before = shape.points.back() - shape.centre;
  for (const Point p : shape.points) {
    const Vec now = p - shape.centre;
    sum += cross(before, now);
    before = now;
  }
  return sum;
}

/// Returns true if the second stroke must be reversed so that both run in the same direction.
bool runs_against(const StrokeShape& a, const StrokeShape& b, const StrokeMatch& match) noexcept {
  if (!a.closed || !b.closed) return match.reversed;
  // Two rings that run around in opposite directions would turn inside out.
  return area_of(a) * area_of(b) < 0.0;
}

}  // namespace

std::optional<OrientedPair> oriented_pair(const Stroke& from, const Stroke& to,
                                          const StrokeMatch& match, const Similarity& motion) {
  std::optional<Stroke> a = part_of(from, match.from_start, match.from_end);
  std::optional<Stroke> b = part_of(to, match.to_start, match.to_end);
  if (!a || !b) return std::nullopt;
  const StrokeShape a_shape = moved(motion, shape_of(*a));
  if (runs_against(a_shape, shape_of(*b), match)) b = reversed(*b);
  if (b->closed()) {
    b = with_seam_for(*b, a_shape, a->closed() && has_corner_at_seam(*a));
  } else if (a->closed()) {
    StrokeShape b_shape = shape_of(*b);
    for (Point& p : b_shape.points) p = moved_back(motion, p);
    a = with_seam_for(*a, b_shape, false);
  }
  return OrientedPair{*std::move(a), *std::move(b)};
}

}  // namespace felt
