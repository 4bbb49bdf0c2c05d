#pragma once

#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The counter-force of a transform (paper, eq. 10; specification 5e, E14-E16; R35-R38): curves
/// that tie the selection to the rest hold it back, by how far their fixed ends *would* have moved:
///
///   translation  S = N |d|              F along -d
///   rotation     S = sum r_i |th|       F across the arm from centre to pen, against th
///   scale        S = sum r_i |ln s|     F along the arm, towards s = 1
///   |F| = min(l(S), Kcap way)           l with D = 40 mm
///
/// N anchors at distances r_i from the centre: all that the haptic thread needs to know of the
/// drawing is N or sum r_i. No anchor, no force.
///
/// `way` is how far the pen has gone, such that no slope exceeds Kcap (R38): |d|;
/// r |th|/sqrt(1 + th^2), th counted on beyond full turns; r0 (1 - min(s, 1/s)), the same for s and
/// 1/s (R37). Within 5 mm of the centre turning and scaling have no direction to speak of, and F
/// fades with r/5 mm. s is kept to 0.05..20. Damping Bed while it acts.
///
/// A share s of the stiffness budget below 1 (R56) lowers Kcap to s^2 Kcap (169 N/m at 250 Hz; with
/// s Kcap a light hand trembles) and the damping by s, and leaves the level l as it is, so that a
/// slow loop resists as much as a fast one (R30). The fade is wider then, because F/r, the slope of
/// a force that turns with the arm, must keep to Kcap too.
///
/// A constrained tether holds only what really moves (constrained()): a translation along the axis
/// of the larger component, a rotation by whole steps of kTurnStepRad. Where the axis or the step
/// changes the force starts from what it was, by Kcap times the distance from there: no jump, and
/// nothing that pushes before something has moved.
class Tether {
 public:
  /// No anchors: no force.
  Tether() noexcept = default;
  static Tether translation(Point grab, int anchors) noexcept;
  /// `gesture`: another number than that of the last rotation starts to count turns afresh.
  static Tether rotation(Point centre, Point grab, double sum_of_radii_mm,
                         std::uint32_t gesture) noexcept;
  static Tether scale(Point centre, Point grab, double sum_of_radii_mm) noexcept;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

  /// The same for a constrained transform; nothing else for a scale.
  [[nodiscard]] Tether constrained() const noexcept;
  /// The same for a scale that goes no further down than this factor.
  [[nodiscard]] Tether with_least_scale(double factor) const noexcept;
  /// kTransformLaw, unless a device cannot bear 1 N for long (ForceLaw::gain).
  [[nodiscard]] Tether with_law(const ForceLaw& law) const noexcept;

 private:
  enum class Kind : std::uint8_t { kNone, kTranslation, kRotation, kScale };

  [[nodiscard]] Vec translation_pull(Point pen) const noexcept;
  [[nodiscard]] Vec rotation_pull(Point pen, ForceMemory& memory) const noexcept;
  [[nodiscard]] Vec scale_pull(Point pen) const noexcept;
  [[nodiscard]] double size_n(double sum_mm, double way_mm) const noexcept;
  [[nodiscard]] double turn_size_n(double turn_rad, double radius_mm) const noexcept;
  [[nodiscard]] double stepped_size_n(double turn_rad, double radius_mm) const noexcept;

  ForceLaw law_ = kTransformLaw;
  Kind kind_ = Kind::kNone;
  Point centre_{};
  Point grab_{};
  double sum_ = 0.0;
  double least_scale_ = 0.0;
  std::uint32_t gesture_ = 0;
  bool constrained_ = false;
};

/// A constrained rotation goes by steps of 15 degrees.
inline constexpr double kTurnStepRad = 15.0 * 3.14159265358979323846 / 180.0;

/// The angle by which `arm` is turned from `first_arm`, rad, counted on from the angle of a moment
/// ago so that full turns add up: the value nearest to `last_rad`. An arm of no length keeps it.
/// For the transform tool and its force alike.
double unwrapped_turn_rad(Vec first_arm, Vec arm, double last_rad) noexcept;

/// Scale factor of a pen at `arm` from the centre, grabbed at `first_arm`: 0.05..20; 1 where
/// first_arm has no length.
double scale_factor(Vec first_arm, Vec arm) noexcept;

}  // namespace felt
