#include "felt/driver/force_gate.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kShareOfNominal = 0.9;  // architecture section 10, "peak force"
constexpr double kFadeS = 0.1;

double sane(double value) noexcept {
  return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

double most_for(const Capabilities& device) noexcept {
  if (!device.has_force()) return 0.0;
  const double most_n = kShareOfNominal * sane(device.max_force_n);
  return device.advised_force_n == 0.0 ? most_n : std::min(most_n, sane(device.advised_force_n));
}

// RMS over any 10 s within the whole rating; the chain's is within 80 %. The fade is ten times as
// steep as the chain's, so that what the chain allows lies below it at every temperature.
SafetyLimits motor_limits(const Capabilities& device, double most_n) noexcept {
  SafetyLimits limits;
  limits.peak_force_n = most_n;
  limits.continuous_force_n = sane(device.continuous_force_n);
  limits.rms_fade_s = kFadeS;
  return limits;
}

}  // namespace

ForceGate::ForceGate(const Capabilities& device) noexcept
    : most_n_(most_for(device)), motors_(motor_limits(device, most_n_)) {}

ForceGate::Passed ForceGate::pass(const Force& asked, std::int64_t now_ns) noexcept {
  if (held_since_ns_ && now_ns > *held_since_ns_) {
    motors_.heat(held_n_,
                 1e-9 * (static_cast<double>(now_ns) - static_cast<double>(*held_since_ns_)));
  }
  held_since_ns_ = std::max(now_ns, held_since_ns_.value_or(now_ns));
  held_n_ = 0.0;
  if (!is_finite(asked)) return {{}, false, true};
  // Relative to its largest part, so that the length of no finite force overflows.
  const double part_n = std::max({std::abs(asked.x), std::abs(asked.y), std::abs(asked.z)});
  if (part_n == 0.0) return {};
  const Force direction{asked.x / part_n, asked.y / part_n, asked.z / part_n};
  const double length = norm(direction);
  const double allowed_n = std::min(most_n_, motors_.allowed_n());
  if (part_n * length <= allowed_n) {
    held_n_ = part_n * length;
    return {asked, true, false};
  }
  held_n_ = allowed_n;
  // A hair less: no rounding makes it longer than allowed.
  return {(allowed_n * (1.0 - 1e-14) / length) * direction, true, true};
}

}  // namespace felt
