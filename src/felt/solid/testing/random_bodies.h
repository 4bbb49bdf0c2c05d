#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

#include "felt/base/check.h"
#include "felt/base/random.h"
#include "felt/solid/inflate.h"
#include "felt/solid/testing/solid_drawings.h"

namespace felt::testing {

/// Returns the body of a random lumpy outline about the origin of its frame, of 20 to 60 mm, with
/// about `triangles` triangles.
inline SolidBody random_body(Random& random, int triangles = 2000) {
  for (;;) {
    SolidDrawing drawing;
    const double size = random.between(20.0, 60.0);
    const int count = 5 + static_cast<int>(random.between(0.0, 8.0));
    drawing.add(stroke_of(smooth_ring(lumps(random, {0, 0}, size, count, 0.5)), true));
    Result<InflatedDrawing> inflated = inflate(drawing.document, {.triangles = triangles});
    if (inflated && inflated->solid.bodies.size() == 1) return inflated->solid.bodies.front();
  }
}

/// Returns a ball of this radius about the origin.
inline SolidBody ball(double radius_mm, int triangles = 2000) {
  SolidDrawing drawing;
  drawing.circle({0, 0}, radius_mm);
  Result<InflatedDrawing> inflated = inflate(drawing.document, {.triangles = triangles});
  FELT_CHECK(inflated.has_value());
  return inflated->solid.bodies.front();
}

/// Returns a random unit vector.
inline Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double length = norm(v);
    if (length > 0.1 && length < 1.0) return (1.0 / length) * v;
  }
}

}  // namespace felt::testing
