#include "felt/geometry/tilt.h"

#include "felt/base/constants.h"

namespace felt {
namespace {

double in_tenths(double degrees) noexcept {
  return std::round(10.0 * degrees) / 10.0;
}

}  // namespace

std::optional<double> tilt_of_axis(const Vec3& axis) noexcept {
  const double beside = std::hypot(axis.x, axis.y), up = std::fabs(axis.z);
  if (!std::isfinite(beside) || !std::isfinite(up) || beside + up <= 0.0) return std::nullopt;
  return in_tenths(kDegPerRad * std::atan2(beside, up));
}

std::optional<double> tilt_of_xy(double x_deg, double y_deg) noexcept {
  const double x = std::fabs(x_deg), y = std::fabs(y_deg);
  if (!(x <= kMaxTiltDeg && y <= kMaxTiltDeg)) return std::nullopt;
  // Both tangents are multiplied by both cosines, so that 90 degrees do not give infinity. The
  // cosines are not negative.
  const double cx = std::fmax(std::cos(x / kDegPerRad), 0.0);
  const double cy = std::fmax(std::cos(y / kDegPerRad), 0.0);
  if (x == kMaxTiltDeg || y == kMaxTiltDeg) return kMaxTiltDeg;
  return tilt_of_axis({std::sin(x / kDegPerRad) * cy, std::sin(y / kDegPerRad) * cx, cx * cy});
}

}  // namespace felt
