#include "felt/devices/simulated/gliding_aim.h"

#include <algorithm>

namespace felt {

bool changes_contact(const Aim& a, const Aim& b) noexcept {
  const auto presses = [](const Aim& aim) { return aim.pressure.value_or(0.0) > 0.0; };
  return presses(a) != presses(b) || a.buttons != b.buttons ||
         (a.target_mm.z < 0.0) != (b.target_mm.z < 0.0);
}

// The movement starts at the current position of the aim. It takes the time that has passed since
// the previous aim, at least `min_ns` and at most 10 ms, or longer if the top speed requires
// that.
void GlidingAim::set(const Aim& aim, std::int64_t now_ns, std::int64_t min_ns) noexcept {
  if (!is_set_) {
    is_set_ = true;
    to_ = shown_ = aim;
    from_mm_ = aim.target_mm;
    start_ns_ = end_ns_ = now_ns;
    return;
  }
  const std::int64_t since_last_ns = now_ns - start_ns_;
  std::int64_t takes_ns = std::clamp(since_last_ns, std::min(min_ns, kLongestNs), kLongestNs);
  from_mm_ = at(now_ns);
  shown_ = to_;
  owes_one_ = !newest_is_shown_;
  newest_is_shown_ = false;
  to_ = aim;
  if (top_speed_mm_per_s_ > 0.0) {
    const double at_top_speed_s = norm(to_.target_mm - from_mm_) / top_speed_mm_per_s_;
    takes_ns = std::max(takes_ns, static_cast<std::int64_t>(1e9 * at_top_speed_s));
  }
  start_ns_ = now_ns;
  end_ns_ = now_ns + takes_ns;
}

Vec3 GlidingAim::at(std::int64_t time_ns) const noexcept {
  if (time_ns >= end_ns_) return to_.target_mm;
  if (time_ns <= start_ns_) return from_mm_;
  return lerp(from_mm_, to_.target_mm,
              static_cast<double>(time_ns - start_ns_) / static_cast<double>(end_ns_ - start_ns_));
}

const Aim& GlidingAim::shown(std::int64_t time_ns) noexcept {
  if (owes_one_) {
    owes_one_ = false;
  } else if (time_ns >= end_ns_) {
    shown_ = to_;
    newest_is_shown_ = true;
  }
  return shown_;
}

}  // namespace felt
