#include "felt/driver/service_pace.h"

#include <algorithm>

namespace felt {
namespace {

constexpr double kAverageOf = 32.0;          // number of ticks or states in an average
constexpr double kLongestInterval = 20.0e6;  // ns; longer intervals count as this

}  // namespace

ServicePace::ServicePace(std::int64_t period_ns) noexcept
    : period_ns_(static_cast<double>(period_ns)), tick_ns_(period_ns_), interval_ns_(period_ns_) {}

void ServicePace::follow_interval(bool has_state) noexcept {
  const double expected_ns = std::max(period_ns_, tick_ns_);
  if (has_state) {
    const double last_ns = std::min(static_cast<double>(counted_ns_), kLongestInterval);
    interval_ns_ += (last_ns - interval_ns_) / kAverageOf;
    waited_ns_ = counted_ns_ = 0;
  }
  is_slow_ = interval_ns_ > kSlowPeriods * expected_ns;
  const bool is_timely = interval_ns_ < kTimelyPeriods * expected_ns && waited_ns_ < kHoldNs;
  if (!is_timely) timely_ns_ = 0;
}

// The share becomes zero immediately after kHoldNs without a state. While the service is slow, the
// share falls along a ramp; otherwise it rises along the same ramp. Once the share is zero, the
// pace is off until states have come in time for kTimelyNs.
void ServicePace::tick(std::int64_t ns, bool has_state) noexcept {
  ns = std::max<std::int64_t>(ns, 0);
  const std::int64_t counted_ns = std::min(ns, kMaxTickNs);
  tick_ns_ += (static_cast<double>(counted_ns) - tick_ns_) / kAverageOf;
  waited_ns_ += ns;
  counted_ns_ += counted_ns;
  timely_ns_ = std::min(timely_ns_ + counted_ns, kTimelyNs);
  follow_interval(has_state);
  if (is_off_) {
    is_off_ = timely_ns_ < kTimelyNs;
    return;
  }
  const double change =
      static_cast<double>(is_slow_ ? -ns : counted_ns) / static_cast<double>(kSlowRampNs);
  share_ = waited_ns_ > kHoldNs ? 0.0 : std::clamp(share_ + change, 0.0, 1.0);
  is_off_ = share_ == 0.0;
  if (is_off_) timely_ns_ = 0;
}

}  // namespace felt
