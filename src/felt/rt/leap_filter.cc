#include "felt/rt/leap_filter.h"

#include <algorithm>

namespace felt {
namespace {

/// Returns true if the pen is so far above the surface that no stroke can be in progress.
bool is_lifted(const PenSample& sample) noexcept {
  return sample.position.z >= LeapFilter::kLiftMm && !in_contact(sample);
}

}  // namespace

std::optional<PenSample> LeapFilter::pass(const PenSample& sample, std::int64_t now_ns) noexcept {
  const TickTime time = clock_.tick(now_ns);
  if (seen_ && repeats(*seen_, sample)) {
    leaps_.wait(time);
    steady_.wait(time);
    return std::nullopt;
  }
  seen_ = sample;
  if (is_lost_) {
    if (!is_steady(sample, time)) return std::nullopt;
    is_lost_ = false;
    return believe(sample, time);
  }
  switch (leaps_.judge(sample.position, time)) {
    case PositionVerdict::kBelieved:
      last_ = sample;
      was_held_ = false;
      return sample;
    case PositionVerdict::kHeld:
      if (time.lateness == Lateness::kVeryLate) {
        believe(sample, time);
        return cut(sample.time_ns);
      }
      was_held_ = true;
      return std::nullopt;
    case PositionVerdict::kFault:
      break;
  }
  if (was_held_ && is_lifted(last_) && is_lifted(sample)) return believe(sample, time);
  is_lost_ = true;
  steady_s_ = 0.0;
  steady_.reset();
  return cut(sample.time_ns);
}

/// Accepts this sample and starts checking again from it.
PenSample LeapFilter::believe(const PenSample& sample, const TickTime& time) noexcept {
  leaps_.reset();
  static_cast<void>(leaps_.judge(sample.position, time));
  was_held_ = false;
  return last_ = sample;
}

/// Ends the stroke, if one is in progress, at the last accepted position.
PenSample LeapFilter::cut(std::int64_t time_ns) noexcept {
  if (!is_lifted(last_)) ++cuts_;
  last_.time_ns = std::max(time_ns, last_.time_ns);
  last_.position.z = std::max(kLiftMm, last_.position.z);
  last_.velocity = {};
  if (last_.pressure) last_.pressure = 0.0;
  return last_;
}

bool LeapFilter::is_steady(const PenSample& sample, const TickTime& time) noexcept {
  if (steady_.judge(sample.position, time) == PositionVerdict::kBelieved) {
    steady_s_ += time.model_s;
  } else {
    steady_s_ = 0.0;
    steady_.reset();
  }
  return steady_s_ >= 1e-9 * static_cast<double>(kSteadyNs);
}

}  // namespace felt
