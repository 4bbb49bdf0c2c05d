#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/haptics/pen_sample.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt {

/// Removes the impact of a landing pen from the pressure of a line (docs/design/loop.md#landing).
/// On a device that senses depth, a pen that lands fast dives deeper than it is pressed, and may
/// bounce. From the touch until the pressure has passed for the last time through the level at
/// which it settles, the samples get this level.
///
///     touch   peak     [bounces]      kSettleNs      the level is known
///       |------+----------+-------------|----->  samples pass unchanged
///
/// Ink of pens that land slowly, of pens that sense pressure, and of pens whose first peak of
/// pressure is later than an impact can make it (kPeakNs) passes unchanged.
///
/// Use, for each line: begin(); push() for each sample; end() at pen-up. push() and end() return
/// the samples that have become ink, in order, valid until the next call; held() those that still
/// wait. The delay is kSettleNs after the last bounce, but at most kLongestNs or kMaxHeld samples.
class LandingPressure {
 public:
  /// Mass and plane of every known device reach the deepest point of an impact in this time.
  static constexpr std::int64_t kPeakNs = 60'000'000;
  static constexpr std::int64_t kSettleNs = 350'000'000;
  static constexpr std::int64_t kLongestNs = 1'500'000'000;
  static constexpr std::size_t kMaxHeld = 8192;
  static constexpr double kMinFallMmPerS = 15.0;

  /// Starts a line with its first sample. `is_felt` tells that pressure is depth in a plane that
  /// the pen feels (Pressing::is_felt).
  void begin(const PenSample& touch, bool is_felt);
  /// `touches` tells that the pen touches the surface; it does not during a bounce.
  std::span<const InkSample> push(const InkSample& sample, bool touches);
  std::span<const InkSample> end();
  /// Returns the samples that wait, with the pressure that they would get now.
  [[nodiscard]] std::vector<InkSample> held() const;
  /// Returns true while samples wait for the pen to settle.
  [[nodiscard]] bool is_landing() const noexcept { return lands_; }

 private:
  [[nodiscard]] std::int64_t age_ns(std::size_t i) const noexcept;
  [[nodiscard]] std::int64_t level_from_ns() const noexcept;
  [[nodiscard]] std::optional<double> level() const noexcept;
  [[nodiscard]] bool is_impact(double level) const noexcept;
  void correct(std::vector<InkSample>& samples) const;
  std::span<const InkSample> release();

  bool lands_ = false;
  std::int64_t touch_ns_ = 0;
  std::int64_t bounce_ns_ = 0;  // of the last sample of a bounce, or of the touch
  std::vector<InkSample> held_, released_;
};

}  // namespace felt
