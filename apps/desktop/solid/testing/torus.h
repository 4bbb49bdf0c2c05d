#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>

#include "felt/solid/solid.h"

namespace felt::desktop::testing {

/// Returns a torus around the z axis with 2 * around * across triangles. Its outer diameter is
/// 100 mm, that of its hole 20 mm.
inline std::shared_ptr<const Solid> torus(std::uint32_t around, std::uint32_t across) {
  constexpr double kRadiusMm = 30.0, kTubeMm = 20.0, kTurn = 2.0 * std::numbers::pi;
  Solid solid;
  SolidBody& body = solid.bodies.emplace_back();
  body.color = {220, 180, 90, 255};
  for (std::uint32_t n = 0; n < around * across; ++n) {
    const std::uint32_t i = n / across, k = n % across;
    const double a = kTurn * i / around, b = kTurn * k / across;
    const double r = kRadiusMm + kTubeMm * std::cos(b);
    body.points.push_back({r * std::cos(a), r * std::sin(a), kTubeMm * std::sin(b)});
    const std::uint32_t next = (i + 1) % around * across, up = (k + 1) % across;
    const std::uint32_t corner = next + k, opposite = next + up, other = i * across + up;
    body.triangles.push_back({n, corner, opposite});
    body.triangles.push_back({n, opposite, other});
  }
  return std::make_shared<const Solid>(std::move(solid));
}

}  // namespace felt::desktop::testing
