#pragma once

#include <cstdint>
#include <optional>

namespace felt::desktop {

/// Turns the time stamps of a device (whole milliseconds of a clock of its own, handed over late)
/// into times of the loop's clock.
///
/// The events that came through fastest tell how the clocks lie: an event cannot arrive before it
/// was made. What is known so is let go at 1 ms in 10 s, so that clocks may drift apart. Stamps
/// that jump (another device, a clock that was set, no stamps at all) begin it anew. A value.
class DeviceClock {
 public:
  /// When it was, at most `now_ns`, and never before the time given out last.
  std::int64_t time_ns(std::uint64_t stamp_ms, std::int64_t now_ns) noexcept;

 private:
  std::optional<std::int64_t> offset_ns_;  // loop - device: the least seen
  std::int64_t last_now_ns_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt::desktop
