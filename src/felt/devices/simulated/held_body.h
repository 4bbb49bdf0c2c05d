#pragma once

#include <optional>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

namespace felt {

/// The physics of a stylus in a hand, or alone:
///
///   m x'' = F + k (s - x) + b (s' - x') - d x' - friction        s: the hand's aim
///
/// m is the mass of stylus and hand; d and the Coulomb friction are the stylus'; k and b are the
/// hand's. A hand also bears the stylus' weight; without a hand, the weight pulls the stylus down.
///
/// A step uses the implicit midpoint rule: the energy of the linear part balances exactly for every
/// step length, and the error is of order h^2 (at the default step below 1e-4 of the movement). A
/// matrix exponential would be exact, but its last bits depend on the machine. Friction acts
/// against the mean velocity of the step and stops the body if it is large enough: if |F| <=
/// friction, a resting body stays exactly at rest.
///
/// The ends of the workspace are walls without bounce. Used on the haptic thread; real-time safe.
class HeldBody {
 public:
  HeldBody(const StylusMechanics& mechanics, const Vec3& workspace_min,
           const Vec3& workspace_max) noexcept;

  /// Puts the stylus into a hand, or releases it (nullopt).
  void hold(const std::optional<SimulatedHand>& hand) noexcept;
  /// Moves the stylus to a position, at rest.
  void place(const Vec3& position_mm) noexcept;
  /// Advances the time by h_s > 0. The force is constant, and the hand's aim moves evenly between
  /// the two positions.
  void step(double h_s, const Vec3& aim_from_mm, const Vec3& aim_to_mm,
            const Force& force) noexcept;

  [[nodiscard]] const Vec3& position() const noexcept { return position_; }
  [[nodiscard]] const Vec3& velocity() const noexcept { return velocity_; }  ///< mm/s
  [[nodiscard]] bool is_held() const noexcept { return held_; }
  /// Returns the energy of the motion and of the hand's spring, mJ. Friction and damping dissipate
  /// it.
  [[nodiscard]] double energy_mj(const Vec3& aim_mm) const noexcept;

 private:
  // Computes the coefficients for a step of this length.
  void prepare(double h_s) noexcept;
  void stop_at_walls() noexcept;

  StylusMechanics mechanics_;
  Vec3 min_, max_;
  bool held_ = false;
  // These are in N, mm and s: mass in N s^2/mm, and so on.
  double mass_ = 0.0, spring_ = 0.0, hand_damping_ = 0.0, damping_ = 0.0;
  double prepared_for_s_ = 0.0;
  double keep_ = 0.0;           // factor of the velocity in a step
  double gain_ = 0.0;           // mm/s per N
  double friction_step_ = 0.0;  // mm/s of mean velocity that friction can remove
  Vec3 position_, velocity_;
};

}  // namespace felt
