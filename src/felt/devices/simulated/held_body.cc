#include "felt/devices/simulated/held_body.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kPerMm = 1e-3;  // N/m to N/mm, kg to N s^2/mm
constexpr double kMinMassKg = 1e-3;

// Stops one axis at its walls.
void stop_axis(double& position, double& velocity, double low, double high) noexcept {
  if (position < low) {
    position = low;
    velocity = std::max(velocity, 0.0);
  } else if (position > high) {
    position = high;
    velocity = std::min(velocity, 0.0);
  }
}

}  // namespace

HeldBody::HeldBody(const StylusMechanics& mechanics, const Vec3& workspace_min,
                   const Vec3& workspace_max) noexcept
    : mechanics_(mechanics), min_(workspace_min), max_(workspace_max) {
  hold(std::nullopt);
}

void HeldBody::hold(const std::optional<SimulatedHand>& hand) noexcept {
  held_ = hand.has_value();
  const SimulatedHand h = hand.value_or(
      SimulatedHand{.mass_kg = 0.0, .stiffness_n_per_m = 0.0, .damping_n_s_per_m = 0.0});
  mass_ = kPerMm * std::max(mechanics_.mass_kg + h.mass_kg, kMinMassKg);
  spring_ = kPerMm * h.stiffness_n_per_m;
  hand_damping_ = kPerMm * h.damping_n_s_per_m;
  damping_ = hand_damping_ + kPerMm * mechanics_.viscous_n_s_per_m;
  prepared_for_s_ = 0.0;
}

void HeldBody::place(const Vec3& position_mm) noexcept {
  position_ = position_mm;
  velocity_ = {};
  stop_at_walls();
}

void HeldBody::set_height(double z_mm) noexcept {
  position_.z = z_mm;
  velocity_.z = 0.0;
  stop_at_walls();
}

void HeldBody::prepare(double h_s) noexcept {
  prepared_for_s_ = h_s;
  const double resisting = 0.25 * h_s * h_s * spring_ + 0.5 * h_s * damping_;
  const double inertia = mass_ + resisting;
  keep_ = (mass_ - resisting) / inertia;
  gain_ = h_s / inertia;
  friction_step_ = 0.5 * gain_ * mechanics_.friction_n;
}

// Does one implicit midpoint step: computes the mean velocity of the step without friction, reduces
// this velocity by as much as friction can (at most to zero), and derives the new velocity and
// position from the result.
void HeldBody::step(double h_s, const Vec3& aim_from_mm, const Vec3& aim_to_mm,
                    const Force& force) noexcept {
  if (h_s != prepared_for_s_) prepare(h_s);
  Vec3 push{force.x, force.y, force.z};
  if (held_) {
    const Vec3 aim_velocity = (1.0 / h_s) * (aim_to_mm - aim_from_mm);
    push += spring_ * (0.5 * (aim_from_mm + aim_to_mm) - position_) + hand_damping_ * aim_velocity;
  } else {
    push.z -= mechanics_.weight_n;
  }
  Vec3 mean = 0.5 * ((1.0 + keep_) * velocity_ + gain_ * push);
  if (friction_step_ > 0.0) {
    const double speed_squared = norm_squared(mean);
    if (speed_squared <= friction_step_ * friction_step_) {
      velocity_ = {};
      return;
    }
    mean = (1.0 - friction_step_ / std::sqrt(speed_squared)) * mean;
  }
  velocity_ = 2.0 * mean - velocity_;
  position_ += h_s * mean;
  stop_at_walls();
}

void HeldBody::stop_at_walls() noexcept {
  stop_axis(position_.x, velocity_.x, min_.x, max_.x);
  stop_axis(position_.y, velocity_.y, min_.y, max_.y);
  stop_axis(position_.z, velocity_.z, min_.z, max_.z);
}

Vec3 HeldBody::braking_aim_mm(const Vec3& target_mm) const noexcept {
  if (spring_ <= 0.0) return target_mm;
  const double missing = std::max(2.0 * std::sqrt(spring_ * mass_) - damping_, 0.0);
  return target_mm - (missing / spring_) * velocity_;
}

double HeldBody::energy_mj(const Vec3& aim_mm) const noexcept {
  return 0.5 * (mass_ * norm_squared(velocity_) + spring_ * norm_squared(aim_mm - position_));
}

}  // namespace felt
