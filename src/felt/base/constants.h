#pragma once

#include <cstdint>
#include <limits>
#include <numbers>

namespace felt {

/// One millisecond and one second, in nanoseconds.
inline constexpr std::int64_t kMs = 1'000'000;
inline constexpr std::int64_t kSecond = 1'000'000'000;
inline constexpr double kMsPerS = 1000.0;

inline constexpr double kMmPerM = 1000.0;
inline constexpr double kMPerMm = 0.001;

/// A full turn, in radians.
inline constexpr double kTau = 2.0 * std::numbers::pi;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();
/// The distance from 1.0 to the next larger double.
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace felt
