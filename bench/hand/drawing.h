#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/devices/simulated/person.h"
#include "felt/trial/trial_metrics.h"

namespace felt::bench {

/// The condition under which a simulated person draws.
struct Condition {
  double tunnel_mm = 0.0;  ///< width of a tunnel that the person has to stay in; 0 for none
  double friction = 0.0;   ///< coefficient of the surface
  bool towed = false;      ///< the pen tows the nib on a rope (felt/haptics/bricks/stabiliser.h)
  double guide_n_per_m = 0.0;                 ///< stiffness of a groove along the path
  double guide_n = 1.0;                       ///< greatest force of the groove
  bool in_air = false;                        ///< without a plane and without any force
  std::optional<double> device_friction_n{};  ///< replaces that of the device
};

/// How the pen is recorded.
struct Tablet {
  double interval_s = 0.0075;
  double step_mm = 0.03;  ///< positions are multiples of this
};

/// What a person drew.
struct Drawing {
  std::vector<TrialSample> ink;  ///< as the tablet reports it
  double error_mm = 0.0;         ///< mean distance between ink and path, in both directions
  double plane_error_mm = 0.0;  ///< mean distance of the ink from the path, in the plane of drawing
  double total_error_mm = 0.0;  ///< the same with the distance from the plane
  double depth_mm = 0.0;        ///< mean distance from the plane
  double end_error_mm = 0.0;    ///< distance of the last point from the end of the path
  double fast_share = 0.0;      ///< share of the variance across the path above 4 Hz
  double duration_s = 0.0;      ///< from the first contact to the last
  double simulated_s = 0.0;
};

/// Lets a person draw along a path through `via` with a Phantom Premium, forces on. Ink does not
/// leave the plane; in the air it is where the pen is.
Drawing draw(const Person& person, std::span<const Point> via, const Condition& condition,
             std::uint64_t trial = 0, const Tablet& tablet = {});

/// Returns how far the pen moves within 0.5 s, mm, if a force pulls it across the page for
/// `pulse_s` while the person holds it still above the page.
std::vector<double> pulse_response(const Person& person, double force_n, double pulse_s);

}  // namespace felt::bench
