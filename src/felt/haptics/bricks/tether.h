#pragma once

#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_law.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The counter-force of a transform (paper, eq. 10; docs/design/forces.md#tether; R35-R38). Curves
/// that connect the selection to the rest of the drawing resist the transform. The resistance grows
/// with S, the sum of the distances that the fixed ends of these curves (anchors) would have moved
/// if they belonged to the selection. For a translation by d, a rotation by th or a scaling by s:
///
///   translation  S = N |d|              F along -d
///   rotation     S = sum r_i |th|       F across the arm from centre to pen, against th
///   scale        S = sum r_i |ln s|     F along the arm, towards s = 1
///   |F| = min(l(S), Kcap way)           l with D = 40 mm
///
/// N is the number of anchors, and r_i are their distances from the centre. The haptic thread needs
/// only N or sum r_i from the drawing. Without anchors the force is zero.
///
/// `way` is the distance that the pen has moved, defined so that no slope exceeds Kcap (R38). For a
/// translation it is |d|. For a rotation it is max(r, 5 mm) |th|/sqrt(1 + th^2), where r is the
/// distance of the pen from the centre, and th counts full turns. For a scaling it is r0 (1 -
/// min(s, 1/s)), which is the same for s and 1/s (R37); r0 is the distance of the grabbed point
/// from the centre. Within 5 mm of the centre, the direction of a rotation or scaling is not well
/// defined, so F is multiplied by r/5 mm. s is limited to 0.05..20. A tether with anchors also
/// damps the motion of the pen (Bed).
///
/// If the share c of the stiffness budget is below 1 (R56), Kcap is multiplied by c^2 and the
/// damping by c. This gives 169 N/m at 250 Hz; with Kcap multiplied only by c, a light hand would
/// tremble. The level l does not change, so that a slow loop resists as strongly as a fast one
/// (R30). The force then fades within a larger radius, because F/r, the slope of a force that turns
/// with the arm, must also stay within the reduced Kcap.
///
/// A constrained tether resists only the motion that the transform really makes (constrained()): a
/// translation along the axis of the larger component, or a rotation by whole steps of
/// kTurnStepRad. On the diagonal, where the axis changes, the force is zero; beside it, the force
/// is at most Kcap times the distance from the diagonal. When the step changes, the force starts
/// from its value for the previous step and grows by at most Kcap times the distance from there. So
/// the force never jumps, and it is zero before anything has moved.
///
/// A printed tether (printed()) is the paper's text literally, F = l(|V|) against V, without Kcap,
/// fading and damping (docs/design/errata.md#e14 to #e16). For a translation V is equation 10: the
/// sum over the anchors of the vectors from the anchor to the pen. For a rotation, |V| is the sum
/// of the chords 2 r_i |sin(th/2)|, and for a scaling the sum of r_i |s - 1|.
class Tether {
 public:
  /// Makes a tether without anchors, which has no force.
  Tether() noexcept = default;
  static Tether translation(Point grab, int anchors) noexcept;
  /// If `gesture` differs from the gesture of the last rotation, th starts again at 0.
  static Tether rotation(Point centre, Point grab, double sum_of_radii_mm,
                         std::uint32_t gesture) noexcept;
  static Tether scale(Point centre, Point grab, double sum_of_radii_mm) noexcept;

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  [[nodiscard]] Slopes slopes() const noexcept;

  /// Returns this tether for a constrained transform. A scale does not change.
  [[nodiscard]] Tether constrained() const noexcept;
  /// Returns this tether for a scale whose factor is never less than `factor`.
  [[nodiscard]] Tether with_min_scale(double factor) const noexcept;
  /// Returns this tether with this force law instead of kTransformLaw, for example with a lower
  /// ForceLaw::gain for devices that cannot hold 1 N for long.
  [[nodiscard]] Tether with_law(const ForceLaw& law) const noexcept;
  /// Returns this tether in the form kPaper. `middle` is the mean of the anchors.
  [[nodiscard]] Tether printed(Point middle) const noexcept;

 private:
  enum class Kind : std::uint8_t { kNone, kTranslation, kRotation, kScale };

  [[nodiscard]] Vec translation_pull(Point pen) const noexcept;
  [[nodiscard]] Vec rotation_pull(Point pen, ForceMemory& memory) const noexcept;
  [[nodiscard]] Vec scale_pull(Point pen) const noexcept;
  [[nodiscard]] Vec printed_pull(Point pen, ForceMemory& memory) const noexcept;
  double follow_turn(Vec arm, ForceMemory& memory) const noexcept;
  [[nodiscard]] double size_n(double sum_mm, double way_mm) const noexcept;
  [[nodiscard]] double turn_size_n(double turn_rad, double radius_mm) const noexcept;
  [[nodiscard]] double stepped_size_n(double turn_rad, double radius_mm) const noexcept;

  ForceLaw law_ = kTransformLaw;
  Kind kind_ = Kind::kNone;
  Point centre_{};
  Point grab_{};
  Point middle_{};  // of the anchors; used in the form kPaper only
  double sum_ = 0.0;
  double min_scale_ = 0.0;
  std::uint32_t gesture_ = 0;
  bool constrained_ = false;
};

/// The step of a constrained rotation: 15 degrees.
inline constexpr double kTurnStepRad = 15.0 * 3.14159265358979323846 / 180.0;

/// Returns the angle from `first_arm` to `arm`, rad, unwrapped so that full turns add up: the
/// equivalent angle that is nearest to `last_rad`. If an arm has no length, returns `last_rad`.
/// The transform tool and its force both use this function.
double unwrapped_turn_rad(Vec first_arm, Vec arm, double last_rad) noexcept;

/// Returns the scale factor, 0.05..20, if the pen grabbed at `first_arm` from the centre and is now
/// at `arm`. Returns 1 if `first_arm` has no length.
double scale_factor(Vec first_arm, Vec arm) noexcept;

}  // namespace felt
