#pragma once

#include "felt/haptics/force.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Passivity observer (reliability 3.2, after Hannaford and Ryu): the work that the sent forces did
/// on the hand since the pen last came down. The force of a tick acts until the next one, so its
/// work is that force times the way of the pen in between; positions, not velocities, and therefore
/// no noise adds up.
class PassivityObserver {
 public:
  /// Forgets everything: the next sample is the first.
  void reset() noexcept;
  /// `sent` was held by the device since the last sample; returns the energy in mJ, > 0 where the
  /// loop gave more than it took. Huge numbers saturate.
  double update(const PenSample& sample, const Force& sent) noexcept;

 private:
  bool has_last_ = false;
  bool was_in_contact_ = false;
  Vec3 last_mm_;
  double energy_mj_ = 0.0;
};

}  // namespace felt
