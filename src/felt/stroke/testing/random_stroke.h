#pragma once

#include <cstdint>
#include <random>

#include "felt/stroke/stroke.h"

namespace felt::testing {

/// Makes valid strokes of every shape, for property tests: smooth and sharp joints, zero handles,
/// cusps and loops, open and closed, few and many width breakpoints. The same seed gives the same
/// stroke.
class RandomStroke {
 public:
  explicit RandomStroke(std::uint64_t seed) : random_(seed) {}

  StrokeData make() {
    StrokeData d;
    d.closed = chance(0.3);
    const int n = pick(1, 6);
    d.points.push_back(place());
    for (int i = 0; i < n; ++i) {
      const bool smooth = i > 0 && chance(0.6);
      if (i > 0) d.joints.push_back(smooth ? JointKind::kSmooth : JointKind::kCorner);
      add_segment(d, smooth, d.closed && i == n - 1);
    }
    if (d.closed) d.joints.push_back(JointKind::kCorner);
    add_widths(d, n);
    d.color = {static_cast<std::uint8_t>(pick(0, 255)), 20, 30,
               static_cast<std::uint8_t>(pick(0, 255))};
    return d;
  }

  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }
  int pick(int a, int b) { return std::uniform_int_distribution<int>(a, b)(random_); }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }

 private:
  Point place() { return {uniform(0.0, 20.0), uniform(0.0, 20.0)}; }
  Vec handle() { return {uniform(-8.0, 8.0), uniform(-8.0, 8.0)}; }

  void add_segment(StrokeData& d, bool smooth, bool home) {
    const Point a = d.points.back();
    const Point b = home ? d.points.front() : place();
    Point h1 = a + handle();
    if (smooth) {
      const std::size_t k = d.points.size() - 1;
      Vec in = a - d.points[k - 1];
      if (norm(in) == 0.0) in = a - d.points[k - 2];
      if (norm(in) == 0.0) in = a - d.points[k - 3];
      h1 = a + uniform(0.1, 8.0) * normalized(in);
    } else if (chance(0.2)) {
      h1 = a;
    }
    // A ring of one segment needs a handle; otherwise it is a point.
    const Point h2 = chance(0.15) && b != a ? b : b + handle();
    d.points.insert(d.points.end(), {h1, h2, b});
  }

  void add_widths(StrokeData& d, int n) {
    const double widest = chance(0.3) ? 8.0 : 1.5;
    const bool has_tone = chance(0.5);
    const auto knot = [&](double u) {
      WidthKnot k{u, uniform(0.05, widest)};
      if (has_tone) k.tone = uniform(0.0, 1.0);
      return k;
    };
    d.widths.push_back(knot(0.0));
    for (int k = pick(0, 2 * n); k > 0; --k) {
      const double u = d.widths.back().u + uniform(0.001, 1.0);
      if (u < n) d.widths.push_back(knot(u));
    }
    d.widths.push_back(knot(n));
  }

  std::mt19937_64 random_;
};

/// Returns a valid stroke from a seed.
inline Stroke random_stroke(std::uint64_t seed) {
  return Stroke::create(RandomStroke(seed).make()).value();
}

/// Returns a straight stroke of one segment from a to b with widths from w0 to w1.
inline Stroke straight_stroke(Point a, Point b, double w0, double w1) {
  const Cubic c = straight(a, b);
  return Stroke::create({.points = {c.p.begin(), c.p.end()},
                         .joints = {},
                         .closed = false,
                         .widths = {{0.0, w0}, {1.0, w1}}})
      .value();
}

/// Returns a stroke of straight segments through points, 1 mm wide, with corners. A closed one must
/// end at its first point.
inline Stroke polyline_stroke(const std::vector<Point>& points, bool closed = false) {
  StrokeData data{.points = {points.front()}, .joints = {}, .closed = closed, .widths = {}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Cubic c = straight(points[i - 1], points[i]);
    data.points.insert(data.points.end(), c.p.begin() + 1, c.p.end());
    if (i > 1 || closed) data.joints.push_back(JointKind::kCorner);
  }
  data.widths = {{0.0, 1.0}, {static_cast<double>(points.size() - 1), 1.0}};
  return Stroke::create(std::move(data)).value();
}

}  // namespace felt::testing
