#include "desktop/pens/device_clock.h"

#include <algorithm>

namespace felt::desktop {
namespace {

constexpr std::int64_t kNsPerMs = 1'000'000;
constexpr std::int64_t kForgettingPart = 10'000;  // the offset grows by 1 ms in 10 s
/// If an event seems to be older than kOldestNs, its stamp comes from another clock.
constexpr std::int64_t kOldestNs = 2'000'000'000;
constexpr std::uint64_t kMaxStampMs = std::uint64_t{1} << 42;  // 139 years: fits a time in ns

}  // namespace

/// The offset of an event is its time of arrival minus its stamp. The event with the smallest
/// offset had the smallest delay, so the smallest offset so far is the estimate. The estimate grows
/// slowly, because the clocks may drift apart. If the offset of an event is smaller than the
/// estimate, or much larger, it becomes the new estimate. The returned time is never before the
/// last returned time and never after `now_ns`.
std::int64_t DeviceClock::time_ns(std::uint64_t stamp_ms, std::int64_t now_ns) noexcept {
  const bool has_stamp = stamp_ms != 0 && stamp_ms < kMaxStampMs;
  std::int64_t time_ns = now_ns;
  if (has_stamp) {
    const std::int64_t stamp_ns = static_cast<std::int64_t>(stamp_ms) * kNsPerMs;
    const std::int64_t offset_ns = now_ns - stamp_ns;
    if (offset_ns_)
      *offset_ns_ += std::max<std::int64_t>(now_ns - last_now_ns_, 0) / kForgettingPart;
    if (!offset_ns_ || offset_ns < *offset_ns_ || offset_ns > *offset_ns_ + kOldestNs) {
      offset_ns_ = offset_ns;
    }
    time_ns = stamp_ns + *offset_ns_;
  }
  last_now_ns_ = now_ns;
  last_ns_ = std::min(std::max(time_ns, last_ns_), now_ns);
  return last_ns_;
}

}  // namespace felt::desktop
