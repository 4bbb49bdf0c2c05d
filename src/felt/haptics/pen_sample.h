#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "felt/geometry/point.h"
#include "felt/geometry/vec3.h"

namespace felt {

/// The data that a device reports about the pen at one tick. Positions are in the frame of the
/// surface: the drawing plane is z = 0, and a pressing pen has z < 0
/// (docs/design/loop.md#pen-contact).
struct PenSample {
  std::int64_t time_ns = 0;        ///< since the drawing session began
  Vec3 position;                   ///< mm
  Vec3 velocity;                   ///< mm/s, low-pass filtered; 0 if unknown
  std::optional<double> pressure;  ///< 0..1, only from devices that sense it
  std::uint32_t buttons = 0;       ///< bit i is set while button i is pressed
  /// Tilt: the angle between the pen and the normal of the surface, degrees, 0..90. Only from
  /// devices that sense it.
  std::optional<double> tilt_deg{};

  friend constexpr bool operator==(const PenSample&, const PenSample&) noexcept = default;
};

/// Returns the depth of the pen below the plane, mm; never negative.
constexpr double depth_mm(const PenSample& sample) noexcept {
  return sample.position.z < 0.0 ? -sample.position.z : 0.0;
}

/// Returns true if the pen touches the surface: it is below the plane, or it reports pressure
/// (docs/design/loop.md#pen-contact).
constexpr bool in_contact(const PenSample& sample) noexcept {
  return sample.position.z < 0.0 || sample.pressure.value_or(0.0) > 0.0;
}

/// Changes the sample to one of the same pen 1 mm or more above the surface.
constexpr void lift(PenSample& sample) noexcept {
  sample.position.z = std::max(sample.position.z, 1.0);
  if (sample.pressure) sample.pressure = 0.0;
}

/// Computes a velocity from positions, as drivers do: first differences through a first-order
/// low-pass filter (docs/design/forces.md#plane: 100 Hz). It uses backward Euler, v += (dx/dt - v)
/// dt / (tau + dt), because that is stable and does not overshoot for any dt, and needs no
/// transcendental function.
///
/// It is real-time safe and trivially copyable.
class VelocityFilter {
 public:
  static constexpr double kDefaultCutoffHz = 100.0;

  /// Makes a filter. If the cut-off is 0 or less, or NaN, velocities are not filtered.
  explicit constexpr VelocityFilter(double cutoff_hz = kDefaultCutoffHz) noexcept
      : time_constant_s_(cutoff_hz > 0.0 ? 1.0 / (6.283185307179586 * cutoff_hz) : 0.0) {}

  /// Forgets all state. The velocity is 0 now, and at the next position.
  constexpr void reset() noexcept {
    has_last_ = false;
    velocity_ = {};
  }
  /// Adds a position (mm), measured dt_s after the previous one, and returns the velocity in mm/s.
  /// If no time has passed, the velocity does not change.
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

/// The part of a speed that dampers ignore, because it may be an error of the sensor.
inline constexpr double kUnknownSpeedMmPerS = 6.0;

/// Returns the velocity along the surface that dampers may rely on: the measured one shortened by 6
/// mm/s, or zero if the pen is slower than that.
///
/// After the low-pass filter at 100 Hz, one step of a position sensor (0.03 mm) appears as a
/// velocity of 12 mm/s on a loop at 1 kHz, and of 17 mm/s at 5 kHz. This happens even if the pen
/// only crept over the edge between two steps. At rest, dampers of 3 N s/m in total turn these
/// velocities into kicks that keep a frictionless pen oscillating between two steps. If springs of
/// 900 N/m in total act as well, the part of the force above 30 Hz (RMS) is 0.031 N at 1 kHz and
/// 0.038 N at 5 kHz. With this function, that part is 0.018 and 0.023 N (spring_test.cc checks the
/// bound). Oscillations that remain undamped are smaller than 0.05 mm at 20 Hz. Shortening keeps
/// the direction, so a damper can still only remove energy.
inline Vec known_velocity(const PenSample& sample) noexcept {
  const Vec v = in_plane(sample.velocity);
  const double speed = norm(v);
  return speed > kUnknownSpeedMmPerS ? ((speed - kUnknownSpeedMmPerS) / speed) * v : Vec{};
}

}  // namespace felt
