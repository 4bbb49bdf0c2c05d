#include "felt/devices/hapticmaster/motion_check.h"

#include <algorithm>
#include <cmath>

namespace felt::hapticmaster {
namespace {

constexpr double kSPerNs = 1e-9;

double seconds_between(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return kSPerNs * (static_cast<double>(to_ns) - static_cast<double>(from_ns));
}

bool is_within(const Box& box, const Vec3& p, double margin_mm) noexcept {
  const auto within = [margin_mm](double v, double low, double high) {
    return v >= low - margin_mm && v <= high + margin_mm;
  };
  return within(p.x, box.min_mm.x, box.max_mm.x) && within(p.y, box.min_mm.y, box.max_mm.y) &&
         within(p.z, box.min_mm.z, box.max_mm.z);
}

}  // namespace

bool MotionCheck::is_possible(const MotionReport& report) const noexcept {
  if (!report.position_mm || !report.velocity_mm_per_s) return false;
  const double speed = norm(*report.velocity_mm_per_s);
  if (!(speed <= kMaxSpeedMmPerS) || !is_within(reach_, *report.position_mm, kBeyondMm)) {
    return false;
  }
  const double step_s = seconds_between(last_ns_, report.asked_ns);
  const bool is_next = step_s > 0.0 && step_s < kSPerNs * static_cast<double>(kMaxStepNs);
  if (!is_next || positions_ < kSteadyPositions) return true;
  const double max_mm_per_s = kMaxErrorMmPerS + std::max(norm(last_mm_per_s_), speed);
  return norm(*report.position_mm - last_mm_) <= max_mm_per_s * step_s;
}

// Adds a step of the position, and subtracts the way that the velocity explains.
void MotionCheck::add(const Vec3& step_mm, const Vec3& mean_mm_per_s, double step_s) noexcept {
  error_mm_ = (1.0 - step_s / kMemoryS) * error_mm_ + step_mm - step_s * mean_mm_per_s;
  speed_mm_per_s_ = std::max(norm(mean_mm_per_s), (1.0 - step_s / kSpeedMemoryS) * speed_mm_per_s_);
}

void MotionCheck::follow_still(const Vec3& position_mm, const Vec3& mm_per_s,
                               double step_s) noexcept {
  const std::array<double, 3> at{position_mm.x, position_mm.y, position_mm.z};
  const std::array<double, 3> speed{mm_per_s.x, mm_per_s.y, mm_per_s.z};
  for (std::size_t i = 0; i < frozen_.size(); ++i) {
    Frozen& frozen = frozen_[i];
    if (std::abs(at[i] - frozen.at_mm) > kStillMm) {
      frozen = {at[i], 0.0};
    } else {
      frozen.way_mm += step_s * std::max(0.0, std::abs(speed[i]) - kMovingMmPerS);
    }
  }
}

bool MotionCheck::is_consistent() const noexcept {
  const bool is_frozen = std::any_of(frozen_.begin(), frozen_.end(),
                                     [](const Frozen& f) { return f.way_mm > kFrozenMm; });
  return !is_frozen && norm(error_mm_) <= kErrorMm + kLagS * speed_mm_per_s_;
}

MotionVerdict MotionCheck::judge(const MotionReport& report) noexcept {
  if (!is_possible(report)) return MotionVerdict::kImpossible;
  const Vec3 position_mm = *report.position_mm, mm_per_s = *report.velocity_mm_per_s;
  const double step_s = seconds_between(last_ns_, report.asked_ns);
  const bool is_next = step_s > 0.0 && step_s < kSPerNs * static_cast<double>(kMaxStepNs);
  if (!is_next) restart();
  if (positions_ >= kSteadyPositions && step_s <= kSPerNs * static_cast<double>(kMaxSumNs)) {
    const Vec3 mean_mm_per_s = 0.5 * (last_mm_per_s_ + mm_per_s);
    add(position_mm - last_mm_, mean_mm_per_s, step_s);
    follow_still(position_mm, mean_mm_per_s, step_s);
  }
  positions_ = std::min(positions_ + 1, kSteadyPositions);
  last_mm_ = position_mm;
  last_mm_per_s_ = mm_per_s;
  last_ns_ = report.asked_ns;
  return is_consistent() ? MotionVerdict::kGood : MotionVerdict::kInconsistent;
}

}  // namespace felt::hapticmaster
