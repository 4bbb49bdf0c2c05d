#pragma once

#include <cmath>
#include <random>
#include <utility>

#include "felt/stroke/stroke.h"

namespace felt::testing {

/// Returns strokes of 1 to 8 segments, about 125 px long and 1 to 6 px wide, anywhere on a full-HD
/// screen at 4 px/mm: the scene with which rasterisers were compared.
inline std::vector<Stroke> screen_of_strokes(int count) {
  std::mt19937_64 random(1);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  std::vector<Stroke> strokes;
  for (int k = 0; k < count; ++k) {
    const int n = 1 + static_cast<int>(uniform(0.0, 8.0));
    StrokeData d;
    d.points.push_back({uniform(0.0, 480.0), uniform(0.0, 270.0)});
    double angle = uniform(0.0, 6.28);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < 3; ++j) {
        d.points.push_back(d.points.back() + 2.3 * Vec{std::cos(angle), std::sin(angle)});
        if (j == 1 || i == 0) angle += uniform(-0.7, 0.7);
      }
      if (i > 0) d.joints.push_back(JointKind::kCorner);
      d.widths.push_back({static_cast<double>(i), uniform(0.25, 1.5)});
    }
    d.widths.push_back({static_cast<double>(n), uniform(0.25, 1.5)});
    d.color = {30, 30, 90, 128};
    strokes.push_back(Stroke::create(std::move(d)).value());
  }
  return strokes;
}

}  // namespace felt::testing
