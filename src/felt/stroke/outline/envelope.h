#pragma once

#include <cmath>

#include "felt/geometry/point.h"

namespace felt {

/// The direction of the edge of the ink at a point of the centre line. There the centre line runs
/// along `tangent`, and the radius of the ink grows by `slope` per unit of length. The edge of a
/// row of dabs touches each dab at the point in the direction n from its centre, where the unit
/// normal n satisfies
///   n . tangent = -slope.
/// So the normal tilts backwards if the stroke widens. If the slope is 1 or more, later dabs cover
/// earlier ones completely; then there is no edge, and n is parallel to the tangent.
///
/// This struct describes the left side, which is the side of perp(tangent). The right side is the
/// left side of the same stroke in the opposite direction (`backwards`).
struct EnvelopeFrame {
  Vec tangent;          ///< unit vector
  double slope = 0.0;   ///< dr/ds, limited to [-1, 1]
  double height = 1.0;  ///< sqrt(1 - slope^2)

  /// Returns the frame of a line along the unit vector `tangent`, whose radius grows by dr over ds.
  static EnvelopeFrame of(Vec tangent, double dr, double ds) noexcept;
  /// Returns the frame of the same point in the opposite direction.
  [[nodiscard]] constexpr EnvelopeFrame backwards() const noexcept {
    return {-tangent, -slope, height};
  }
  /// Returns the unit normal of the left edge.
  [[nodiscard]] constexpr Vec normal() const noexcept {
    return height * perp(tangent) - slope * tangent;
  }
  /// Returns the angle from the tangent to the left normal, 0..pi.
  [[nodiscard]] double normal_angle() const noexcept { return std::atan2(height, -slope); }
};

/// How the left outline continues from one stretch to the next at the dab between them.
struct Turn {
  enum class Kind {
    kArc,       ///< outside of the bend: along the edge of the dab, by `sweep`
    kShortcut,  ///< inside, if has_room(): a straight line; both stretches ink the corner
    kPivot,     ///< inside, if the bend is tighter than the radius: through the dab's centre
  };
  Kind kind = Kind::kArc;
  double sweep = 0.0;  ///< radians, at most 0: a rotation opposite to that of perp()
};

/// A stretch of the stroke, with only the data that are needed for a turn at its end.
struct Stretch {
  EnvelopeFrame frame;
  double length_mm = 0.0;
};

/// Returns true if, on the inside of the bend between two stretches, the left half strip of each
/// stretch covers the corner of the other's. The dab between the stretches has this radius.
bool has_room(const Stretch& from, const Stretch& to, double radius_mm) noexcept;

/// Returns the turn between two stretches on a dab of this radius.
///
/// Proof that the outline inks the union of all dabs and nothing else: cut the outline at every dab
/// centre. It becomes a sum of pieces with positive orientation: half a tapered strip for each side
/// and stretch, and a sector of the dab for each outside turn. With the non-zero rule, a sum of
/// positive pieces fills exactly their union. Take a point covered by dabs, and the dab that covers
/// it deepest. If that dab is within a stretch, the point is on one of the dab's normals, so the
/// strip contains the point. If the dab is between two stretches, the point is between the normals
/// of an outside turn, so the sector contains the point. A shortcut removes one layer of a triangle
/// that both strips cover.
///
/// `tie` is +1 for the forward direction and -1 for backwards. If the stroke reverses its direction
/// exactly, `tie` decides whether it turns left or right, so that both sides agree.
Turn turn_between(const Stretch& from, const Stretch& to, double radius_mm, int tie) noexcept;

}  // namespace felt
