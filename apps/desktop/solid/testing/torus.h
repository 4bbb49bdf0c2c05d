#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "felt/solid/solid.h"

namespace felt::desktop::testing {

/// Returns a torus around the z axis with 2 * around * across triangles. Its outer diameter is
/// 100 mm, that of its hole 20 mm.
inline std::shared_ptr<const Solid> torus(std::uint32_t around, std::uint32_t across,
                                          Rgba color = {220, 180, 90, 255}) {
  constexpr double kRadiusMm = 30.0, kTubeMm = 20.0, kTurn = 2.0 * std::numbers::pi;
  Solid solid;
  SolidBody& body = solid.bodies.emplace_back();
  body.color = color;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t k = 0; k < across; ++k) {
      const double a = kTurn * i / around, b = kTurn * k / across;
      const double r = kRadiusMm + kTubeMm * std::cos(b);
      body.points.push_back({r * std::cos(a), r * std::sin(a), kTubeMm * std::sin(b)});
      const auto at = [&](std::uint32_t di, std::uint32_t dk) {
        return (i + di) % around * across + (k + dk) % across;
      };
      body.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
      body.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  }
  return std::make_shared<const Solid>(std::move(solid));
}

}  // namespace felt::desktop::testing
