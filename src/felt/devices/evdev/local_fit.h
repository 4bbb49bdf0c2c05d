#pragma once

#include <span>

namespace felt {

/// The requested force on one axis at one tick.
struct FitSample {
  double position_mm = 0.0;
  double speed_mm_per_s = 0.0;
  double force_n = 0.0;
};

/// The parts of a force that a device can render by itself.
struct FitAbility {
  bool spring = true;
  bool friction = true;
  double max_stiffness_n_per_mm = 1.0;
};

/// A force that a device renders by itself until the next update: a spring around the current
/// position, and a friction.
///
///   F(x, v) = force_n - stiffness (x - position_mm) - friction_n sgn(v)
struct AxisFit {
  double position_mm = 0.0;         ///< position of the newest sample
  double force_n = 0.0;             ///< force at that position, without the friction
  double stiffness_n_per_mm = 0.0;  ///< never negative, because that would push the grip away
  double friction_n = 0.0;          ///< dissipates energy; never negative
};

/// Fits the force law of AxisFit to the forces of the last milliseconds. Uses regularised least
/// squares; newer samples have more weight (a sample that is kFitForgets samples older has a third
/// of the weight). If several force laws fit almost equally well, the regularisation prefers small
/// coefficients, and thereby the force law that dissipates energy: without motion, the stiffness is
/// zero, and a force that always opposes the motion is explained mostly by friction.
///
/// The force law passes exactly through the newest sample, so the fit adds no delay. The friction
/// is at most as large as the part of the newest force that opposes the motion. Therefore |force_n|
/// + friction_n, the largest force in any direction of motion, exceeds the last requested force by
/// at most a quarter. Samples are ordered from oldest to newest; without samples the force is zero.
/// Samples that are not finite are left out.
///
/// Real-time safe. The time is linear in the number of samples, with a small constant.
AxisFit fit_axis(std::span<const FitSample> samples, const FitAbility& can) noexcept;
inline constexpr int kFitForgets = 12;

}  // namespace felt
