#include "felt/haptics/safety/safety_clock.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kShortestS = 0.0002;
constexpr double kLongestS = 0.005;

/// to - from in s; in unsigned numbers, where no difference overflows.
double seconds_between(std::int64_t from, std::int64_t to) noexcept {
  const auto difference = [](std::int64_t low, std::int64_t high) {
    return 1e-9 *
           static_cast<double>(static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low));
  };
  return to >= from ? difference(from, to) : -difference(to, from);
}

}  // namespace

TickClock::TickClock(const SafetyLimits& limits) noexcept
    : period_s_(1e-9 * static_cast<double>(limits.period_ns)),
      late_s_(limits.late_s),
      very_late_s_(limits.very_late_s) {}

TickTime TickClock::tick(std::int64_t now_ns) noexcept {
  const double measured_s = has_last_ ? seconds_between(last_ns_, now_ns) : period_s_;
  last_ns_ = now_ns;
  has_last_ = true;

  TickTime time;
  time.model_s = std::clamp(measured_s, kShortestS, kLongestS);
  time.credited_s = std::clamp(measured_s, 0.0, std::min(2.0 * period_s_, kLongestS));
  time.charged_s = std::max(measured_s, kShortestS);
  if (std::abs(measured_s) > very_late_s_) {
    time.lateness = Lateness::kVeryLate;
  } else if (std::abs(measured_s) > late_s_) {
    time.lateness = Lateness::kLate;
  }
  return time;
}

void HeartbeatWatch::beat(std::int64_t made_ns) noexcept {
  if (has_beat_ && made_ns == last_beat_ns_) return;
  has_beat_ = true;
  is_new_ = true;
  last_beat_ns_ = made_ns;
}

void HeartbeatWatch::restart() noexcept {
  silence_s_ = 0.0;
  is_new_ = false;
}

double HeartbeatWatch::tick(std::int64_t now_ns, const TickTime& time) noexcept {
  silence_s_ += time.charged_s;
  if (is_new_) {
    is_new_ = false;
    // One that comes late is as old as it is; one from the future is from now.
    silence_s_ = std::min(silence_s_, std::max(seconds_between(last_beat_ns_, now_ns), 0.0));
  }
  return silence_s_;
}

}  // namespace felt
