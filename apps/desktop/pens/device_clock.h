#pragma once

#include <cstdint>
#include <optional>

namespace felt::desktop {

/// Converts the time stamps of a device (whole milliseconds of its own clock, delivered late) into
/// times of the loop's clock.
///
/// The offset of the clocks is estimated from the events with the smallest delay, because an event
/// cannot arrive before it was made. The estimate is relaxed by 1 ms in 10 s, so that clocks may
/// drift apart. Stamps that jump (another device, a clock that was set, no stamps at all) restart
/// the estimate. A value type.
class DeviceClock {
 public:
  /// Returns the time of the event, at most `now_ns`, and never before the last returned time.
  std::int64_t time_ns(std::uint64_t stamp_ms, std::int64_t now_ns) noexcept;

 private:
  std::optional<std::int64_t> offset_ns_;  // loop - device: the smallest seen
  std::int64_t last_now_ns_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt::desktop
