#include "tests/support/fit_ink_polyline.h"

#include <functional>
#include <numeric>

namespace fit_check {
namespace {

std::vector<Point> without_repeats(const std::vector<Point>& samples) {
  std::vector<Point> vertices;
  for (const Point& p : samples) {
    if (vertices.empty() || !(vertices.back() == p)) vertices.push_back(p);
  }
  if (vertices.size() == 1) vertices.push_back(vertices.front());  // a dot: one line of length 0
  return vertices;
}

std::vector<Box> edge_boxes(const std::vector<Point>& vertices) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    boxes.push_back(box_of_line(vertices[i], vertices[i + 1]));
  }
  return boxes;
}

/// Returns the first point on the line from a to b that is `radius` away from `center`. Requires
/// that a is inside the circle and b is not.
Point crossing(Point center, double radius, Point a, Point b) {
  const Point d = b - a, m = a - center;
  const double dd = dot(d, d), md = dot(m, d);
  const double root = std::sqrt(std::max(0.0, md * md - dd * (dot(m, m) - radius * radius)));
  return a + std::clamp((root - md) / dd, 0.0, 1.0) * d;
}

}  // namespace

InkPolyline::InkPolyline(const std::vector<Point>& samples)
    : vertices_(without_repeats(samples)), edges_(edge_boxes(vertices_)) {
  by_length_.resize(vertices_.empty() ? 0 : vertices_.size() - 1);
  std::iota(by_length_.begin(), by_length_.end(), std::size_t{0});
  std::ranges::stable_sort(by_length_, std::greater<>(),
                           [&](std::size_t edge) { return edge_length(edge); });
}

double InkPolyline::edge_length(std::size_t edge) const {
  return length(vertices_[edge + 1] - vertices_[edge]);
}

InkPolyline::Nearest InkPolyline::nearest(Point p, std::size_t& hint) const {
  const auto distance_to = [&](std::size_t i) {
    return distance_to_line(vertices_[i], vertices_[i + 1], p);
  };
  const std::size_t edge_count = vertices_.size() - 1;
  hint = std::min(hint, edge_count - 1);
  double best = distance_to(hint);
  edges_.search(p, best, [&](std::size_t i) {
    const double d = distance_to(i);
    if (d < best) {
      best = d;
      hint = i;
    }
    return best;
  });
  const double t = nearest_on_line(vertices_[hint], vertices_[hint + 1], p);
  double gap = edge_length(hint);
  if (t <= 0.0 && hint > 0) gap = std::max(gap, edge_length(hint - 1));
  if (t >= 1.0 && hint + 1 < edge_count) gap = std::max(gap, edge_length(hint + 1));
  return {best, gap};
}

Point InkPolyline::follow(std::size_t from, std::ptrdiff_t step, double arm) const {
  const Point center = vertices_[from];
  const auto end = step < 0 ? std::ptrdiff_t{0} : static_cast<std::ptrdiff_t>(vertices_.size()) - 1;
  Point last = center;
  for (auto i = static_cast<std::ptrdiff_t>(from); i != end;) {
    i += step;
    const Point next = vertices_[static_cast<std::size_t>(i)];
    if (length(next - center) >= arm) return crossing(center, arm, last, next);
    last = next;
  }
  return last;
}

InkPolyline::Turn InkPolyline::turn_at(std::size_t vertex, double arm) const {
  const Point in = vertices_[vertex] - follow(vertex, -1, arm);
  const Point out = follow(vertex, +1, arm) - vertices_[vertex];
  return {turn_deg(in, out), length(in) < arm / 2.0 || length(out) < arm / 2.0};
}

std::vector<std::size_t> InkPolyline::vertices_near(Point p, double radius) const {
  std::vector<std::size_t> near;
  edges_.search(p, radius, [&](std::size_t edge) {
    // Only the start of each line is tested, because its end is the start of the next line. The
    // last vertex starts no line; it is not needed because the ink cannot turn there.
    if (length(vertices_[edge] - p) <= radius) near.push_back(edge);
    return radius;
  });
  if (near.empty()) {
    std::size_t edge = 0;
    (void)nearest(p, edge);
    near = {edge, edge + 1};
  }
  std::sort(near.begin(), near.end());
  return near;
}

InkPolyline::Turn InkPolyline::turn_near(Point p, double radius, double arm) const {
  const std::vector<std::size_t> near = vertices_near(p, radius);
  const std::size_t stride = (near.size() + kMaxVerticesTried - 1) / kMaxVerticesTried;
  Turn best;
  for (std::size_t i = 0; i < near.size(); i += stride) {
    const Turn turn = turn_at(near[i], arm);
    if (turn.degrees >= best.degrees) best = turn;
  }
  return best;
}

}  // namespace fit_check
