#pragma once

#include <span>

namespace felt {

/// What was asked of one axis at one tick.
struct FitSample {
  double position_mm = 0.0;
  double speed_mm_per_s = 0.0;
  double force_n = 0.0;
};

/// What of a force a device can do by itself.
struct FitAbility {
  bool spring = true;
  bool friction = true;
  double most_stiffness_n_per_mm = 1.0;
};

/// A force as a device renders it by itself until it is told the next: a spring about where it is
/// now, and a friction.
///
///   F(x, v) = force_n - stiffness (x - position_mm) - friction_n sgn(v)
struct AxisFit {
  double position_mm = 0.0;         ///< of the newest sample
  double force_n = 0.0;             ///< there, but for the friction
  double stiffness_n_per_mm = 0.0;  ///< pulls back; never negative: it would push away
  double friction_n = 0.0;          ///< takes energy; never negative
};

/// The force of the last milliseconds as such a law, by regularised least squares in which younger
/// samples count more (a third for each kFitForgets of them). What the samples do not tell apart is
/// told by what is likely: without way there is no stiffness, and of a force that stands against
/// the motion all along, most is friction: of two explanations that fit alike, the one that takes
/// energy. Through the newest sample the law goes exactly, so that no force is late by the fit, and
/// its friction is no more than what stands against the motion there: whichever way the grip turns,
/// |force_n| + friction_n is at most a quarter more than what was asked for last. Oldest first;
/// none: no force. Samples that are not finite are left out.
///
/// Real-time safe: linear in the samples, and small.
AxisFit fit_axis(std::span<const FitSample> samples, const FitAbility& can) noexcept;
inline constexpr int kFitForgets = 12;

}  // namespace felt
