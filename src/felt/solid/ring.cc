#include "felt/solid/ring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "felt/geometry/polyline.h"
#include "felt/geometry/rect.h"

namespace felt {
namespace ring_work {

constexpr int kMaxSteps = 1000;

/// Returns the number of equal steps of t for chords within the tolerance and no longer than
/// `step_mm`. The bound is that of Wang: a cubic with control polygon p deviates by at most 6/8
/// max |p(i) - 2 p(i+1) + p(i+2)| / steps^2 (G. Wang, J. Zhejiang Univ. 2, 1984).
int steps_of(const Cubic& c, double tolerance_mm, double step_mm) {
  const Vec a = (c.p[0] - c.p[1]) - (c.p[1] - c.p[2]), b = (c.p[1] - c.p[2]) - (c.p[2] - c.p[3]);
  const double bend = std::sqrt(0.75 * std::max(norm(a), norm(b)) / tolerance_mm);
  const double steps = std::max(bend, control_length(c) / step_mm);
  return std::clamp(static_cast<int>(std::ceil(std::min(steps, 1.0 * kMaxSteps))), 1, kMaxSteps);
}

/// Removes points that are nearer than `min_mm` to the last one that stays.
void drop_near(Ring& ring, double min_mm) {
  Ring kept;
  for (const Point p : ring) {
    if (kept.empty() || distance(kept.back(), p) >= min_mm) kept.push_back(p);
  }
  while (kept.size() > 1 && distance(kept.front(), kept.back()) < min_mm) kept.pop_back();
  ring = std::move(kept);
}

/// A position on a ring that moves away from a corner.
struct Walker {
  const Ring& ring;
  std::size_t from;  // index of the corner
  bool forward;
  std::size_t steps = 0;  // edges behind it

  [[nodiscard]] std::size_t index(std::size_t k) const {
    const std::size_t n = ring.size();
    return forward ? (from + k) % n : (from + n - k % n) % n;
  }
  [[nodiscard]] double edge() const { return distance(ring[index(steps)], ring[index(steps + 1)]); }
  [[nodiscard]] Point at(double length_mm) const {
    const double whole = edge();
    return lerp(ring[index(steps)], ring[index(steps + 1)], whole > 0 ? length_mm / whole : 0.0);
  }
};

/// A tip that is cut off: the ring continues from `before` to `after`.
struct Cut {
  std::size_t first = 0, count = 0;  // the points that are dropped
  Point before, after;
};

/// Returns the cut at the corner i, where the two sides are `tip_mm` apart for the first time.
/// `count` is 0 if they never are on a quarter of the ring.
Cut cut_at(const Ring& ring, std::size_t i, double tip_mm) {
  Walker back{ring, i, false}, on{ring, i, true};
  double back_mm = 0.0, on_mm = 0.0;  // on the current edges
  while (back.steps + on.steps < ring.size() / 2) {
    const double step = std::min(back.edge() - back_mm, on.edge() - on_mm);
    if (distance(back.at(back_mm + step), on.at(on_mm + step)) >= tip_mm) {
      double low = 0.0, high = step;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        const bool wide = distance(back.at(back_mm + middle), on.at(on_mm + middle)) >= tip_mm;
        (wide ? high : low) = middle;
      }
      return {back.index(back.steps), back.steps + on.steps + 1, back.at(back_mm + high),
              on.at(on_mm + high)};
    }
    back_mm += step, on_mm += step;
    if (back_mm >= back.edge()) ++back.steps, back_mm = 0.0;
    if (on_mm >= on.edge()) ++on.steps, on_mm = 0.0;
  }
  return {};
}

/// Returns the corners of less than about 47 degrees, the sharpest first. This is no angle that is
/// likely in a symmetric figure, where rounding would decide which of its tips are cut.
std::vector<std::size_t> tips_of(const Ring& ring) {
  constexpr double kMinCosine = 0.68;
  const std::size_t n = ring.size();
  std::vector<std::pair<double, std::size_t>> tips;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec a = normalized(ring[(i + n - 1) % n] - ring[i]);
    const Vec b = normalized(ring[(i + 1) % n] - ring[i]);
    if (dot(a, b) > kMinCosine) tips.emplace_back(-dot(a, b), i);
  }
  std::sort(tips.begin(), tips.end());
  std::vector<std::size_t> corners;
  for (const auto& tip : tips) corners.push_back(tip.second);
  return corners;
}

/// Cuts off all tips that do not overlap. Returns false if there was none. A ring without width
/// becomes empty.
bool cut_tips(Ring& ring, double tip_mm) {
  enum class Mark : std::uint8_t { kFree, kBeside, kDropped };
  const std::size_t n = ring.size();
  std::vector<Mark> marks(n, Mark::kFree);
  std::map<std::size_t, Cut> cuts;  // by first point
  for (const std::size_t corner : tips_of(ring)) {
    if (marks[corner] != Mark::kFree) continue;
    const Cut cut = cut_at(ring, corner, tip_mm);
    if (cut.count == 0 || cut.count + 2 > n) {
      ring.clear();
      return false;
    }
    const auto mark = [&](std::size_t k) -> Mark& { return marks[(cut.first + n - 1 + k) % n]; };
    bool is_free = true;
    for (std::size_t k = 0; k < cut.count + 2; ++k) is_free &= mark(k) == Mark::kFree;
    if (!is_free) continue;
    for (std::size_t k = 1; k <= cut.count; ++k) mark(k) = Mark::kDropped;
    mark(0) = mark(cut.count + 1) = Mark::kBeside;
    cuts.emplace(cut.first, cut);
  }
  Ring rest;
  for (std::size_t i = 0; i < n; ++i) {
    if (const auto cut = cuts.find(i); cut != cuts.end()) {
      rest.insert(rest.end(), {cut->second.before, cut->second.after});
    }
    if (marks[i] != Mark::kDropped) rest.push_back(ring[i]);
  }
  ring = std::move(rest);
  drop_near(ring, 0.5 * tip_mm);
  return !cuts.empty();
}

/// Returns true if two closed segments have a common point. Two parts of one straight line are on
/// sides of each other that are only rounding, so the boxes are compared first.
bool meets(const EdgeGrid::Edge& e, const EdgeGrid::Edge& f) {
  Rect of_e, of_f;
  of_e.extend(e.a), of_e.extend(e.b), of_f.extend(f.a), of_f.extend(f.b);
  if (!of_e.intersects(of_f)) return false;
  const auto side = [](Point a, Point b, Point p) { return cross(b - a, p - a); };
  const double c = side(e.a, e.b, f.a), d = side(e.a, e.b, f.b);
  const double a = side(f.a, f.b, e.a), b = side(f.a, f.b, e.b);
  return !(c * d > 0.0) && !(a * b > 0.0);
}

/// Returns into how many parts a line must be divided so that none turns by more than the spec
/// allows. Its ends say how far it turns, so that the jitter of a hand between them does not count.
int bend_steps(std::span<const Point> part, double length_mm, const RingSpec& spec) {
  if (part.size() < 3 || length_mm < 2.0 * spec.min_edge_mm) return 1;
  const Vec first = part[1] - part[0], last = part.back() - part[part.size() - 2];
  const double turn = std::fabs(std::atan2(cross(first, last), dot(first, last)));
  const double steps = std::min(turn / spec.max_turn_rad, length_mm / spec.min_edge_mm);
  return std::max(1, static_cast<int>(std::ceil(steps)));
}

/// Returns true if the area at the left of the line has a corner at the second point that turns
/// inwards by more than about 20 degrees.
bool is_inner_corner(Point before, Point at, Point after) {
  constexpr double kMinTurnRad = 0.35;
  const Vec in = at - before, out = after - at;
  return std::atan2(cross(in, out), dot(in, out)) < -kMinTurnRad;
}

/// Adds points on the edges at inner corners, nearer and nearer to the corner: the heights are not
/// smooth there, so the triangles must be small.
std::vector<Point> graded(const std::vector<Point>& points, double min_edge_mm) {
  std::vector<std::uint8_t> is_corner(points.size(), 0);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    is_corner[i] = is_inner_corner(points[i - 1], points[i], points[i + 1]) ? 1 : 0;
  }
  std::vector<Point> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && (is_corner[i - 1] || is_corner[i])) {
      const Point a = points[i - 1], b = points[i];
      const double length = distance(a, b);
      std::vector<double> shares;
      for (double share = 0.5; share * length > min_edge_mm; share *= 0.5) {
        if (is_corner[i - 1]) shares.push_back(share);
        if (is_corner[i] && (share < 0.5 || !is_corner[i - 1])) shares.push_back(1.0 - share);
      }
      std::sort(shares.begin(), shares.end());
      for (const double share : shares) all.push_back(lerp(a, b, share));
    }
    all.push_back(points[i]);
  }
  return all;
}

}  // namespace ring_work

Ring fine_ring(std::span<const Cubic> curve, const RingSpec& spec) {
  Ring ring;
  for (const Cubic& c : curve) {
    const int steps = ring_work::steps_of(c, spec.tolerance_mm / 20.0, spec.edge_mm / 3.0);
    for (int k = 0; k < steps; ++k) ring.push_back(evaluate(c, static_cast<double>(k) / steps));
  }
  ring_work::drop_near(ring, 0.5 * spec.tip_mm);
  if (ring.size() < 3) return {};
  // A tip that is cut leaves two corners of 90 degrees or more; more passes are only needed for
  // tips beside each other.
  constexpr int kMaxPasses = 20;
  for (int k = 0; k < kMaxPasses && ring.size() >= 3 && ring_work::cut_tips(ring, spec.tip_mm);) {
    ++k;
  }
  return ring.size() < 3 ? Ring() : ring;
}

std::vector<Point> border_points(std::span<const Point> line, const RingSpec& spec) {
  std::vector<std::uint8_t> keep(line.size());
  mark_simplified(line, spec.tolerance_mm, keep);
  std::vector<Point> points;
  for (std::size_t i = 0, last = 0; i < line.size(); ++i) {
    if (!keep[i]) continue;
    if (i > 0) {
      const auto part = line.subspan(last, i - last + 1);
      const double length = polyline_length(part);
      const int count = std::max(ring_work::bend_steps(part, length, spec),
                                 std::max(1, static_cast<int>(std::ceil(length / spec.edge_mm))));
      for (int k = 1; k < count; ++k) points.push_back(point_at_length(part, length * k / count));
    }
    points.push_back(line[i]);
    last = i;
  }
  const bool is_graded = spec.inner_corners == InnerCorners::kGraded;
  return is_graded ? ring_work::graded(points, spec.min_edge_mm) : points;
}

EdgeGrid::EdgeGrid(std::vector<Edge> edges, double reach_mm)
    : edges_(std::move(edges)), reach_mm_(reach_mm) {
  Rect box;
  for (const Edge& e : edges_) box.extend(e.a), box.extend(e.b);
  if (box.empty()) box = {0.0, 0.0, 0.0, 0.0};
  box = box.inflated(2.0 * reach_mm);
  corner_ = {box.x0, box.y0};
  const double across = std::sqrt(static_cast<double>(edges_.size()) + 1.0);
  cell_mm_ = std::max(box.width(), box.height()) / std::min(across, 512.0);
  columns_ = static_cast<std::size_t>(box.width() / cell_mm_) + 1;
  rows_ = static_cast<std::size_t>(box.height() / cell_mm_) + 1;
  cells_.resize(columns_ * rows_);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const auto [x0, x1] = std::minmax(edges_[i].a.x, edges_[i].b.x);
    const auto [y0, y1] = std::minmax(edges_[i].a.y, edges_[i].b.y);
    for (std::size_t r = row(y0 - reach_mm); r <= row(y1 + reach_mm); ++r) {
      for (std::size_t c = column(x0 - reach_mm); c <= column(x1 + reach_mm); ++c) {
        cells_[r * columns_ + c].push_back(static_cast<std::uint32_t>(i));
      }
    }
  }
}

std::size_t EdgeGrid::column(double x) const {
  const double at = std::floor((x - corner_.x) / cell_mm_);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(columns_ - 1)));
}

std::size_t EdgeGrid::row(double y) const {
  const double at = std::floor((y - corner_.y) / cell_mm_);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(rows_ - 1)));
}

bool EdgeGrid::is_near(Point p) const {
  const auto& cell = cells_[row(p.y) * columns_ + column(p.x)];
  return std::any_of(cell.begin(), cell.end(), [&](std::uint32_t i) {
    return nearest_on_line(edges_[i].a, edges_[i].b, p).distance_squared <= reach_mm_ * reach_mm_;
  });
}

std::pair<std::size_t, std::size_t> EdgeGrid::crossing() const {
  for (const auto& cell : cells_) {
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Edge& e = edges_[cell[k]];
      for (std::size_t m = k + 1; m < cell.size(); ++m) {
        const Edge& f = edges_[cell[m]];
        if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) continue;
        if (ring_work::meets(e, f)) return {cell[k], cell[m]};
      }
    }
  }
  return {0, 0};
}

}  // namespace felt
