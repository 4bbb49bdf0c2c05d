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
// aim (with `kJoined`, to the age of the start of the interpolation towards the aim). While a
// shorter delay is enough, the delay falls slowly.
void AimTrack::push(const StampedAim& aim, std::int64_t now_ns) noexcept {
  std::int64_t time_ns = std::clamp(aim.time_ns, now_ns - kOldestNs, now_ns);
  std::int64_t way_ns = 0;
  if (is_set_) {
    time_ns = std::max(time_ns, newest_ns_ + kMinSpacingNs);
    const std::int64_t since_ns = time_ns - newest_ns_;
    if (play_ == Play::kJoined && since_ns < 2 * kLongestWayNs)
      way_ns = std::min(since_ns, kLongestWayNs);
  }
  const std::int64_t needs_ns = std::clamp<std::int64_t>(now_ns - time_ns + way_ns, 0, kMaxDelayNs);
  delay_ns_ = std::max(delay_ns_ - (delay_ns_ - needs_ns) / kForgetting, needs_ns);
  // After a rest the interpolation starts at the current playback time, because earlier times have
  // been played already.
  const std::int64_t known_ns = count_ == 0 ? now_ns - delay_ns_ : newest_ns_;
  const std::int64_t start_ns =
      std::max({time_ns - kLongestWayNs, is_set_ ? newest_ns_ : time_ns, known_ns});
  // The oldest aim cannot be played before it has arrived; the others follow at their spacing.
  if (play_ == Play::kPaced && count_ == 0) held_ns_ = std::max(held_ns_, now_ns);
  waiting_[(head_ + count_) % kMax] = {aim.aim, std::min(start_ns, time_ns), time_ns};
  ++count_;
  if (!is_set_) passed_ = aim.aim;
  is_set_ = true;
  newest_ns_ = time_ns;
}

/// With kPaced, an aim that is late by L follows the aim before after kCatchUpNs / (kCatchUpNs + L)
/// of the time between the two. A rest counts as 10 ms.
std::int64_t AimTrack::due_ns() const noexcept {
  const std::int64_t time_ns = waiting_[head_].time_ns, in_time_ns = time_ns + delay_ns_;
  if (play_ == Play::kJoined || passed_due_ns_ == INT64_MIN) return std::max(in_time_ns, held_ns_);
  const std::int64_t apart_ns = std::min(time_ns - passed_time_ns_, kLongestWayNs);
  const std::int64_t late_ns = std::max<std::int64_t>(passed_due_ns_ + apart_ns - in_time_ns, 0);
  const double part = static_cast<double>(kCatchUpNs) / static_cast<double>(kCatchUpNs + late_ns);
  const auto after_ns = static_cast<std::int64_t>(part * static_cast<double>(apart_ns));
  return std::max({in_time_ns, passed_due_ns_ + after_ns, held_ns_});
}

const Aim* AimTrack::due(std::int64_t now_ns) noexcept {
  if (count_ == 0 || waiting_[head_].time_ns > played_ns(now_ns)) return nullptr;
  if (play_ == Play::kPaced && due_ns() > now_ns) return nullptr;
  return &waiting_[head_].aim;
}

void AimTrack::pass() noexcept {
  passed_due_ns_ = due_ns();
  passed_time_ns_ = waiting_[head_].time_ns;
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
