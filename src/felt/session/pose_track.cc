#include "felt/session/pose_track.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

bool presses(const ScriptPose& pose) {
  return pose.pressure.value_or(0.0) > 0.0;
}
bool is_deep(const ScriptPose& pose) {
  return pose.position.z < 0.0;
}

/// Returns the pose raised to this height above the surface, without pressure.
ScriptPose lifted(const ScriptPose& pose, double height_mm, std::int64_t time_ns) {
  ScriptPose up = pose;
  up.time_ns = time_ns;
  up.position.z = std::max(pose.position.z, 0.0) + height_mm;
  if (up.pressure) up.pressure = 0.0;
  return up;
}

/// Returns the pose at the start of a script. It is above the first pose, but only so high that the
/// pen can come down in time.
ScriptPose before(const ScriptPose& first, std::int64_t start_ns) {
  if (!is_deep(first) && !presses(first)) return first;
  const double left_s = 1e-9 * static_cast<double>(first.time_ns - start_ns);
  return lifted(first, std::min(PoseTrack::kHoverMm, PoseTrack::kLandingMmPerS * left_s), start_ns);
}

double part(std::int64_t now_ns, std::int64_t begin_ns, std::int64_t end_ns) {
  return static_cast<double>(now_ns - begin_ns) / static_cast<double>(end_ns - begin_ns);
}

Vec3 on_line(const Vec3& a, std::int64_t a_ns, const Vec3& b, std::int64_t b_ns,
             std::int64_t now_ns) {
  return lerp(a, b, part(now_ns, a_ns, b_ns));
}

/// Interpolates linearly. Exception: if the gap is long and the pen is down at one end only, the
/// pen moves up or down above that end within kLandingNs, and the remaining distance at hover
/// height.
Vec3 place_between(const ScriptPose& a, const ScriptPose& b, std::int64_t now_ns) {
  const bool upright = b.time_ns - a.time_ns > PoseTrack::kLongGapNs && is_deep(a) != is_deep(b);
  if (!upright) return on_line(a.position, a.time_ns, b.position, b.time_ns, now_ns);
  const ScriptPose& down = is_deep(a) ? a : b;
  const ScriptPose& up = is_deep(a) ? b : a;
  const Vec3 hover = {down.position.x, down.position.y,
                      std::min(up.position.z, PoseTrack::kHoverMm)};
  if (is_deep(b)) {  // moves above the target first, then down
    const std::int64_t landing_ns = b.time_ns - PoseTrack::kLandingNs;
    return now_ns < landing_ns ? on_line(a.position, a.time_ns, hover, landing_ns, now_ns)
                               : on_line(hover, landing_ns, b.position, b.time_ns, now_ns);
  }
  const std::int64_t lifted_ns = a.time_ns + PoseTrack::kLandingNs;
  return now_ns < lifted_ns ? on_line(a.position, a.time_ns, hover, lifted_ns, now_ns)
                            : on_line(hover, lifted_ns, b.position, b.time_ns, now_ns);
}

std::optional<double> pressure_between(const ScriptPose& a, const ScriptPose& b,
                                       std::int64_t now_ns) {
  if (presses(a) && presses(b)) {
    const double t = part(now_ns, a.time_ns, b.time_ns);
    return (1.0 - t) * *a.pressure + t * *b.pressure;
  }
  return presses(a) ? b.pressure : a.pressure;
}

/// Interpolates the tilt only if it is known in both poses.
std::optional<double> tilt_between(const ScriptPose& a, const ScriptPose& b, std::int64_t now_ns) {
  if (!a.tilt_deg || !b.tilt_deg) return a.tilt_deg;
  // lerp() returns exactly the same number for a tilt that does not change.
  return std::lerp(*a.tilt_deg, *b.tilt_deg, part(now_ns, a.time_ns, b.time_ns));
}

}  // namespace

ScriptPose between(const ScriptPose& a, const ScriptPose& b, std::int64_t now_ns) noexcept {
  if (now_ns >= b.time_ns) return b;
  if (now_ns <= a.time_ns || a.by_hand != b.by_hand) return a;
  ScriptPose pose = a;
  pose.time_ns = now_ns;
  pose.position = place_between(a, b, now_ns);
  pose.pressure = pressure_between(a, b, now_ns);
  pose.tilt_deg = tilt_between(a, b, now_ns);
  return pose;
}

PoseTrack::PoseTrack(std::span<const Event> events) : events_(events) {
  if (events_.empty()) return;
  end_ns_ = events_.back().time_ns;
  next_ = find_next();
  if (next_) last_ = before(*next_, events_.front().time_ns);
}

std::optional<ScriptPose> PoseTrack::find_next() {
  while (searched_ < events_.size()) {
    const Event& event = events_[searched_++];
    if (const auto* pen = std::get_if<PenEvent>(&event.what)) {
      return ScriptPose{event.time_ns, pen->position, pen->pressure,
                        pen->buttons,  false,         pen->tilt_deg};
    }
    if (const auto* hand = std::get_if<HandEvent>(&event.what)) {
      return ScriptPose{event.time_ns, hand->target, hand->pressure,
                        hand->buttons, true,         hand->tilt_deg};
    }
  }
  return {};
}

ScriptPose PoseTrack::at(std::int64_t now_ns) {
  while (next_ && next_->time_ns <= now_ns) {
    last_ = next_;
    next_ = find_next();
    const bool is_down = is_deep(*last_) || presses(*last_);
    if (!next_ && is_down) {
      // The pen stays down until the last event of any kind. After that it is lifted.
      last_->time_ns = std::max(last_->time_ns, end_ns_);
      next_ = lifted(*last_, kHoverMm, last_->time_ns + kLandingNs);
    }
  }
  if (!last_) return {now_ns, {0.0, 0.0, 20.0}, {}, 0, false};
  ScriptPose pose = next_ ? between(*last_, *next_, now_ns) : *last_;
  pose.time_ns = now_ns;
  return pose;
}

}  // namespace felt
