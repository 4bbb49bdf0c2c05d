#include "disc_mesh.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/polyline.h"
#include "felt/geometry/rect.h"

using felt::Point;
using felt::Vec;

namespace {

/// Returns twice the signed area of a triangle.
double turn(Point a, Point b, Point c) {
  return cross(b - a, c - a);
}

/// True if the segments from a to b and from c to d cross, or an end of one lies on the other.
bool crosses(Point a, Point b, Point c, Point d) {
  constexpr double kTouchMm = 1e-9;
  const auto touches = [](Point from, Point to, Point p) {
    return felt::nearest_on_line(from, to, p).distance_squared <= kTouchMm * kTouchMm;
  };
  if (turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0) return true;
  return touches(a, b, c) || touches(a, b, d) || touches(c, d, a) || touches(c, d, b);
}

bool crosses_itself(const std::vector<Point>& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours
      if (crosses(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) return true;
    }
  }
  return false;
}

/// Returns a positive value if p is inside the circle through a, b, c, which are oriented from +x
/// to +y.
double in_circle(Point a, Point b, Point c, Point p) {
  const Vec u = a - p, v = b - p, w = c - p;
  return dot(u, u) * cross(v, w) - dot(v, v) * cross(u, w) + dot(w, w) * cross(u, v);
}

/// Returns the outline oriented from +x to +y, without repeated points, with long edges divided.
std::vector<Point> prepared(std::span<const Point> outline, double step_mm) {
  std::vector<Point> distinct;
  for (const Point p : outline) {
    if (distinct.empty() || distance(distinct.back(), p) > 1e-6) distinct.push_back(p);
  }
  while (distinct.size() > 1 && distance(distinct.front(), distinct.back()) <= 1e-6) {
    distinct.pop_back();
  }
  if (felt::area(distinct) < 0.0) std::reverse(distinct.begin(), distinct.end());
  std::vector<Point> ring;
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const Point a = distinct[i], b = distinct[(i + 1) % distinct.size()];
    const int parts = std::max(1, static_cast<int>(std::ceil(distance(a, b) / step_mm)));
    for (int k = 0; k < parts; ++k) ring.push_back(lerp(a, b, static_cast<double>(k) / parts));
  }
  return ring;
}

}  // namespace

// Triangulates the outline alone, makes that a Delaunay triangulation, inserts a grid of inner
// points one by one, and at last divides the inner edges that still connect outline points.
felt::Result<DiscMesh> DiscMesh::fill(std::span<const Point> outline, double step_mm) {
  DiscMesh mesh;
  mesh.points_ = prepared(outline, step_mm);
  mesh.outline_count_ = static_cast<int>(mesh.points_.size());
  if (mesh.points_.size() < 4 || crosses_itself(mesh.points_) || !mesh.clip_ears()) {
    return felt::fail(felt::ErrorCode::kInvalidData,
                      "the outline is no simple shape: it has no area, or it crosses itself");
  }
  std::vector<Edge> all;
  for (const auto& [edge, triangle] : mesh.at_) all.push_back(edge);
  mesh.make_delaunay(std::move(all));
  mesh.add_grid(step_mm);
  mesh.split_chords();
  return mesh;
}

bool DiscMesh::is_ear(const std::vector<int>& ring, std::size_t k) const {
  const std::size_t n = ring.size();
  const auto at = [&](std::size_t i) { return points_[static_cast<std::size_t>(ring[i % n])]; };
  const Point a = at(k + n - 1), b = at(k), c = at(k + 1);
  if (!(turn(a, b, c) > 0.0)) return false;
  for (std::size_t i = k + 2; i < k + n - 1; ++i) {
    const Point p = at(i);
    if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
  }
  return true;
}

/// Triangulates the outline by cutting off one convex corner after another (Meisters 1975).
bool DiscMesh::clip_ears() {
  std::vector<int> ring;
  for (int i = 0; i < outline_count_; ++i) ring.push_back(i);
  std::size_t k = 0, tried = 0;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    k %= n;
    if (tried > n) return false;
    if (!is_ear(ring, k)) {
      ++k, ++tried;
      continue;
    }
    add(ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]);
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
    tried = 0;
  }
  add(ring[0], ring[1], ring[2]);
  return true;
}

void DiscMesh::set(int triangle, int a, int b, int c) {
  triangles_[static_cast<std::size_t>(triangle)] = {a, b, c};
  at_[{a, b}] = at_[{b, c}] = at_[{c, a}] = triangle;
}

void DiscMesh::add(int a, int b, int c) {
  triangles_.push_back({});
  set(static_cast<int>(triangles_.size()) - 1, a, b, c);
}

int DiscMesh::across(int triangle, Edge edge) const {
  for (const int v : triangles_[static_cast<std::size_t>(triangle)]) {
    if (v != edge.first && v != edge.second) return v;
  }
  return -1;
}

/// Flips edges until no triangle's circumcircle contains the opposite point (Lawson 1977).
void DiscMesh::make_delaunay(std::vector<Edge> suspects) {
  const auto p = [this](int i) { return points_[static_cast<std::size_t>(i)]; };
  for (int flips = 0; !suspects.empty() && flips < 1'000'000;) {
    const Edge e = suspects.back();
    suspects.pop_back();
    const auto left = at_.find(e), right = at_.find({e.second, e.first});
    if (left == at_.end() || right == at_.end()) continue;  // outline, or removed
    const int t = left->second, u = right->second;
    const int a = e.first, b = e.second, c = across(t, e), d = across(u, e);
    const double scale = std::pow(distance(p(a), p(b)) + distance(p(c), p(d)), 4.0);
    if (in_circle(p(a), p(b), p(c), p(d)) <= 1e-9 * scale) continue;
    if (!(turn(p(a), p(d), p(c)) > 0.0 && turn(p(d), p(b), p(c)) > 0.0)) continue;
    at_.erase(left);
    at_.erase({b, a});
    set(t, a, d, c);
    set(u, d, b, c);
    ++flips;
    suspects.insert(suspects.end(), {{a, d}, {d, b}, {b, c}, {c, a}});
  }
}

/// Inserts the points of a triangular grid that are inside and not too near the outline.
void DiscMesh::add_grid(double step_mm) {
  const std::vector<Point> ring(points_.begin(), points_.begin() + outline_count_);
  std::vector<Point> closed = ring;
  closed.push_back(ring.front());
  felt::Rect area;
  for (const Point q : ring) area.extend(q);
  const double row_mm = step_mm * std::sqrt(0.75);
  int row = 0;
  for (double y = area.y0 + 0.5 * row_mm; y < area.y1; y += row_mm, ++row) {
    for (double x = area.x0 + (row % 2 == 0 ? 0.25 : 0.75) * step_mm; x < area.x1; x += step_mm) {
      const double away = std::sqrt(felt::nearest_on_polyline(closed, {x, y}).distance_squared);
      if (away > 0.6 * step_mm && felt::contains(ring, {x, y}, felt::FillRule::kEvenOdd)) {
        add_inside({x, y});
      }
    }
  }
}

/// Divides the triangle that contains a point. A point on an edge is skipped, because the grid has
/// enough others.
void DiscMesh::add_inside(Point q) {
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto [a, b, c] = triangles_[i];
    const auto share = [&](int from, int to) {
      return turn(points_[static_cast<std::size_t>(from)], points_[static_cast<std::size_t>(to)],
                  q);
    };
    const double least = 1e-6 * (share(a, b) + share(b, c) + share(c, a));
    if (!(share(a, b) > least && share(b, c) > least && share(c, a) > least)) continue;
    const int v = static_cast<int>(points_.size());
    points_.push_back(q);
    set(static_cast<int>(i), a, b, v);
    add(b, c, v);
    add(c, a, v);
    make_delaunay({{a, b}, {b, c}, {c, a}});
    return;
  }
}

/// Adds a point on each inner edge that connects two points of the outline.
void DiscMesh::split_chords() {
  std::vector<Edge> chords;
  for (const auto& [edge, triangle] : at_) {
    if (edge.first < edge.second && edge.second < outline_count_ &&
        at_.contains({edge.second, edge.first})) {
      chords.push_back(edge);
    }
  }
  for (const auto& [a, b] : chords) {
    const int t = at_.at({a, b}), u = at_.at({b, a});
    const int c = across(t, {a, b}), d = across(u, {a, b});
    const int v = static_cast<int>(points_.size());
    points_.push_back(
        lerp(points_[static_cast<std::size_t>(a)], points_[static_cast<std::size_t>(b)], 0.5));
    at_.erase({a, b});
    at_.erase({b, a});
    set(t, a, v, c);
    add(v, b, c);
    set(u, b, v, d);
    add(v, a, d);
  }
}
