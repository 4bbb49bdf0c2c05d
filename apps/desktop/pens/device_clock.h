#pragma once

#include <cstdint>
#include <optional>

namespace felt::desktop {

/// Converts the time stamps of a device's events to times on the haptic loop's clock. The stamps
/// are whole milliseconds of the device's own clock, and the events arrive late.
///
/// The offset between the clocks is estimated from the events with the smallest delay, because an
/// event cannot arrive before it was made. The estimated offset grows by 1 ms in 10 s, because the
/// clocks may drift apart. If the stamps jump (another device, a clock that was set, missing
/// stamps), the estimate restarts. A value type.
class DeviceClock {
 public:
  /// Returns the time of the event: at most `now_ns`, and not before the last returned time.
  std::int64_t time_ns(std::uint64_t stamp_ms, std::int64_t now_ns) noexcept;

 private:
  std::optional<std::int64_t> offset_ns_;  // loop clock minus device clock: the estimate
  std::int64_t last_now_ns_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace felt::desktop
