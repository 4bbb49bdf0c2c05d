#pragma once

#include <optional>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

namespace felt {

/// The physics of a stylus that a hand holds, or that nobody holds:
///
///   m x'' = F + k (s - x) + b (s' - x') - d x' - friction        s: the hand's aim
///
/// x is the position of the stylus, F the force of the device, and m the mass of stylus and hand
/// together. The damping d and the Coulomb friction are those of the stylus; the spring k and the
/// damping b are those of the hand. A hand also bears the weight of the stylus; without a hand, the
/// weight pulls the stylus down.
///
/// A step uses the implicit midpoint rule. With it, the energy of the linear part balances exactly
/// for every step length h, and the error is of order h^2 (with the default step, less than 1e-4 of
/// the movement). A matrix exponential would be exact, but its last bits depend on the machine.
/// Friction acts against the mean velocity of the step. If the friction is large enough, it stops
/// the body: a resting body stays exactly at rest if |F| <= friction.
///
/// The ends of the workspace are walls, at which the body stops without bouncing. Used on the
/// haptic thread; real-time safe.
class HeldBody {
 public:
  HeldBody(const StylusMechanics& mechanics, const Vec3& workspace_min,
           const Vec3& workspace_max) noexcept;

  /// Puts the stylus into a hand, or releases it (nullopt).
  void hold(const std::optional<SimulatedHand>& hand) noexcept;
  /// Moves the stylus to a position, at rest.
  void place(const Vec3& position_mm) noexcept;
  /// Sets the height, at rest in z. For a grip that does not move up and down.
  void set_height(double z_mm) noexcept;
  /// Advances the time by h_s > 0. The force is constant during the step, and the hand's aim moves
  /// at constant speed from `aim_from_mm` to `aim_to_mm`.
  void step(double h_s, const Vec3& aim_from_mm, const Vec3& aim_to_mm,
            const Force& force) noexcept;

  [[nodiscard]] const Vec3& position() const noexcept { return position_; }
  [[nodiscard]] const Vec3& velocity() const noexcept { return velocity_; }  ///< mm/s
  [[nodiscard]] bool is_held() const noexcept { return held_; }
  /// Returns the aim with which the hand brings the stylus to `target_mm` without overshooting: so
  /// far behind it that the spring makes up for the damping that is missing. Requires a hand.
  [[nodiscard]] Vec3 braking_aim_mm(const Vec3& target_mm) const noexcept;
  /// Returns the kinetic energy plus the energy of the hand's spring, mJ. Friction and damping
  /// reduce this energy.
  [[nodiscard]] double energy_mj(const Vec3& aim_mm) const noexcept;

 private:
  // Computes the coefficients for a step of this length.
  void prepare(double h_s) noexcept;
  void stop_at_walls() noexcept;

  StylusMechanics mechanics_;
  Vec3 min_, max_;
  bool held_ = false;
  // The units of these are made of N, mm and s: the mass is in N s^2/mm, and so on.
  double mass_ = 0.0, spring_ = 0.0, hand_damping_ = 0.0, damping_ = 0.0;
  double prepared_for_s_ = 0.0;
  double keep_ = 0.0;           // factor of the velocity in a step
  double gain_ = 0.0;           // mm/s per N
  double friction_step_ = 0.0;  // mm/s of mean velocity that friction can remove
  Vec3 position_, velocity_;
};

}  // namespace felt
