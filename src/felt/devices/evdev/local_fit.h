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
  double most_stiffness_n_per_mm = 1.0;
};

/// A force that a device renders by itself until the next update: a spring around its current
/// position, and a friction.
///
///   F(x, v) = force_n - stiffness (x - position_mm) - friction_n sgn(v)
struct AxisFit {
  double position_mm = 0.0;         ///< of the newest sample
  double force_n = 0.0;             ///< at that position, without the friction
  double stiffness_n_per_mm = 0.0;  ///< pulls back; never negative, because that would push away
  double friction_n = 0.0;          ///< dissipates energy; never negative
};

/// Fits the force law of AxisFit to the forces of the last milliseconds. Uses regularised least
/// squares; newer samples have more weight (by a third for each kFitForgets of them). If several
/// force laws fit equally well, prior knowledge decides: the stiffness is zero without motion, and
/// a force that always opposes the motion is mostly friction. So the dissipative force law is
/// chosen.
///
/// The force law passes exactly through the newest sample, so the fit adds no delay. Its friction
/// is at most the part of the force that opposes the motion at that sample. So |force_n| +
/// friction_n exceeds the last requested force by at most a quarter, whatever the direction of
/// motion. Samples are ordered from oldest to newest; without samples the force is zero. Samples
/// that are not finite are left out.
///
/// Real-time safe. The time is linear in the number of samples, with a small constant.
AxisFit fit_axis(std::span<const FitSample> samples, const FitAbility& can) noexcept;
inline constexpr int kFitForgets = 12;

}  // namespace felt
