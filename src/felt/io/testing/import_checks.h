#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/io/import.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/stroke/outline/outline.h"

/// Helpers for the tests of several readers and writers of ink.
namespace felt::testing {

inline std::vector<std::string> texts(const ImportReport& report) {
  std::vector<std::string> all;
  for (const ImportNotice& n : report.notices()) all.push_back(notice_text(n));
  return all;
}

/// Returns all notices, one on each line.
inline std::string notice_lines(const Imported& imported) {
  std::string text;
  for (const std::string& line : texts(imported.report)) text += line + "\n";
  return text;
}

inline Stroke only_stroke(const Imported& d) {
  EXPECT_EQ(d.drawing.document.layers().size(), 1u);
  EXPECT_EQ(d.drawing.document.stroke_count(), 1u);
  return strokes_in(d.drawing.document).at(0);
}

/// Returns the largest distance, in mm, of a point on the centre line of a from the centre line of
/// b.
inline double distance_of(const Stroke& a, const Stroke& b) {
  std::vector<Dab> from, to;
  flatten(a, 0.002, from);
  flatten(b, 0.002, to);
  double largest = 0.0;
  for (const Dab& dab : from) {
    double smallest = distance(dab.center, to[0].center);
    for (std::size_t i = 1; i < to.size(); ++i) {
      const Point p = to[i - 1].center;
      const Vec way = to[i].center - p;
      const double t =
          std::clamp(dot(dab.center - p, way) / std::max(norm_squared(way), 1e-30), 0.0, 1.0);
      smallest = std::min(smallest, distance(dab.center, p + t * way));
    }
    largest = std::max(largest, smallest);
  }
  return largest;
}

}  // namespace felt::testing
