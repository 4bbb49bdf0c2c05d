#include "felt/devices/simulated/moving_aim.h"

#include <algorithm>

namespace felt {

void MovingAim::set(const Aim& aim, std::int64_t now_ns, std::int64_t least_ns) noexcept {
  if (!is_set_) {
    is_set_ = true;
    to_ = shown_ = aim;
    from_mm_ = aim.target_mm;
    start_ns_ = end_ns_ = now_ns;
    return;
  }
  const std::int64_t since_last_ns = now_ns - start_ns_;
  const std::int64_t takes_ns =
      std::clamp(since_last_ns, std::min(least_ns, kLongestNs), kLongestNs);
  from_mm_ = at(now_ns);
  shown_ = to_;
  to_ = aim;
  start_ns_ = now_ns;
  end_ns_ = now_ns + takes_ns;
}

Vec3 MovingAim::at(std::int64_t time_ns) const noexcept {
  if (time_ns >= end_ns_) return to_.target_mm;
  if (time_ns <= start_ns_) return from_mm_;
  return lerp(from_mm_, to_.target_mm,
              static_cast<double>(time_ns - start_ns_) / static_cast<double>(end_ns_ - start_ns_));
}

const Aim& MovingAim::shown(std::int64_t time_ns) noexcept {
  if (time_ns >= end_ns_) shown_ = to_;
  return shown_;
}

}  // namespace felt
