#pragma once

#include <memory>
#include <vector>

#include "desktop/engine/studio.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::testing {

/// Adds straight lines between each point and the next one, each line as one stroke, all as one
/// step of undo. Each line is shorter than that by `gap_mm`, at its end.
inline void draw_lines(Studio& studio, const std::vector<Point>& corners, double gap_mm = 0.0) {
  std::vector<StrokePtr> strokes;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec along = corners[i] - corners[i - 1];
    const Point end = corners[i] - gap_mm / norm(along) * along;
    strokes.push_back(std::make_shared<const Stroke>(
        felt::testing::straight_stroke(corners[i - 1], end, 1.0, 1.0)));
  }
  studio.import(QStringLiteral("test"), strokes);
}

/// Adds a square of four lines.
inline void draw_square(Studio& studio, Point corner, double side_mm, double gap_mm = 0.0) {
  const auto [x, y] = corner;
  draw_lines(studio,
             {corner, {x + side_mm, y}, {x + side_mm, y + side_mm}, {x, y + side_mm}, corner},
             gap_mm);
}

inline StudioOptions without_threads() {
  StudioOptions options;
  options.live = false;
  return options;
}

}  // namespace felt::desktop::testing
