#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::testing {

/// A curve as a function of its parameter 0..1.
using Way = std::function<Point(double)>;

inline Way circle_arc(Point center, double radius, double from_deg, double to_deg) {
  return [=](double t) {
    const double a = (from_deg + (to_deg - from_deg) * t) * std::numbers::pi / 180.0;
    return center + radius * Vec{std::cos(a), std::sin(a)};
  };
}
/// Returns two periods of a wave of 50 mm.
inline Way wave() {
  return [](double t) { return Point{100 * t, 50 + 8 * std::sin(4 * std::numbers::pi * t)}; };
}

/// How the hand deviates from its path.
struct Jitter {
  double rms_mm = 0.2;
  /// If 0, the samples are independent; otherwise they form waves of about this length, as from
  /// tremor.
  double wave_mm = 0.0;
};

/// Returns ink along a path as the pencil would fit it, with a sample every quarter millimetre.
inline Stroke jittery(const Way& way, const Jitter& jitter, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  double length = 0.0;
  for (int i = 0; i < 1000; ++i) length += distance(way(0.001 * i), way(0.001 * (i + 1)));
  const int n = std::max(4, static_cast<int>(4.0 * length));
  // Adds two waves per axis, one a tenth shorter and one a tenth longer than wave_mm.
  double phases[4], sizes[4];
  for (double& p : phases) p = 2.0 * std::numbers::pi * uniform(random);
  for (double& s : sizes) s = 0.7 + 0.6 * uniform(random);
  InkFitter fitter(InkFitOptions{});
  fitter.begin();
  for (int i = 0; i <= n; ++i) {
    const double s = length * i / n;
    Vec off;
    if (jitter.wave_mm > 0.0) {
      const double k = 2.0 * std::numbers::pi / jitter.wave_mm;
      off = {sizes[0] * std::sin(0.9 * k * s + phases[0]) +
                 sizes[1] * std::sin(1.1 * k * s + phases[1]),
             sizes[2] * std::sin(0.9 * k * s + phases[2]) +
                 sizes[3] * std::sin(1.1 * k * s + phases[3])};
    } else {
      const double x = normal(random), y = normal(random);
      off = {x, y};
    }
    fitter.push({way(static_cast<double>(i) / n) + jitter.rms_mm * off,
                 0.5 + 0.3 * std::sin(0.1 * s), std::int64_t{2'500'000} * i});
  }
  fitter.end();
  fitter.refine();
  return fitter.stroke().value();
}

/// Returns the rms distance of a stroke from a path between these fractions of its parameter range,
/// mm.
inline double rms_from(const Stroke& stroke, const Way& way, double from = 0.0, double to = 1.0) {
  std::vector<Point> line;
  for (int i = 0; i <= 4000; ++i) line.push_back(way(i / 4000.0));
  double sum = 0.0;
  int count = 0;
  const double n = stroke.segment_count();
  for (int i = 0; i <= 1000; ++i) {
    const double u = n * (from + (to - from) * i / 1000.0);
    sum += nearest_on_polyline(line, stroke.position(u)).distance_squared;
    ++count;
  }
  return std::sqrt(sum / count);
}

}  // namespace felt::testing
