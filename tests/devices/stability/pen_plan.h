#pragma once

#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"
#include "tests/devices/stability/stability_cell.h"

namespace felt {

/// Where the trials happen: over every device's workspace.
inline constexpr Point kTrialPlace{30.0, 30.0};

/// Course of a trial, s since its start.
struct TrialTimes {
  double measure_from_s = 0.0;  ///< HF is measured here
  double measure_until_s = 0.0;
  double energy_from_s = 0.0;  ///< energy counts from here: past the fall into a well
  double let_go_s = 0.0;       ///< when a hand that lets go does so
  double end_s = 0.0;
};
TrialTimes times_of(Trial trial, bool lets_go) noexcept;

/// Where the pen is meant to be at a time, and what the sheet and the springs will push it with
/// there: a hand aims ahead by that much of its own spring.
struct PlannedPen {
  Vec3 pen;
  Force load;
};

/// The plane and the friction that a plan reckons with.
struct PlanGround {
  double plane_n_per_m = 500.0;
  double friction = 0.25;
  double press_n = 0.8;
};
PlannedPen planned_pen(Trial trial, const PlanGround& ground, double t_s) noexcept;

}  // namespace felt
