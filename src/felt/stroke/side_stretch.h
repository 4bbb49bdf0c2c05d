#pragma once

#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/stroke/envelope.h"
#include "felt/stroke/flatten.h"

namespace felt {

/// A piece of a stroke between neighbouring joints and width breakpoints: the radius is linear in
/// the parameter of the centre line.
struct InkPiece {
  Cubic center;
  double radius0_mm = 0.0;
  double radius1_mm = 0.0;
  /// Unit direction to assume where the radius changes on the spot. Any will do, but both sides
  /// must take the same.
  Vec heading;

  [[nodiscard]] double radius(double t) const noexcept {
    return radius0_mm + t * (radius1_mm - radius0_mm);
  }
};

/// The same piece walked from its end.
constexpr InkPiece reversed(const InkPiece& piece) noexcept {
  return {reversed(piece.center), piece.radius1_mm, piece.radius0_mm, -piece.heading};
}

/// One curve or line of the left edge and what a turn at its ends needs to know.
struct SideStretch {
  Dab from, to;
  EnvelopeFrame begin, end;
  double length_mm = 0.0;  ///< of the chord of the centre line
  bool curved = false;     ///< false: a straight line from `from` to `to`
  Point handle0, handle1;  ///< of the cubic that is the edge, when curved
};

/// Appends the left edge of a piece, from its start to its end: cubics within the tolerance of
/// the true edge where there is one, else the straight strips of the flattened centre line.
void append_left_edge(const InkPiece& piece, double tolerance_mm, std::vector<SideStretch>& out);

}  // namespace felt
