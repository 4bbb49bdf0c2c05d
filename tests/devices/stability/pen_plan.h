#pragma once

#include "felt/geometry/vec3.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/force.h"
#include "tests/devices/stability/stability_cell.h"

namespace felt {

/// Position of the trials, mm. The workspace of each device is centred near it.
inline constexpr Point kTrialPlace{30.0, 30.0};
/// Frequency of the hand that shakes (Trial::kShake).
inline constexpr double kShakeHz = 5.0;
/// How much deeper the pen is pressed from its rest and back (Trial::kClick).
inline constexpr double kClickWayMm = 0.6;

/// Radius of the body (Trial::kFlank, Trial::kSlide).
inline constexpr double kBodyRadiusMm = 40.0;

/// Times of the phases of a trial, in s since its start.
struct TrialTimes {
  double measure_from_s = 0.0;  ///< start of the measurement of the high-frequency force
  double measure_until_s = 0.0;
  double energy_from_s = 0.0;  ///< start of the energy measurement: after the pen is in the well
  double release_s = 0.0;      ///< when the hand releases the pen; only if `lets_go`
  double end_s = 0.0;
};
/// Returns the times of a trial. `lets_go`: the hand releases the pen during the trial.
TrialTimes times_of(Trial trial, bool lets_go) noexcept;

/// The planned position of the pen at a time, and the force of surface and springs expected there.
/// A hand aims past the planned position, so that its own spring balances this force.
struct PlannedPen {
  Vec3 pen;
  Force load;
};

/// The stiffness, friction and pressing force that a plan assumes.
struct PlanGround {
  double plane_n_per_m = 500.0;
  double friction = 0.25;
  double press_n = 0.8;
  GuideLaw guide = {};  ///< for the trials of guides of a drawing
};
/// Returns the planned position and load at time `t_s`, s since the start of the trial.
PlannedPen planned_pen(Trial trial, const PlanGround& ground, double t_s) noexcept;

}  // namespace felt
