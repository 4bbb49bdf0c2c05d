#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "felt/stroke/fit/curve_fitter.h"

namespace felt::testing {

/// Returns the curve that the online fit makes from the samples.
inline FittedCurve fit_online(std::span<const Point> ink, double tolerance_mm) {
  CurveFitter fitter({.tolerance_mm = tolerance_mm});
  fitter.begin();
  for (const Point p : ink) fitter.push(p);
  fitter.end();
  return fitter.curve();
}

/// Returns the samples of the ink that a fit keeps.
inline SampleWindow window_of(const std::vector<Point>& ink, double tolerance_mm) {
  KeptSamples kept(tolerance_mm, 0.125 * tolerance_mm);
  for (const Point p : ink) kept.add(p);
  SampleWindow window(ink.size());
  for (std::size_t i = 0; i < kept.size(); ++i) window.add(kept, i);
  return window;
}

/// Returns the point of the curve at stroke parameter u.
inline Point place_at(const FittedCurve& curve, double u) {
  const int i = std::clamp(static_cast<int>(u), 0, curve.segment_count() - 1);
  return evaluate(curve.segment(i), u - i);
}

/// Returns the largest distance of a sample from its point on the curve. Requires such a point for
/// each sample.
inline double worst_error(const FittedCurve& curve, std::span<const Point> ink) {
  double worst = 0.0;
  for (std::size_t i = 0; i < ink.size(); ++i) {
    worst = std::max(worst, distance(place_at(curve, curve.sample_u[i]), ink[i]));
  }
  return worst;
}

/// Returns true if every sample has a parameter on the curve, in order, between its ends.
inline bool has_all_places(const FittedCurve& curve, std::size_t samples) {
  const std::vector<double>& u = curve.sample_u;
  return u.size() == samples && std::is_sorted(u.begin(), u.end()) &&
         (u.empty() || (u.front() >= 0.0 && u.back() <= curve.segment_count()));
}

/// Returns the turn of the tangent in degrees at the joint before segment i.
inline double joint_turn_deg(const FittedCurve& curve, int i) {
  const Vec in = tangent(curve.segment(i - 1), 1.0), out = tangent(curve.segment(i), 0.0);
  return angle_between(in, out) * (180.0 / std::numbers::pi);
}

/// Returns the largest turn at a joint that is declared smooth, in degrees.
inline double worst_smooth_turn_deg(const FittedCurve& curve) {
  double worst = 0.0;
  for (int i = 1; i < curve.segment_count(); ++i) {
    if (curve.joints[static_cast<std::size_t>(i - 1)] == JointKind::kSmooth) {
      worst = std::max(worst, joint_turn_deg(curve, i));
    }
  }
  return worst;
}

/// Returns the positions of the joints that are declared corners.
inline std::vector<Point> corners_of(const FittedCurve& curve) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < curve.joints.size(); ++i) {
    if (curve.joints[i] == JointKind::kCorner) corners.push_back(curve.points[3 * i + 3]);
  }
  return corners;
}

inline double distance_to_line(Point p, Point a, Point b) {
  const Vec along = b - a;
  const double squared = norm_squared(along);
  const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return distance(p, a + t * along);
}

/// Returns the distance of p from a polyline, by brute force.
inline double distance_to_polyline(Point p, std::span<const Point> points) {
  if (points.size() == 1) return distance(p, points[0]);
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points.size(); ++i) {
    best = std::min(best, distance_to_line(p, points[i - 1], points[i]));
  }
  return best;
}

/// Returns `steps` points of each segment, and the end of the curve.
inline std::vector<Point> dense_points(const FittedCurve& curve, int steps) {
  std::vector<Point> dense;
  for (int i = 0; i < curve.segment_count(); ++i) {
    for (int k = 0; k < steps; ++k) {
      dense.push_back(evaluate(curve.segment(i), static_cast<double>(k) / steps));
    }
  }
  if (!curve.points.empty()) dense.push_back(curve.points.back());
  return dense;
}

/// Returns the largest distance of a point of the curve from the polyline of the ink, minus the gap
/// between its two neighbouring samples: a deviation that the ink does not explain.
inline double worst_overshoot(const FittedCurve& curve, std::span<const Point> ink) {
  constexpr int kSteps = 16;
  const std::vector<Point> dense = dense_points(curve, kSteps);
  double worst = 0.0;
  std::size_t next = 0;  // the first sample past the point
  for (std::size_t k = 0; k < dense.size(); ++k) {
    const double u = static_cast<double>(k) / kSteps;
    while (next < ink.size() && curve.sample_u[next] <= u) ++next;
    const bool is_between = next > 0 && next < ink.size();
    const double gap = is_between ? distance(ink[next - 1], ink[next]) : 0.0;
    worst = std::max(worst, distance_to_polyline(dense[k], ink) - gap);
  }
  return worst;
}

}  // namespace felt::testing
