#include "felt/devices/simulated/landing_wait.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

bool touches(const Aim& aim) noexcept {
  return aim.target_mm.z < 0.0 || aim.pressure.value_or(0.0) > 0.0;
}

void move_to(const Vec3& target_mm, std::int64_t now_ns, std::int64_t tick_ns,
             GlidingAim& aim) noexcept {
  Aim moved = aim.newest();
  moved.target_mm = target_mm;
  aim.set(moved, now_ns, tick_ns);
}

}  // namespace

/// Returns true if the stylus is above the surface, low enough, does not fall, and is near the
/// place and slow, or if friction holds it there. At the turning point of an oscillation it has no
/// speed for one read only, so friction counts after two.
bool LandingWait::is_at_rest(const Aim& next, const HeldBody& body) noexcept {
  const Vec3 off = body.position() - next.target_mm;
  const Vec3& velocity = body.velocity();
  const double speed = std::hypot(velocity.x, velocity.y);
  const bool was_stuck = is_stuck_;
  is_stuck_ = speed == 0.0;
  const bool is_near = std::hypot(off.x, off.y) <= kNearMm && speed <= kSlowMmPerS;
  const double height_mm = body.position().z;
  const bool is_low = height_mm >= 0.0 && height_mm <= kMaxHeightMm + kNearMm;
  const bool falls = velocity.z < -kSlowMmPerS;
  return is_low && !falls && (is_near || (was_stuck && is_stuck_));
}

bool LandingWait::holds(const Aim& next, std::int64_t late_ns, const HeldBody& body,
                        std::int64_t now_ns, std::int64_t tick_ns, GlidingAim& aim) noexcept {
  if (phase_ == Phase::kDown) {
    if (body.position().z >= 0.0 && now_ns < until_ns_) return true;
    phase_ = Phase::kNone;
  }
  if (!touches(next) || touches(aim.newest())) {
    phase_ = Phase::kNone;
    return false;
  }
  if (phase_ == Phase::kNone) {
    phase_ = Phase::kAbove;
    is_stuck_ = false;
    const Vec3 from = aim.newest().target_mm;
    above_mm_ = {next.target_mm.x, next.target_mm.y, std::min(from.z, kMaxHeightMm)};
    if (!(above_mm_ == from)) move_to(above_mm_, now_ns, tick_ns, aim);
    arrives_ns_ = aim.arrives_ns();
    const double patience = 1.0 - static_cast<double>(late_ns) / kMaxLateNs;
    until_ns_ =
        arrives_ns_ + static_cast<std::int64_t>(std::clamp(patience, 0.0, 1.0) * kMaxAboveNs);
  }
  const bool at_rest = is_at_rest(next, body);
  const bool is_up = body.position().z >= 0.0 || now_ns >= arrives_ns_ + kMaxAboveNs;
  if (now_ns < arrives_ns_ || !is_up || (!at_rest && now_ns < until_ns_)) {
    Vec3 braking = body.braking_aim_mm(above_mm_);
    braking.z = std::max(braking.z, std::min(above_mm_.z, kMinHeightMm));
    move_to(braking, now_ns, tick_ns, aim);
    return true;
  }
  phase_ = Phase::kDown;
  until_ns_ = now_ns + kMaxDownNs;
  return false;
}

}  // namespace felt
