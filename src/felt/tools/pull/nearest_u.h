#pragma once

#include "felt/geometry/nearest.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Returns the parameter of the point of a stroke nearest to p.
inline double nearest_u(const Stroke& stroke, Point p) {
  double best = 0.0, smallest = distance_squared(stroke.position(0.0), p);
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const auto near = nearest_within(stroke.segment(i), p, smallest);
    if (!near) continue;
    best = i + near->t;
    smallest = near->distance_squared;
  }
  return best;
}

}  // namespace felt
