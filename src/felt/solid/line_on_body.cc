#include "felt/solid/line_on_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "felt/solid/stroke_path.h"
#include "felt/solid/surface_hit.h"
#include "felt/solid/view_frame.h"

namespace felt {
namespace {

/// Returns the axis along which the points of lines are farthest apart.
double Vec3::*longest_axis(std::span<const LineOnBody> lines) {
  double Vec3::*longest = &Vec3::x;
  double best = -1.0;
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const LineOnBody& line : lines) {
      for (const Vec3& p : line.points) {
        low = std::min(low, p.*axis);
        high = std::max(high, p.*axis);
      }
    }
    if (high - low <= best) continue;
    best = high - low;
    longest = axis;
  }
  return longest;
}

/// A point of a line in the picture, and that on the body below it.
struct ProjectedPoint {
  Point at;
  SurfaceHit hit;
};

/// Tells whether the surface joins two points of a line, and appends the points between them if the
/// surface is steep there. Halves the line until neighbours are near each other, as at the rim of a
/// ball, or nearer than a 64th of a step in the picture, as where one part hides another.
class LineSteps {
 public:
  LineSteps(const SolidBody& body, const ViewFrame& frame, double max_jump_mm)
      : body_(body), frame_(frame), max_jump_mm_(max_jump_mm) {}

  [[nodiscard]] std::optional<ProjectedPoint> project(Point p) const {
    const auto hit = hit_from_eye(body_, frame_.to_solid(p, 0.0), -1.0 * frame_.towards);
    if (!hit) return std::nullopt;
    return ProjectedPoint{p, *hit};
  }
  bool join(const ProjectedPoint& from, const ProjectedPoint& to, int halvings,
            std::vector<ProjectedPoint>& between) const {
    if (norm(to.hit.point - from.hit.point) <= max_jump_mm_) return true;
    if (halvings == 0) return false;
    const auto middle = project(lerp(from.at, to.at, 0.5));
    if (!middle || !join(from, *middle, halvings - 1, between)) return false;
    between.push_back(*middle);
    return join(*middle, to, halvings - 1, between);
  }

 private:
  const SolidBody& body_;
  const ViewFrame& frame_;
  double max_jump_mm_;
};

}  // namespace

std::vector<LineOnBody> projected_line(const SolidBody& body, std::span<const Vec3> path,
                                       const Vec3& view, double step_mm) {
  constexpr double kMaxJump = 6.0;  // in steps
  constexpr int kHalvings = 6;
  std::vector<LineOnBody> lines;
  if (path.empty()) return lines;
  const ViewFrame frame = view_frame(view);
  std::vector<Point> drawn;
  for (const Vec3& p : path) drawn.push_back(frame.to_picture(p));
  step_mm = std::max(step_mm, path_length(drawn) / kMaxProjectedPoints);
  const std::vector<Point> points = drawn.size() > 1 ? resampled(drawn, step_mm) : drawn;
  const LineSteps steps(body, frame, kMaxJump * step_mm);
  std::optional<ProjectedPoint> last;
  const auto append = [&lines](const ProjectedPoint& p) {
    lines.back().points.push_back(p.hit.point);
    lines.back().normals.push_back(p.hit.normal);
  };
  for (const Point p : points) {
    const std::optional<ProjectedPoint> next = steps.project(p);
    std::vector<ProjectedPoint> between;
    if (next && last && steps.join(*last, *next, kHalvings, between)) {
      for (const ProjectedPoint& middle : between) append(middle);
    } else if (next) {
      lines.emplace_back();
    }
    if (next) append(*next);
    last = next;
  }
  return lines;
}

LineSearch::LineSearch(std::span<const LineOnBody> lines) : axis_(longest_axis(lines)) {
  for (const LineOnBody& line : lines) {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      // A part of one point is a dot.
      if (i + 1 == line.points.size() && i > 0) break;
      const std::size_t next = std::min(i + 1, line.points.size() - 1);
      const Vec3 a = line.points[i], b = line.points[next];
      segments_.push_back({a, b, line.normals[i], 0.5 * (a.*axis_ + b.*axis_)});
      longest_ = std::max(longest_, norm(b - a));
    }
  }
  // Stable, so that the result does not depend on the standard library.
  std::stable_sort(segments_.begin(), segments_.end(),
                   [](const Segment& a, const Segment& b) { return a.middle < b.middle; });
}

LineSearch::Near LineSearch::nearest(const Vec3& p, double radius_mm) const {
  Near best{2.0 * radius_mm + 1.0, {}};
  const double reach = radius_mm + 0.5 * longest_;
  auto at = std::lower_bound(segments_.begin(), segments_.end(), p.*axis_ - reach,
                             [](const Segment& s, double middle) { return s.middle < middle; });
  for (; at != segments_.end() && at->middle <= p.*axis_ + reach; ++at) {
    const Vec3 along = at->b - at->a;
    const double length = norm_squared(along);
    const double t = length > 0.0 ? std::clamp(dot(p - at->a, along) / length, 0.0, 1.0) : 0.0;
    const double distance = norm(p - (at->a + t * along));
    if (distance < best.distance_mm) best = {distance, at->normal};
  }
  return best;
}

}  // namespace felt
