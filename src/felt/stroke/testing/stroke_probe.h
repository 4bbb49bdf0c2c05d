#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/stroke/stroke.h"

/// For tests: shared strokes, and measurements that do not use the tested code.
namespace felt::testing {

inline std::shared_ptr<const Stroke> share(Stroke stroke) {
  return std::make_shared<const Stroke>(std::move(stroke));
}

inline double distance_to(const Stroke& stroke, Point p) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < stroke.segment_count(); ++i) {
    best = std::min(best, nearest(stroke.segment(i), p).distance_squared);
  }
  return std::sqrt(best);
}

inline double length_of(const Stroke& stroke) {
  double length = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    length += arc_length(stroke.segment(i));
  }
  return length;
}

}  // namespace felt::testing
