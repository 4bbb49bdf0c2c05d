#pragma once

#include <cmath>
#include <optional>

#include "felt/geometry/vec3.h"

namespace felt {

/// The largest tilt, at which the pen lies flat on the surface.
inline constexpr double kMaxTiltDeg = 90.0;
/// People usually write at a tilt of 30 to 40 degrees. So a tilt of up to kFreeTiltDeg has no
/// effect on the line, and a tilt of kFullTiltDeg or more has its full effect.
inline constexpr double kFreeTiltDeg = 40.0;
inline constexpr double kFullTiltDeg = 65.0;

/// Converts a tilt in degrees to the share of its full effect on media, 0..1
/// (material/materials.h). NaN counts as upright. Real-time safe.
constexpr double tilt_share(double tilt_deg) noexcept {
  if (!(tilt_deg > kFreeTiltDeg)) return 0.0;
  const double share = (tilt_deg - kFreeTiltDeg) / (kFullTiltDeg - kFreeTiltDeg);
  return share < 1.0 ? share : 1.0;
}

/// Returns the tilt clamped to 0..90 degrees, or nullopt if it is missing or NaN. Real-time safe.
inline std::optional<double> checked_tilt(std::optional<double> tilt_deg) noexcept {
  if (!tilt_deg || std::isnan(*tilt_deg)) return std::nullopt;
  return std::fmin(std::fmax(*tilt_deg, 0.0), kMaxTiltDeg);
}

/// Returns the tilt of a pen whose axis is `axis` (which may point in either direction and have any
/// length): the angle to the z axis in degrees, 0..90, rounded to tenths of a degree. This is as
/// precise as any pen measures, and short numbers keep recordings small. Returns nullopt if the
/// axis has no direction. Real-time safe.
std::optional<double> tilt_of_axis(const Vec3& axis) noexcept;

/// Returns the tilt of a pen from its projections on the planes x-z and y-z, in degrees, -90..90
/// (tiltX and tiltY of a tablet, OTx and OTy of InkML): atan(sqrt(tan^2 tx + tan^2 ty)), rounded to
/// tenths. Returns nullopt if an angle is not within -90..90.
std::optional<double> tilt_of_xy(double x_deg, double y_deg) noexcept;

}  // namespace felt
