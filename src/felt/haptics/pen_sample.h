#pragma once

#include <cstdint>
#include <optional>

#include "felt/geometry/vec3.h"

namespace felt {

/// What a device says of the pen at one tick. Sheet frame: the drawing plane is z = 0, a pressing
/// pen has z < 0 (architecture section 3).
struct PenSample {
  std::int64_t time_ns = 0;        ///< since the drawing session began
  Vec3 position;                   ///< mm
  Vec3 velocity;                   ///< mm/s, low-passed; 0 where nothing is known
  std::optional<double> pressure;  ///< 0..1, only from devices that sense it
  std::uint32_t buttons = 0;       ///< bit i is set while button i is down
  /// Between the pen and the upright, degrees, 0..90; only from devices that know it.
  std::optional<double> lean_deg{};

  friend constexpr bool operator==(const PenSample&, const PenSample&) noexcept = default;
};

/// Depth of the pen in the plane, mm, never negative.
constexpr double depth_mm(const PenSample& sample) noexcept {
  return sample.position.z < 0.0 ? -sample.position.z : 0.0;
}

/// True where the pen touches: below the plane, or pressing by its own account (architecture
/// section 7).
constexpr bool in_contact(const PenSample& sample) noexcept {
  return sample.position.z < 0.0 || sample.pressure.value_or(0.0) > 0.0;
}

}  // namespace felt
