#include "felt/haptics/safety/safety_motors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

constexpr double kLongestTickS = 0.005;

}  // namespace

double sustained_force_n(const SafetyLimits& limits) noexcept {
  if (!(limits.continuous_force_n > 0.0)) return std::numeric_limits<double>::infinity();
  const double tau_s = 0.5 * limits.rms_window_s;
  return limits.continuous_force_n * std::sqrt(limits.rms_window_s / (limits.rms_window_s + tau_s));
}

MotorGuard::MotorGuard(const SafetyLimits& limits) noexcept
    : tau_s_(0.5 * limits.rms_window_s),
      sustained_n_(limits.continuous_force_n > 0.0 ? sustained_force_n(limits) : 0.0),
      // A fade from F to s N at `slope` costs (F - s)^2 (F + 2 s)/(3 slope) N^2 s more than holding
      // s; with F + 2 s <= peak + 2 s this is solved for F.
      gain_(3.0 * (limits.peak_force_n / limits.rms_fade_s) * tau_s_ /
            (limits.peak_force_n + 2.0 * sustained_n_)) {
  if (!(gain_ > 0.0)) gain_ = 0.0;  // no peak: 0/0
}

void MotorGuard::heat(double force_n, double duration_s) noexcept {
  // Implicit, so that the energy balance holds for any duration.
  const double share = duration_s / tau_s_;
  mean_square_ = (mean_square_ + share * force_n * force_n) / (1.0 + share);
}

double MotorGuard::allowed_n() const noexcept {
  if (!(sustained_n_ > 0.0)) return std::numeric_limits<double>::infinity();
  const double room = std::max(sustained_n_ * sustained_n_ - mean_square_, 0.0);
  const double fading = sustained_n_ + std::sqrt(gain_ * room);
  // What fits into the room within a single tick, for the very end of the fade.
  const double in_a_tick = std::sqrt(sustained_n_ * sustained_n_ + room * (tau_s_ / kLongestTickS));
  return std::min(fading, in_a_tick);
}

double MotorGuard::rms_n() const noexcept {
  return std::sqrt(mean_square_);
}

bool MotorGuard::is_warm(bool limited) noexcept {
  if (limited) {
    warm_ = true;
  } else if (mean_square_ < 0.5 * sustained_n_ * sustained_n_) {
    warm_ = false;
  }
  return warm_;
}

}  // namespace felt
