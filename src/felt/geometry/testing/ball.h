#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "felt/geometry/triangle_tree.h"

namespace felt::testing {

/// Returns the surface of an ellipsoid with half axes `half_mm`, as 2 * around * (across - 1)
/// triangles whose fronts point outwards. Its poles are at the left and at the right.
inline std::vector<Triangle3> ball(const Vec3& middle, const Vec3& half_mm, int around,
                                   int across) {
  const auto at = [&](int i, int k) {
    const double a = 2.0 * std::numbers::pi * (i % around) / around;
    const double b = std::numbers::pi * k / across;
    const bool is_pole = k == 0 || k == across;
    const double ring = is_pole ? 0.0 : std::sin(b);
    return middle + Vec3{half_mm.x * std::cos(b), half_mm.y * ring * std::cos(a),
                         half_mm.z * ring * std::sin(a)};
  };
  std::vector<Triangle3> all;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      if (k > 0) all.push_back({at(i, k), at(i, k + 1), at(i + 1, k)});
      if (k + 1 < across) all.push_back({at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)});
    }
  }
  return all;
}

}  // namespace felt::testing
