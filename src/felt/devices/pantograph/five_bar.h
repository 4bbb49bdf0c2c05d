#pragma once

#include <array>
#include <optional>

#include "felt/geometry/vec3.h"
#include "felt/haptics/force.h"

namespace felt::pantograph {

/// Lengths of a five-bar linkage whose two motors are side by side, mm: motor 1 at (0, 0), motor 2
/// at (base, 0). Each motor turns an arm, and two forearms meet at the handle.
struct FiveBarSize {
  double arm_mm = 0.0;
  double forearm_mm = 0.0;
  double base_mm = 0.0;
};

/// Computes the position of the handle from the angles of both arms, and the motor torques for a
/// force at the handle.
///
/// Let A and B be the elbows, E the handle, u = E - A, w = E - B, th1 and th2 the angles of the
/// arms, and ' the derivative with respect to time. Because the forearms' lengths are constant,
///   u . E' = u . A',   w . E' = w . B'.
/// Therefore
///   J = 1/(u x w) [ w_y (u.a)  -u_y (w.b) ; -w_x (u.a)  u_x (w.b) ],   a = dA/dth1, b = dB/dth2
/// is the Jacobian dE/dth. The torques are J^T F, so at all angles the power at the handle, F . v,
/// equals the power of the motors, tau . omega.
///
/// u x w = L^2 sin(angle between the forearms), where L is the length of a forearm. If the forearms
/// are nearly in line, or the elbows nearly meet, small torques cause huge forces. Therefore
/// authority(), the factor for forces, falls to 0 before the linkage reaches such a position.
class FiveBar {
 public:
  static constexpr double kNoAuthority = 0.10;   ///< sine of the forearms' angle; no force below
  static constexpr double kAllAuthority = 0.30;  ///< sine of the forearms' angle; full force above

  /// Returns the linkage for angles in rad, counter-clockwise from +x. Returns nullopt if the arms
  /// cannot have these angles (elbows too far apart, or at the same point). For each pair of
  /// angles, two positions of the handle are possible. This function chooses the position on the
  /// left of the directed line from A to B. If arm 1 points towards -x and arm 2 towards +x, this
  /// position is on the +y side of the line.
  static std::optional<FiveBar> at(const FiveBarSize& size,
                                   const std::array<double, 2>& angles_rad) noexcept;

  /// Returns the position of the handle, mm; z is 0.
  [[nodiscard]] Vec3 place() const noexcept { return place_; }
  /// Returns the handle's velocity, mm/s, from the motors' angular velocities, rad/s.
  [[nodiscard]] Vec3 velocity(const std::array<double, 2>& omega_rad_s) const noexcept;
  /// Returns the motors' torques, N m, for this force at the handle. Uses the force's x and y only.
  [[nodiscard]] std::array<double, 2> torques(const Force& force) const noexcept;
  /// Returns the factor, 0..1, by which a force at this position must be multiplied. It is 0 near a
  /// singular position.
  [[nodiscard]] double authority() const noexcept { return authority_; }
  /// Returns the Jacobian dE/dth in mm/rad. Its rows are x and y.
  [[nodiscard]] const std::array<std::array<double, 2>, 2>& jacobian() const noexcept {
    return jacobian_;
  }

 private:
  Vec3 place_;
  std::array<std::array<double, 2>, 2> jacobian_{};
  double authority_ = 0.0;
};

/// Returns the angles of both arms for a position of the handle, with the elbows pointing outwards.
/// Returns nullopt if the position is out of reach. For tests and fakes.
std::optional<std::array<double, 2>> angles_for(const FiveBarSize& size,
                                                const Vec3& place) noexcept;

}  // namespace felt::pantograph
