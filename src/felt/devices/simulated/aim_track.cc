#include "felt/devices/simulated/aim_track.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// If an aim needs less than the current delay, 1/128 of the difference is removed from the delay.
/// So a burst of late aims has little effect after some hundred aims.
constexpr std::int64_t kForgetting = 128;
/// Maximum plausible age of an aim.
constexpr std::int64_t kOldestNs = 10'000'000'000;

double pressure_of(const Aim& aim) noexcept {
  return aim.pressure.value_or(0.0);
}

}  // namespace

/// Returns the playback time. It stops at the newest aim, because the track has no later aim: the
/// pen then rests there.
std::int64_t AimTrack::played_ns(std::int64_t now_ns) noexcept {
  return played_ns_ = std::max(played_ns_, std::min(now_ns - delay_ns_, newest_ns_));
}

// If this aim arrives older than the current delay, the delay grows immediately to the age of the
// aim (with `joins`, to the age of the start of the interpolation towards the aim). While a shorter
// delay is enough, the delay falls slowly.
void AimTrack::push(const StampedAim& aim, std::int64_t now_ns) noexcept {
  std::int64_t time_ns = std::clamp(aim.time_ns, now_ns - kOldestNs, now_ns);
  std::int64_t way_ns = 0;
  if (is_set_) {
    time_ns = std::max(time_ns, newest_ns_ + kMinSpacingNs);
    const std::int64_t since_ns = time_ns - newest_ns_;
    if (joins_ && since_ns < 2 * kLongestWayNs) way_ns = std::min(since_ns, kLongestWayNs);
  }
  const std::int64_t needs_ns = std::clamp<std::int64_t>(now_ns - time_ns + way_ns, 0, kMaxDelayNs);
  delay_ns_ = std::max(delay_ns_ - (delay_ns_ - needs_ns) / kForgetting, needs_ns);
  // After a rest the interpolation starts at the current playback time, because earlier times have
  // been played already.
  const std::int64_t known_ns = count_ == 0 ? now_ns - delay_ns_ : newest_ns_;
  const std::int64_t start_ns =
      std::max({time_ns - kLongestWayNs, is_set_ ? newest_ns_ : time_ns, known_ns});
  waiting_[(head_ + count_) % kMax] = {aim.aim, std::min(start_ns, time_ns), time_ns};
  ++count_;
  if (!is_set_) passed_ = aim.aim;
  is_set_ = true;
  newest_ns_ = time_ns;
}

const Aim* AimTrack::due(std::int64_t now_ns) noexcept {
  if (count_ == 0 || waiting_[head_].time_ns > played_ns(now_ns)) return nullptr;
  return &waiting_[head_].aim;
}

void AimTrack::pass() noexcept {
  passed_ = waiting_[head_].aim;
  head_ = (head_ + 1) % kMax;
  --count_;
}

Aim AimTrack::at(std::int64_t now_ns) noexcept {
  if (count_ == 0) return passed_;
  const Waiting& next = waiting_[head_];
  const std::int64_t played = played_ns(now_ns);
  if (played <= next.start_ns || next.time_ns <= next.start_ns) return passed_;
  const double part = std::min(1.0, static_cast<double>(played - next.start_ns) /
                                        static_cast<double>(next.time_ns - next.start_ns));
  Aim between = passed_;
  between.target_mm = lerp(passed_.target_mm, next.aim.target_mm, part);
  if (pressure_of(passed_) > 0.0 && pressure_of(next.aim) > 0.0) {
    between.pressure = std::lerp(*passed_.pressure, *next.aim.pressure, part);
  }
  if (passed_.tilt_deg && next.aim.tilt_deg) {
    between.tilt_deg = std::lerp(*passed_.tilt_deg, *next.aim.tilt_deg, part);
  }
  return between;
}

}  // namespace felt
