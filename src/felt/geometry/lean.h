#pragma once

#include <cmath>
#include <optional>

#include "felt/geometry/vec3.h"

namespace felt {

/// The largest lean: a pen that lies on the sheet.
inline constexpr double kMostLeanDeg = 90.0;
/// A hand of habit writes at 30 to 40 degrees, hence only what lies beyond kFreeLeanDeg changes a
/// line, and all of it from kFullLeanDeg on.
inline constexpr double kFreeLeanDeg = 40.0;
inline constexpr double kFullLeanDeg = 65.0;

/// 0..1 of a lean in degrees, as media count it (material/materials.h); what is not a number is
/// upright. Real-time safe.
constexpr double lean_share(double lean_deg) noexcept {
  if (!(lean_deg > kFreeLeanDeg)) return 0.0;
  const double share = (lean_deg - kFreeLeanDeg) / (kFullLeanDeg - kFreeLeanDeg);
  return share < 1.0 ? share : 1.0;
}

/// A lean that makes sense: none where there is none or it is not a number, else held to 0..90
/// degrees. Real-time safe.
inline std::optional<double> clean_lean(std::optional<double> lean_deg) noexcept {
  if (!lean_deg || std::isnan(*lean_deg)) return std::nullopt;
  return std::fmin(std::fmax(*lean_deg, 0.0), kMostLeanDeg);
}

/// How far a pen that lies along `axis` (tip to end or the other way round, of any length) leans
/// away from the z axis: degrees, 0..90, in tenths, which is finer than any pen knows and short in
/// a recording. Nothing where the axis has no direction. Real-time safe.
std::optional<double> lean_of_axis(const Vec3& axis) noexcept;

/// The lean of a pen whose shadow on the planes x-z and y-z leans by these angles, degrees, -90..90
/// (tiltX and tiltY of a tablet, OTx and OTy of InkML): atan(sqrt(tan^2 tx + tan^2 ty)), in tenths.
/// Nothing where an angle is not finite or beyond 90.
std::optional<double> lean_of_tilt(double x_deg, double y_deg) noexcept;

}  // namespace felt
