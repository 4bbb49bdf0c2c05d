#pragma once

#include <array>
#include <optional>

#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

namespace felt::pantograph {

/// Lengths of a five-bar linkage whose two motors stand side by side, mm: motor 1 at (0, 0), motor
/// 2 at (base, 0); each turns an arm, and two forearms meet at the handle.
struct FiveBarSize {
  double arm_mm = 0.0;
  double forearm_mm = 0.0;
  double base_mm = 0.0;
};

/// Where the handle is for the angles of both arms, and how forces there become torques at the
/// motors.
///
/// With A and B the elbows, E the handle and u = E - A, w = E - B, the forearms' lengths are
/// constant: u . E' = u . A' and w . E' = w . B', hence
///   J = 1/(u x w) [ w_y (u.a)  -u_y (w.b) ; -w_x (u.a)  u_x (w.b) ],   a = dA/dth1, b = dB/dth2
/// and torques are J^T F, so that F . v = tau . omega whatever the angles are.
///
/// u x w = L^2 sin(angle between the forearms). Where they come into line, or elbows meet, small
/// torques would be huge forces the other way round: authority() falls to 0 before that.
class FiveBar {
 public:
  static constexpr double kNoAuthority = 0.10;   ///< sine of the forearms' angle: no force below it
  static constexpr double kAllAuthority = 0.30;  ///< all of it from here on

  /// Angles in rad, counter-clockwise from +x. Nothing: the arms cannot be like this (elbows too
  /// far apart, or one in the other). Of the two places that fit, the one on the left of A to B:
  /// before the motors, when arm 1 points to the left.
  static std::optional<FiveBar> at(const FiveBarSize& size,
                                   const std::array<double, 2>& angles_rad) noexcept;

  /// The handle, mm; z is 0.
  [[nodiscard]] Vec3 place() const noexcept { return place_; }
  /// Its velocity for those of the motors, mm/s from rad/s.
  [[nodiscard]] Vec3 velocity(const std::array<double, 2>& omega_rad_s) const noexcept;
  /// Torques of the motors, N m, that push the handle with this force (x and y of it).
  [[nodiscard]] std::array<double, 2> torques(const Force& force) const noexcept;
  /// Which share of a force may be asked for here, 0..1: 0 near a singular place.
  [[nodiscard]] double authority() const noexcept { return authority_; }
  /// dE/dth, mm/rad: row x, row y.
  [[nodiscard]] const std::array<std::array<double, 2>, 2>& jacobian() const noexcept {
    return jacobian_;
  }

 private:
  Vec3 place_;
  std::array<std::array<double, 2>, 2> jacobian_{};
  double authority_ = 0.0;
};

/// The angles that put the handle there, with both elbows outside; nothing: out of reach. For
/// tests and fakes.
std::optional<std::array<double, 2>> angles_for(const FiveBarSize& size,
                                                const Vec3& place) noexcept;

}  // namespace felt::pantograph
