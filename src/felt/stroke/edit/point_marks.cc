#include "felt/stroke/edit/point_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

bool is_on_curve(std::size_t i) {
  return i % 3 == 0;
}

/// A smooth joint: its point, and the segments that meet there.
struct SmoothJoint {
  std::size_t point = 0;
  std::size_t in = 0;   // segment that ends there
  std::size_t out = 0;  // segment that starts there
};

/// Returns the k-th joint of StrokeData::joints if it is smooth.
std::optional<SmoothJoint> smooth_joint(const StrokeData& d, std::size_t k) {
  if (d.joints[k] != JointKind::kSmooth) return std::nullopt;
  const std::size_t n = d.points.size() / 3, next = k + 1 < n ? k + 1 : 0;
  return SmoothJoint{3 * next, k, next};
}

/// Returns the arm on the side of the segment that ends at the joint.
std::size_t in_arm(const StrokeData& d, const SmoothJoint& j) {
  for (std::size_t k = 3; k-- > 1;) {
    if (d.points[3 * j.in + k] != d.points[j.point]) return 3 * j.in + k;
  }
  return 3 * j.in;
}

/// Returns the arm on the side of the segment that starts at the joint.
std::size_t out_arm(const StrokeData& d, const SmoothJoint& j) {
  for (std::size_t k = 1; k < 3; ++k) {
    if (d.points[3 * j.out + k] != d.points[j.point]) return 3 * j.out + k;
  }
  return 3 * j.out + 3;
}

/// Returns true if the point is a smooth joint.
bool is_smooth(const StrokeData& d, std::size_t point) {
  const std::size_t n = d.points.size() / 3, joint = point / 3;
  if (joint == 0 || joint == n) return d.closed && d.joints.back() == JointKind::kSmooth;
  return d.joints[joint - 1] == JointKind::kSmooth;
}

/// Returns true if the arm may rotate about its joint: it is the joint's own handle, and it does
/// not determine the tangent of the joint at the other end of the segment.
bool in_arm_is_free(const StrokeData& d, const SmoothJoint& j, std::size_t arm) {
  const std::size_t start = 3 * j.in;
  return arm == start + 2 && !(d.points[start + 1] == d.points[start] && is_smooth(d, start));
}
bool out_arm_is_free(const StrokeData& d, const SmoothJoint& j, std::size_t arm) {
  const std::size_t start = 3 * j.out;
  return arm == start + 1 &&
         !(d.points[start + 2] == d.points[start + 3] && is_smooth(d, start + 3));
}

/// Sets marks of the points of a stroke. The first and the last point of a closed stroke are the
/// same point, so they are marked together.
class Marker {
 public:
  Marker(const StrokeData& d, std::span<std::uint8_t> marks) : d_(d), marks_(marks) {}

  [[nodiscard]] bool is_set(std::size_t i) const { return marks_[i] != 0; }
  void set(std::size_t i) {
    if (marks_[i] != 0) return;
    marks_[i] = 1;
    changed_ = true;
    const std::size_t last = d_.points.size() - 1;
    if (d_.closed && i == 0) marks_[last] = 1;
    if (d_.closed && i == last) marks_[0] = 1;
  }
  /// Marks the points at one joint that must move if the marked points do.
  void settle(const SmoothJoint& j) {
    const std::size_t in = in_arm(d_, j), out = out_arm(d_, j);
    if (!is_set(j.point) && must_be_set(j, in, out)) set(j.point);
    if (!is_set(j.point)) return;
    for (std::size_t i = 3 * j.in + 3; i-- > in;) set(i);
    for (std::size_t i = 3 * j.out + 1; i <= out; ++i) set(i);
  }
  [[nodiscard]] bool has_changed() { return std::exchange(changed_, false); }

 private:
  [[nodiscard]] bool must_be_set(const SmoothJoint& j, std::size_t in, std::size_t out) const {
    // A marked point at the same position as the joint marks the joint.
    for (std::size_t i = in + 1; i < 3 * j.in + 3; ++i) {
      if (is_set(i)) return true;
    }
    for (std::size_t i = 3 * j.out + 1; i < out; ++i) {
      if (is_set(i)) return true;
    }
    if (is_set(in) && is_set(out)) return true;
    if (is_set(in)) return !out_arm_is_free(d_, j, out);
    if (is_set(out)) return !in_arm_is_free(d_, j, in);
    return false;
  }

  const StrokeData& d_;
  std::span<std::uint8_t> marks_;
  bool changed_ = false;
};

/// Returns `handle` rotated about `joint` to point away from `arm`, with the same length. Returns
/// it unchanged if the arm has no length.
Point turned(Point joint, Point handle, Point arm) {
  const Vec way = normalized(joint - arm);
  return way == Vec{} ? handle : joint + distance(joint, handle) * way;
}

bool is_similarity(const Affine& m) {
  const double size = std::fabs(m.a) + std::fabs(m.b) + std::fabs(m.c) + std::fabs(m.d);
  const double turn = std::max(std::fabs(m.a - m.d), std::fabs(m.b + m.c));
  const double mirror = std::max(std::fabs(m.a + m.d), std::fabs(m.b - m.c));
  return std::min(turn, mirror) <= 1e-12 * size;
}

/// Maps the marked points. If the joint of a handle is marked too, the handle is mapped relative to
/// it, so that parallel arms stay parallel up to rounding, however far away the map's origin is.
void move_points(const StrokeData& before, std::span<const std::uint8_t> marks, const Affine& map,
                 std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); i += 3) {
    if (marks[i]) points[i] = apply(map, before.points[i]);
  }
  const auto move_handle = [&](std::size_t handle, std::size_t joint) {
    if (!marks[handle]) return;
    points[handle] = marks[joint]
                         ? points[joint] + apply(map, before.points[handle] - before.points[joint])
                         : apply(map, before.points[handle]);
  };
  for (std::size_t i = 0; i + 3 < points.size(); i += 3) {
    move_handle(i + 1, i);
    move_handle(i + 2, i + 3);
  }
}

/// Rotates a handle if that is necessary to keep the joint smooth. `points` are the points after
/// the mapping.
void keep_smooth(const StrokeData& before, const SmoothJoint& j,
                 std::span<const std::uint8_t> marks, bool keeps_angles,
                 std::vector<Point>& points) {
  const std::size_t in = in_arm(before, j), out = out_arm(before, j);
  const Point joint = points[j.point];
  if (marks[j.point]) {
    // A map that keeps angles also keeps the joint smooth. A non-uniform scaling magnifies the
    // small angle between the handles, by 20 : 0.05 at most.
    if (keeps_angles) return;
    const double turn = angle_between(joint - points[in], points[out] - joint);
    if (turn <= 0.1 * kSmoothJointMaxDeg * std::numbers::pi / 180.0) return;
    if (out_arm_is_free(before, j, out)) {
      points[out] = turned(joint, points[out], points[in]);
    } else if (in_arm_is_free(before, j, in)) {
      points[in] = turned(joint, points[in], points[out]);
    }
    return;
  }
  if (marks[in] && !marks[out]) points[out] = turned(joint, before.points[out], points[in]);
  if (marks[out] && !marks[in]) points[in] = turned(joint, before.points[in], points[out]);
}

/// Returns the width factor at u: `factor` at marked joints, 1 at others, linear in between.
double factor_at(std::span<const std::uint8_t> marks, double u, double factor) {
  const std::size_t n = marks.size() / 3;
  const std::size_t i = std::min(static_cast<std::size_t>(u), n - 1);
  const double f0 = marks[3 * i] ? factor : 1.0, f1 = marks[3 * i + 3] ? factor : 1.0;
  return f0 == f1 ? f0 : std::lerp(f0, f1, u - static_cast<double>(i));
}

double scaled_width(double width_mm, double factor) {
  return std::clamp(factor * width_mm, kMinWidthMm, std::max(kMaxScaledWidthMm, width_mm));
}

/// Returns the profile with its breakpoints scaled, and a new breakpoint at every joint where the
/// factor starts or stops changing.
std::vector<WidthKnot> scaled_widths(const StrokeData& d, std::span<const std::uint8_t> marks,
                                     double factor) {
  std::vector<WidthKnot> knots = d.widths;
  const std::size_t n = d.points.size() / 3;
  const auto fades = [&](std::size_t i) { return marks[3 * i] != marks[3 * i + 3]; };
  for (std::size_t k = 1; k < n; ++k) {
    if (fades(k - 1) || fades(k)) {
      knots.push_back(knot_at(d.widths, static_cast<double>(k)));
    }
  }
  std::stable_sort(knots.begin(), knots.end(),
                   [](const WidthKnot& a, const WidthKnot& b) { return a.u < b.u; });
  const auto same_place = [](const WidthKnot& a, const WidthKnot& b) { return a.u == b.u; };
  knots.erase(std::unique(knots.begin(), knots.end(), same_place), knots.end());
  for (WidthKnot& knot : knots) {
    const double f = factor_at(marks, knot.u, factor);
    if (f != 1.0) knot.width_mm = scaled_width(knot.width_mm, f);
  }
  return knots;
}

}  // namespace

void close_marks(const Stroke& stroke, std::span<std::uint8_t> marks) {
  const StrokeData& d = stroke.data();
  if (marks.size() != d.points.size()) return;
  if (d.closed) marks.front() = marks.back() = marks.front() | marks.back();
  Marker marker(d, marks);
  // Sweeps forward and backward until nothing changes, because marks spread from joint to joint.
  do {
    for (std::size_t k = 0; k < d.joints.size(); ++k) {
      if (const auto j = smooth_joint(d, k)) marker.settle(*j);
    }
    for (std::size_t k = d.joints.size(); k-- > 0;) {
      if (const auto j = smooth_joint(d, k)) marker.settle(*j);
    }
  } while (marker.has_changed());
}

Result<Stroke> with_marked_moved(const Stroke& stroke, std::span<const std::uint8_t> marks,
                                 const Affine& map, double width_factor) {
  const StrokeData& before = stroke.data();
  if (marks.size() != before.points.size()) {
    return fail(ErrorCode::kInvalidArgument, "there must be a mark for each control point");
  }
  StrokeData d = before;
  move_points(before, marks, map, d.points);
  const bool keeps_angles = is_similarity(map);
  for (std::size_t k = 0; k < before.joints.size(); ++k) {
    if (const auto j = smooth_joint(before, k)) {
      keep_smooth(before, *j, marks, keeps_angles, d.points);
    }
  }
  if (width_factor != 1.0) d.widths = scaled_widths(before, marks, width_factor);
  return Stroke::create(std::move(d));
}

std::vector<std::size_t> anchors(const Stroke& stroke, std::span<const std::uint8_t> marks) {
  const bool closed = stroke.closed();
  const std::size_t size = stroke.data().points.size();
  if (marks.size() != size) return {};
  const std::size_t m = closed ? size - 1 : size;  // counts the seam once
  // For each point, the next and the previous unmarked on-curve point. The loops go round a closed
  // stroke twice.
  std::vector<std::size_t> next(m, kNone), last(m, kNone);
  const std::size_t rounds = closed ? 2 * m : m;
  std::size_t seen = kNone;
  for (std::size_t i = 0; i < rounds; ++i) {
    const std::size_t at = i % m;
    if (is_on_curve(at) && !marks[at]) seen = at;
    last[at] = seen;
  }
  seen = kNone;
  for (std::size_t i = rounds; i-- > 0;) {
    const std::size_t at = i % m;
    if (is_on_curve(at) && !marks[at]) seen = at;
    next[at] = seen;
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < m; ++i) {
    if (!marks[i]) continue;
    const bool starts = i > 0 ? !marks[i - 1] : !(closed && marks[m - 1]);
    const bool ends = i + 1 < m ? !marks[i + 1] : !(closed && marks[0]);
    if (starts && last[i] != kNone) found.push_back(last[i]);
    if (ends && next[i] != kNone) found.push_back(next[i]);
  }
  return found;
}

}  // namespace felt
