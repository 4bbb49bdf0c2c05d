#pragma once

#include <cstdint>

#include "felt/devices/simulated/aim_queue.h"

namespace felt {

/// Where a hand's aim is between the aims that it is given. A tablet says 133 times a second where
/// it is, the loop asks 1000 times or more: the aim moves evenly to the new place, in the time that
/// passed since the last one was given, at most 10 ms. So it stands in no staircase, which the hand
/// would feel and the safety chain take for jumps.
///
/// Pressure and buttons change when it arrives, so that a pen that is put down draws from there and
/// not from where it came; or with the next aim, where that comes first: nothing is lost.
class MovingAim {
 public:
  static constexpr std::int64_t kLongestNs = 10'000'000;

  /// From now on. The first one is there at once.
  void set(const Aim& aim, std::int64_t now_ns, std::int64_t least_ns) noexcept;
  /// The clock was set back to this: it has arrived.
  void restart(std::int64_t now_ns) noexcept { start_ns_ = end_ns_ = now_ns; }
  /// Where it is.
  [[nodiscard]] Vec3 at(std::int64_t time_ns) const noexcept;
  /// Pressure and buttons.
  [[nodiscard]] const Aim& shown(std::int64_t time_ns) noexcept;
  [[nodiscard]] bool is_set() const noexcept { return is_set_; }
  [[nodiscard]] const Aim& newest() const noexcept { return to_; }

 private:
  bool is_set_ = false;
  Vec3 from_mm_;
  Aim to_, shown_;
  std::int64_t start_ns_ = 0, end_ns_ = 0;
};

}  // namespace felt
