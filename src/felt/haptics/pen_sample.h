#pragma once

#include <cstdint>
#include <optional>

#include "felt/geometry/point.h"
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

/// Velocity from positions as a driver makes it: first differences through a first-order low-pass
/// (specification decision 3.5: 100 Hz). Backward Euler, v += (dx/dt - v) dt / (tau + dt): stable
/// and without overshoot for every dt, and without a transcendental function.
///
/// Real-time safe, trivially copyable.
class VelocityFilter {
 public:
  static constexpr double kDefaultCutoffHz = 100.0;

  /// A cut-off of 0 or less, or NaN, switches the low-pass off.
  explicit constexpr VelocityFilter(double cutoff_hz = kDefaultCutoffHz) noexcept
      : time_constant_s_(cutoff_hz > 0.0 ? 1.0 / (6.283185307179586 * cutoff_hz) : 0.0) {}

  /// Forgets everything; the next position starts at rest.
  constexpr void reset() noexcept { has_last_ = false; }
  /// The next position (mm), dt_s after the last one. Returns the velocity in mm/s. Where no time
  /// has passed, the last one stays.
  constexpr Vec3 update(const Vec3& position_mm, double dt_s) noexcept {
    if (!has_last_) {
      velocity_ = {};
      last_ = position_mm;
      has_last_ = true;
    } else if (dt_s > 0.0) {
      velocity_ += ((position_mm - last_) - dt_s * velocity_) * (1.0 / (time_constant_s_ + dt_s));
      last_ = position_mm;
    }
    return velocity_;
  }
  [[nodiscard]] constexpr const Vec3& velocity() const noexcept { return velocity_; }

 private:
  double time_constant_s_;
  Vec3 last_;
  Vec3 velocity_;
  bool has_last_ = false;
};

/// Speeds below this are not damped.
inline constexpr double kUnknownSpeedMmPerS = 6.0;

/// The velocity in the sheet that dampers may trust: shortened by 6 mm/s, zero below.
///
/// One step of a position sensor (0.03 mm) shows in a velocity low-passed at 100 Hz as 12 mm/s at
/// 1 kHz and 17 mm/s at 5 kHz, whether the pen made a step or crept over an edge. At rest, dampers
/// of 3 N s/m in sum turn that into kicks that keep a frictionless pen dancing between two steps:
/// 0.031 N above 30 Hz at 1 kHz and 0.038 N at 5 kHz beside stiffnesses of 900 N/m, and with this
/// 0.018 and 0.023 N (spring_test.cc holds the bound). What is left undamped is smaller than 0.05
/// mm at 20 Hz. Shortening keeps the direction, so a damper still only takes energy.
inline Vec known_velocity(const PenSample& sample) noexcept {
  const Vec v = in_plane(sample.velocity);
  const double speed = norm(v);
  return speed > kUnknownSpeedMmPerS ? ((speed - kUnknownSpeedMmPerS) / speed) * v : Vec{};
}

}  // namespace felt
