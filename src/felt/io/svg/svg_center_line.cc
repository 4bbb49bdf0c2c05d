#include "felt/io/svg/svg_center_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace felt {
namespace {

/// Appends the segments of a contour one after the other. A segment that is too short is kept back.
/// It and the short segments after it are joined to the next long segment; or, if they are long
/// enough together before one comes, they become one straight segment. At the end of the contour,
/// they are joined to the last segment.
class Joiner {
 public:
  explicit Joiner(const SvgContour& contour) : contour_(contour) {
    line_.points.reserve(contour.points.size());
    line_.places.assign(contour.segment_count() + 1, 0.0);
  }

  SvgCenterLine join() {
    for (std::size_t i = 0; i < contour_.segment_count(); ++i) add(i);
    finish();
    line_.joints = svg_joints(line_.points, line_.closed);
    return std::move(line_);
  }

 private:
  [[nodiscard]] double made() const noexcept {
    return static_cast<double>(line_.points.size() / 3);
  }

  void append(const Cubic& c) {
    if (line_.points.empty()) line_.points.push_back(c.p[0]);
    line_.points.insert(line_.points.end(), {c.p[1], c.p[2], c.p[3]});
  }

  void add(std::size_t i) {
    Cubic c = contour_.segment(i);
    if (waiting_) {
      // The path that was kept back is too short for a segment, so this segment begins at the start
      // of that path.
      const Vec back = start_ - c.p[0];
      c.p[0] = start_;
      c.p[1] = c.p[1] + back;
    }
    if (control_length(contour_.segment(i)) >= kMinSegmentMm &&
        control_length(c) >= kMinSegmentMm) {
      set_places(waiting_from_, i, made());  // joined parts have the position of its start
      append(c);
      waiting_ = false;
    } else if (const Point end = c.p[3]; waiting_ && distance(start_, end) >= kMinSegmentMm) {
      const double first = made(), count = static_cast<double>(i + 1 - waiting_from_);
      for (std::size_t k = waiting_from_; k <= i; ++k) {
        line_.places[k] = first + static_cast<double>(k - waiting_from_) / count;
      }
      append(straight(start_, end));
      waiting_ = false;
      line_.joined_short = true;
    } else {
      if (!waiting_) start_ = c.p[0];
      if (!waiting_) waiting_from_ = i;
      waiting_ = true;
      line_.joined_short = true;
    }
    line_.places[i + 1] = made();
    if (!waiting_) waiting_from_ = i + 1;
  }

  void set_places(std::size_t from, std::size_t to, double u) {
    for (std::size_t k = from; k <= to; ++k) line_.places[k] = u;
  }

  void finish() {
    line_.closed = contour_.closed;
    const Point end = contour_.points.back();
    if (line_.points.empty()) return make_dot(end);
    if (!waiting_) return;
    // The path that is still kept back is joined to the last segment.
    const std::size_t last = line_.points.size() - 1;
    Point* p = &line_.points[last - 3];
    const Cubic longer{{p[0], p[1], p[2] + (end - p[3]), end}};
    if (control_length(longer) >= kMinSegmentMm) {
      p[2] = longer.p[2];
      p[3] = end;
    } else {
      line_.closed = false;
    }
    set_places(waiting_from_, contour_.segment_count(), made());
  }

  void make_dot(Point end) {
    const Point begin = contour_.points.front();
    const Vec way = normalized(end - begin);
    const Vec half = (0.5 * kMinSegmentMm) * (way == Vec{} ? Vec{1.0, 0.0} : way);
    const Point middle = lerp(begin, end, 0.5);
    line_.closed = false;
    line_.is_dot = true;
    append(straight(middle - half, middle + half));
    line_.places.assign(line_.places.size(), 0.0);
    line_.places.back() = 1.0;
  }

  const SvgContour& contour_;
  SvgCenterLine line_;
  Point start_;  ///< start of the short path that waits for more
  std::size_t waiting_from_ = 0;
  bool waiting_ = false;
};

}  // namespace

double SvgCenterLine::place(double u) const noexcept {
  const double last = static_cast<double>(places.size() - 1);
  const double at = std::clamp(u, 0.0, last);
  const auto i = static_cast<std::size_t>(std::min(std::floor(at), last - 1.0));
  const double t = at - static_cast<double>(i);
  if (t == 0.0) return places[i];
  if (t == 1.0) return places[i + 1];
  // If no segments were joined, the result is exactly u, without rounding.
  return places[i + 1] - places[i] == 1.0 ? places[i] + t
                                          : places[i] + t * (places[i + 1] - places[i]);
}

double svg_joint_angle_deg(const std::vector<Point>& points, std::size_t i) {
  const std::size_t n = points.size() / 3;
  const Point* in = &points[3 * i];
  const Point* out = &points[3 * ((i + 1) % n)];
  Vec arriving, leaving;
  for (int k = 2; k >= 0 && arriving == Vec{}; --k) arriving = in[3] - in[k];
  for (int k = 1; k < 4 && leaving == Vec{}; ++k) leaving = out[k] - out[0];
  return angle_between(normalized(arriving), normalized(leaving)) * (180.0 / std::numbers::pi);
}

std::vector<JointKind> svg_joints(const std::vector<Point>& points, bool closed) {
  const std::size_t n = points.size() / 3;
  std::vector<JointKind> joints;
  for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
    joints.push_back(svg_joint_angle_deg(points, i) <= kSmoothJointMaxDeg ? JointKind::kSmooth
                                                                          : JointKind::kCorner);
  }
  return joints;
}

SvgCenterLine svg_center_line(const SvgContour& contour) {
  return Joiner(contour).join();
}

}  // namespace felt
