#include "felt/rt/leap_filter.h"

#include <algorithm>

namespace felt {

std::optional<PenSample> LeapFilter::pass(const PenSample& sample, std::int64_t now_ns) noexcept {
  const TickTime time = clock_.tick(now_ns);
  if (is_lost_) {
    if (!is_back(sample, time)) return std::nullopt;
    is_lost_ = false;
    leaps_.reset();
  }
  switch (leaps_.judge(sample.position, time)) {
    case PositionVerdict::kBelieved:
      last_ = sample;
      was_held_ = false;
      return sample;
    case PositionVerdict::kHeld:
      was_held_ = true;
      return std::nullopt;
    case PositionVerdict::kFault:
      break;
  }
  if (was_held_ && !(in_contact(last_) && in_contact(sample))) {
    leaps_.reset();
    static_cast<void>(leaps_.judge(sample.position, time));
    last_ = sample;
    return sample;
  }
  is_lost_ = true;
  steady_s_ = 0.0;
  steady_.reset();
  return lifted(sample.time_ns);
}

PenSample LeapFilter::lifted(std::int64_t time_ns) const noexcept {
  PenSample lifted = last_;
  lifted.time_ns = std::max(time_ns, last_.time_ns);
  lifted.position.z = std::max(kLiftMm, last_.position.z);
  lifted.velocity = {};
  if (lifted.pressure) lifted.pressure = 0.0;
  return lifted;
}

bool LeapFilter::is_back(const PenSample& sample, const TickTime& time) noexcept {
  if (steady_.judge(sample.position, time) == PositionVerdict::kBelieved) {
    steady_s_ += time.model_s;
  } else {
    steady_s_ = 0.0;
    steady_.reset();
  }
  return steady_s_ >= 1e-9 * static_cast<double>(kSteadyNs) && !in_contact(sample);
}

}  // namespace felt
