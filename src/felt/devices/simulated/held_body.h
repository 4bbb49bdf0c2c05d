#pragma once

#include <optional>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

namespace felt {

/// The physics of a stylus in a hand, or alone:
///
///   m x'' = F + k (s - x) + b (s' - x') - d x' - friction        s: where the hand wants it
///
/// with m, d and the Coulomb friction of the stylus, mass, k and b of the hand. A hand also bears
/// the stylus' weight; alone, the weight pulls. Steps are implicit midpoint: exact balance of
/// energy in the linear part for every step length, error of order h^2 (at the default step below
/// 1e-4 of the movement), no matrix exponential whose last bits depend on the machine. Friction
/// acts against the mean velocity of the step and stops the body where it can: |F| <= friction
/// means that the body stands still, exactly, for ever.
///
/// Ends of the workspace are walls without bounce. Haptic thread: real-time safe.
class HeldBody {
 public:
  HeldBody(const StylusMechanics& mechanics, const Vec3& workspace_min,
           const Vec3& workspace_max) noexcept;

  /// Takes the stylus into a hand, or lets it go.
  void hold(const std::optional<SimulatedHand>& hand) noexcept;
  /// Puts it somewhere, at rest.
  void place(const Vec3& position_mm) noexcept;
  /// One step of h_s > 0 under a constant force, while the hand's aim moves evenly from one place
  /// to the other.
  void step(double h_s, const Vec3& aim_from_mm, const Vec3& aim_to_mm,
            const Force& force) noexcept;

  [[nodiscard]] const Vec3& position() const noexcept { return position_; }
  [[nodiscard]] const Vec3& velocity() const noexcept { return velocity_; }  ///< mm/s
  [[nodiscard]] bool is_held() const noexcept { return held_; }
  /// Motion, and the hand's spring where the aim is: what friction and damping have left to take.
  [[nodiscard]] double energy_mj(const Vec3& aim_mm) const noexcept;

 private:
  // Coefficients of a step of this length.
  void prepare(double h_s) noexcept;
  void stop_at_walls() noexcept;

  StylusMechanics mechanics_;
  Vec3 min_, max_;
  bool held_ = false;
  // In N, mm and s: mass in N s^2/mm, and so on.
  double mass_ = 0.0, spring_ = 0.0, hand_damping_ = 0.0, damping_ = 0.0;
  double prepared_for_s_ = 0.0;
  double keep_ = 0.0;           // share of the velocity that is left
  double gain_ = 0.0;           // mm/s per N
  double friction_step_ = 0.0;  // mm/s of mean velocity that friction can take
  Vec3 position_, velocity_;
};

}  // namespace felt
