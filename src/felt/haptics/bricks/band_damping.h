#pragma once

#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

struct BandDampingOptions {
  double hz = 5.0;  ///< middle of the band
  double damping_n_s_per_m = 4.0;
  double max_force_n = 0.5;
};

/// Returns the options for a device: at most a quarter of the damping that it can render, because
/// the surface and the friction damp as well.
BandDampingOptions band_damping_for(double hz, const Capabilities& device) noexcept;

/// Damps the pen on the surface only where a hand shakes: with u, the part of the velocity v along
/// the surface in a band of about 3 Hz (a second-order band-pass with unit gain at its middle),
///
///   F = -b g u,   g = u.v / |u|^2 limited to 0..1
///
/// So slow and steady motion is free. The force never pushes the pen: its power F.v = -b g u.v is
/// at most 0 in every tick, and |F| is at most b |v|, so it lies within the sector of a damper of
/// the gain b. A force against the predicted shaking (in counter-phase) would push the pen whenever
/// the prediction is wrong, and is not used (docs/design/steady-hand.md#force).
class BandDamping {
 public:
  /// Q of the band-pass: 3 Hz wide at 5 Hz, because hands drift by 1.5 Hz to either side
  /// (docs/design/steady-hand.md#force).
  static constexpr double kQ = 1.7;

  explicit BandDamping(const BandDampingOptions& options = {}) noexcept : options_(options) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Returns zero, because damping has no stiffness.
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }

 private:
  BandDampingOptions options_;
};

}  // namespace felt
