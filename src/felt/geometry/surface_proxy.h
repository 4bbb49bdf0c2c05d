#pragma once

#include <cstddef>

#include "felt/geometry/vec3.h"

namespace felt {

class TriangleTree;

/// The point of a pen that stays outside a body (god-object: Zilles and Salisbury 1995, DOI
/// 10.1109/IROS.1995.525876; friction cone: Ruspini, Kolarov, Khatib 1997, DOI
/// 10.1145/258734.258878). Every part of a step is swept, so that the proxy passes no triangle from
/// its front, at any speed. Trivially copyable; real-time safe.
class SurfaceProxy {
 public:
  /// Planes that may stop a step, each after one sweep; a last sweep follows the third.
  static constexpr std::size_t kPlanes = 3;
  /// Distance that the proxy keeps from a plane, mm: below what any device resolves (0.01 mm), far
  /// above rounding (1e-13 mm at coordinates of 1 m).
  static constexpr double kGapMm = 1e-3;

  /// Longest movement of one sweep, mm, so that a sweep stays short when the pen is far away across
  /// the body: 2 m/s at 1 kHz, four times the speed of a fast hand (0.5 m/s).
  static constexpr double kReachMm = 2.0;

  /// Puts the proxy at the pen, without contact. `pen` must be outside the body.
  void reset(const Vec3& pen) noexcept;

  /// Moves the proxy towards the pen and returns its place, mm. `friction` is the coefficient of
  /// friction (at least 0). A pen that is not finite leaves the proxy where it is.
  Vec3 step(const TriangleTree& body, const Vec3& pen, double friction) noexcept;

  [[nodiscard]] const Vec3& place() const noexcept { return place_; }
  /// Returns true if a triangle held the proxy back in the last step.
  [[nodiscard]] bool touches() const noexcept { return touches_; }
  /// Returns the unit normal of the contact: that of the triangle that holds the proxy, or the
  /// resultant of several. Zero if nothing held the proxy back in the last step, or if the pen is
  /// not behind what did.
  [[nodiscard]] const Vec3& normal() const noexcept { return normal_; }

 private:
  Vec3 place_{};
  Vec3 normal_{};
  bool touches_ = false;
};

}  // namespace felt
