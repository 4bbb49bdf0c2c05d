#pragma once

#include <cmath>
#include <numbers>

#include "felt/geometry/point.h"

namespace felt {

/// Angle between two directions of a straight line that is drawn in steps, in degrees.
inline constexpr double kDirectionStepDeg = 15.0;

/// Returns the vector nearest to `way` whose angle to the x axis is a multiple of
/// kDirectionStepDeg. Vectors along the axes are exact.
inline Vec in_direction_steps(Vec way) noexcept {
  const double step = kDirectionStepDeg * std::numbers::pi / 180.0;
  const double angle = step * std::round(std::atan2(way.y, way.x) / step);
  const auto clean = [](double x) { return std::abs(x) < 1e-12 ? 0.0 : x; };
  const Vec along{clean(std::cos(angle)), clean(std::sin(angle))};
  return dot(way, along) * along;
}

}  // namespace felt
