#pragma once

#include <cmath>

#include "felt/geometry/point.h"

namespace felt {

/// How the edge of the ink lies beside the centre line, where that runs along `tangent` while its
/// radius grows by `slope` per length. The edge of a row of dabs touches each dab where its
/// normal n satisfies
///   n . tangent = -slope
/// so it leans back where the stroke widens. A slope of 1 or more means that later dabs swallow
/// earlier ones; then there is no edge and n lies on the axis.
///
/// All that walks along an outline sees the left side, on the side of perp(tangent). The right
/// side is the left side of the same stroke walked backwards (`backwards`).
struct EnvelopeFrame {
  Vec tangent;          ///< unit vector
  double slope = 0.0;   ///< dr/ds, limited to [-1, 1]
  double height = 1.0;  ///< sqrt(1 - slope^2)

  /// The frame of a line along unit `tangent` on which the radius grows by dr over ds.
  static EnvelopeFrame of(Vec tangent, double dr, double ds) noexcept;
  /// The same place, walked the other way.
  [[nodiscard]] constexpr EnvelopeFrame backwards() const noexcept {
    return {-tangent, -slope, height};
  }
  /// Unit normal of the left edge.
  [[nodiscard]] constexpr Vec normal() const noexcept {
    return height * perp(tangent) - slope * tangent;
  }
  /// Angle from the tangent to the left normal, 0..pi.
  [[nodiscard]] double normal_angle() const noexcept { return std::atan2(height, -slope); }
};

/// How the left outline gets from one stretch to the next around the dab between them.
struct Turn {
  enum class Kind {
    kArc,       ///< outside of the bend: along the dab, by `sweep`
    kShortcut,  ///< inside, with room: straight across, the rest is inked by both stretches
    kPivot,     ///< inside, tighter than the radius: by way of the dab's centre
  };
  Kind kind = Kind::kArc;
  double sweep = 0.0;  ///< radians, at most 0; turns against perp()
};

/// A stretch of the stroke as a turn at its end sees it.
struct Stretch {
  EnvelopeFrame frame;
  double length_mm = 0.0;
};

/// True when, on the inside of the bend at a dab of this radius, the left half strips of both
/// stretches cover each other's corner.
bool has_room(const Stretch& from, const Stretch& to, double radius_mm) noexcept;

/// The turn on the dab of this radius between two stretches.
///
/// Why this inks the union of all dabs and nothing else: cut the outline at every dab centre.
/// What is left is a sum of pieces of positive orientation, namely half a tapered strip per side
/// and stretch, and a sector of the dab per outside turn. With the non-zero rule a sum of
/// positive pieces fills exactly their union. A point that a dab covers is covered deepest either
/// within a stretch, then on one of its normals, thus in the strip; or at a dab, then between the
/// normals of an outside turn, thus in the sector. A shortcut takes away one layer of a triangle
/// that both strips cover.
///
/// `tie` is +1 when walking forwards and -1 backwards, so that both sides agree which way a
/// stroke turns that reverses exactly.
Turn turn_between(const Stretch& from, const Stretch& to, double radius_mm, int tie) noexcept;

}  // namespace felt
