#include "felt/tools/handles.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kNoHandleMm = 1e-6;  // a shorter handle counts as having no length
/// Squared sine of the largest angle between two handles that is not corrected: 6e-9 degrees.
constexpr double kStraight = 1e-20;

Cubic handles_segment(const StrokeData& data, std::size_t segment) noexcept {
  const Point* p = &data.points[3 * segment];
  return {{p[0], p[1], p[2], p[3]}};
}

JointKind joint_kind(const StrokeData& data, std::size_t joint) {
  if (joint > 0 && joint < data.points.size() / 3) return data.joints[joint - 1];
  return data.closed ? data.joints.back() : JointKind::kEnd;
}

}  // namespace

void give_handles(StrokeData& data, std::size_t segment) {
  const Cubic c = handles_segment(data, segment);
  Point* p = &data.points[3 * segment];
  if (joint_kind(data, segment) == JointKind::kSmooth && distance(c.p[0], c.p[1]) < kNoHandleMm) {
    p[1] = c.p[0] + kStandingHandleMm * tangent(c, 0.0);
  }
  if (joint_kind(data, segment + 1) == JointKind::kSmooth &&
      distance(c.p[2], c.p[3]) < kNoHandleMm) {
    p[2] = c.p[3] - kStandingHandleMm * tangent(c, 1.0);
  }
}

bool keep_length(StrokeData& data, std::size_t segment, const Cubic& before) {
  const Cubic c = handles_segment(data, segment);
  if (control_length(c) >= kMinSegmentMm || c == before) return false;
  const auto handle = [&](Vec now, double t) {
    const Vec direction = now == Vec{} ? tangent(before, t) : normalized(now);
    return std::max(norm(now), kSliverHandleMm) * direction;
  };
  Point* p = &data.points[3 * segment];
  p[1] = c.p[0] + handle(c.p[1] - c.p[0], 0.0);
  p[2] = c.p[3] - handle(c.p[3] - c.p[2], 1.0);
  return true;
}

void keep_smooth(StrokeData& data, std::size_t joint, Vec fallback) {
  if (joint_kind(data, joint) != JointKind::kSmooth) return;
  const std::size_t n = data.points.size() / 3;
  Point& before = data.points[3 * (joint > 0 ? joint : n) - 1];
  const Point at = data.points[3 * joint];
  Point& after = data.points[joint < n ? 3 * joint + 1 : 1];
  const Vec in = at - before, out = after - at;
  const double in2 = norm_squared(in), out2 = norm_squared(out);
  const double turn = cross(in, out);
  if (dot(in, out) > 0.0 && turn * turn <= kStraight * in2 * out2) return;
  Vec direction = normalized(in2 > out2 ? in : out);
  if (direction == Vec{}) direction = fallback;
  before = at - std::max(std::sqrt(in2), kStandingHandleMm) * direction;
  after = at + std::max(std::sqrt(out2), kStandingHandleMm) * direction;
}

}  // namespace felt
