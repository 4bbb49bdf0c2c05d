#pragma once

#include <array>
#include <cstddef>

#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Lets the pen feel a click when it is pressed through a threshold of depth, and again when it
/// comes back: a short pulse against the movement (docs/design/forces.md#clicks).
///
///   F_z = s A 4 x (1 - x),   x = t/T     for t = 0..T after a threshold was passed
///
/// s is 1 if the pen moves into the surface and -1 if it comes back, so the force opposes the
/// movement; A = kForceN, T = kPulseS. Short
/// pulses at events give contact information that a spring cannot give (Kuchenbecker, Fiene and
/// Niemeyer 2006, DOI 10.1109/TVCG.2006.32). A dip in the spring would be felt without a clock, but
/// the thresholds of a weak device are too near to each other: its slopes would exceed the
/// stiffness of the device.
///
/// The pulse opposes the movement, so it takes energy from the hand. A hand that turns around
/// within the pulse gets at most A T v back, 0.05 mJ at 20 mm/s. A threshold counts as passed only
/// kHysteresisMm behind it, and at least kPauseS after the last click, so that a pen that rests at
/// a threshold does not hum. A landing pen feels no click: the depth of the first samples chooses
/// the step without one.
class PushClicks {
 public:
  static constexpr std::size_t kMax = 8;
  static constexpr double kForceN = 0.25;
  static constexpr double kPulseS = 0.012;
  static constexpr double kHysteresisMm = 0.04;
  static constexpr double kPauseS = 0.08;
  static constexpr double kLandingS = 0.05;  ///< time after the touch without clicks

  /// Makes a brick without force.
  PushClicks() noexcept = default;
  /// Adds a threshold. Depths must ascend; ignored if the list is full.
  void add(double depth_mm) noexcept {
    if (count_ < kMax) depths_mm_[count_++] = depth_mm;
  }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Returns zero, because the force does not depend on the position.
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }

 private:
  /// Returns the number of thresholds that the pen has passed, coming from `passed` thresholds.
  [[nodiscard]] std::size_t passed_at(double depth_mm, std::size_t passed) const noexcept;

  std::array<double, kMax> depths_mm_{};
  std::size_t count_ = 0;
};

}  // namespace felt
