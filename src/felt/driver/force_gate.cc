#include "felt/driver/force_gate.h"

#include <algorithm>
#include <cmath>

#include "felt/haptics/safety/safety_stages.h"

namespace felt {
namespace {

constexpr double kShareOfNominal = 0.9;  // docs/design/limits.md#peak
constexpr double kFadeS = 0.1;
constexpr double kRoundingN =
    1e-9;  // margin for the rotation into the device's frame, and for the chain's clock

double sane(double value) noexcept {
  return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

double most_for(const Capabilities& device) noexcept {
  if (!device.has_force()) return 0.0;
  const double max_n = kShareOfNominal * sane(device.max_force_n);
  return device.advised_force_n == 0.0 ? max_n : std::min(max_n, sane(device.advised_force_n));
}

// Returns the longest time for which the force may rise in one call, ms. It is the same as in the
// chain's TickClock: two periods, at most 5 ms.
double longest_credit_for(const Capabilities& device) noexcept {
  constexpr double kMaxMs = 5.0;
  return std::clamp(2e-6 * static_cast<double>(device.period_ns), 0.0, kMaxMs);
}

// Returns limits that allow the full rated RMS force over any 10 s; the safety chain allows only 80
// % of it. The limit falls ten times as steeply with the motor temperature as that of the chain, so
// that the chain's limit is the lower one at every temperature.
SafetyLimits motor_limits(const Capabilities& device, double max_n) noexcept {
  SafetyLimits limits;
  limits.peak_force_n = max_n;
  limits.continuous_force_n = sane(device.continuous_force_n);
  limits.rms_fade_s = kFadeS;
  return limits;
}

}  // namespace

ForceGate::ForceGate(const Capabilities& device) noexcept
    : max_n_(most_for(device)),
      longest_credit_ms_(longest_credit_for(device)),
      motors_(motor_limits(device, max_n_)) {}

// Updates the motor model with the last force and the time for which it was held. Returns the part
// of that time during which the force may rise, ms.
double ForceGate::credit_ms(std::int64_t now_ns) noexcept {
  if (!held_since_ns_) {
    held_since_ns_ = now_ns;
    return 0.5 * longest_credit_ms_;
  }
  const double since_ms =
      1e-6 * (static_cast<double>(now_ns) - static_cast<double>(*held_since_ns_));
  held_since_ns_ = now_ns;
  if (!(since_ms > 0.0)) return 0.0;
  motors_.heat(norm(held_), 1e-3 * since_ms);
  return std::min(since_ms, longest_credit_ms_);
}

// Reduces the force to the limit and keeps its direction.
Force ForceGate::shortened(const Force& asked) const noexcept {
  // Divides by the largest component first, so that the norm of a finite force cannot overflow.
  const double part_n = std::max({std::abs(asked.x), std::abs(asked.y), std::abs(asked.z)});
  if (part_n == 0.0) return {};
  const Force direction{asked.x / part_n, asked.y / part_n, asked.z / part_n};
  const double length = norm(direction);
  const double allowed_n = std::min(max_n_, motors_.allowed_n());
  if (part_n * length <= allowed_n) return asked;
  // Uses slightly less than the limit, so that rounding cannot exceed it.
  return (allowed_n * (1.0 - 1e-14) / length) * direction;
}

ForceGate::Passed ForceGate::pass(const Force& asked, std::int64_t now_ns) noexcept {
  const double step_n = kRiseNPerMs * credit_ms(now_ns);
  if (!is_finite(asked)) {
    held_ = {};
    return {{}, false, true};
  }
  held_ = limit_rise(held_, shortened(asked), step_n + kRoundingN);
  return {held_, true, held_ != asked};
}

}  // namespace felt
