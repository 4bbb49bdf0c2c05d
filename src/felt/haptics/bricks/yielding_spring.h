#pragma once

#include "felt/geometry/point.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Resists a pen that moves, the more the farther it is from `grab`, the point at which the gesture
/// grabbed a line, and lets go of a pen that rests (docs/design/forces.md#yielding; R73):
///
///   F = -gain l(|V|) q(|L|) L/|L| - Bed v,   V = pen - grab,   q(d) = min(1, d Kcap/max_n)
///
/// l is the level of the force law (eq. 9). The lag L is the vector to the pen from a point that
/// follows it with the time constant tau: L' = v - L/tau. So the force is that of a spring of at
/// most Kcap that gives way (a Maxwell element), and is 0 after a rest of a few tau. It takes
/// energy from the hand as long as |V| grows by less than 2 l/(l' tau). The state is in
/// ForceMemory::yield; a model may have one such force. Publish it only while the gesture lasts.
class YieldingSpring {
 public:
  /// `yield_s` is tau, s. Requires 0 < yield_s <= 0.05, so that no hand gains energy (test).
  YieldingSpring(Point grab, const EditOptions& options, double yield_s) noexcept
      : grab_(grab), options_(options), yield_s_(yield_s) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

 private:
  Point grab_;
  EditOptions options_;
  double yield_s_;
};

/// Returns the lag of a yielding force, mm: the vector to the pen from a point that follows it with
/// the time constant `yield_s` and begins at the pen. The equation is solved for a pen that moves
/// in a straight line from sample to sample, so that the rate of the loop has no effect (R30).
/// Begins anew for another `grab` and after a pause of 0.1 s.
Vec yielding_lag(Point grab, double yield_s, const PenSample& sample, ForceMemory& memory) noexcept;

/// Returns the force of a yielding spring against `lag`, N: `level_n` from the distance
/// max_n/Kcap of the law on, proportionally less below it.
Vec yielding_pull(const ForceLaw& law, double level_n, Vec lag) noexcept;

}  // namespace felt
