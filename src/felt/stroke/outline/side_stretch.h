#pragma once

#include <span>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/stroke/outline/envelope.h"
#include "felt/stroke/outline/outline.h"

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

/// One curve or line of the left edge, and what a turn at its ends needs to know.
struct SideStretch {
  Dab from{}, to{};
  EnvelopeFrame begin{}, end{};
  /// Of the chord of the centre line next to `from`, and next to `to`.
  double begin_length_mm = 0.0, end_length_mm = 0.0;
  Point start{}, finish{};     ///< of the edge
  bool curved = false;         ///< false: a straight line from `start` to `finish`
  Point handle0{}, handle1{};  ///< of the cubic that is the edge, when curved
  /// Where the bend is tighter than the radius, the edge stays nearer to the centre line than that:
  /// at the centre of the bend, since what is farther along the normal belongs to the ink
  /// elsewhere.
  bool starts_inside = false, finishes_inside = false;
};

/// Appends the left edge of pieces that follow each other, from the first to the last: as few
/// cubics as stay within the tolerance of the true edge, across pieces too where it is smooth, and
/// straight lines where it is not.
void append_left_edge(std::span<const InkPiece> pieces, double tolerance_mm,
                      std::vector<SideStretch>& out);

}  // namespace felt
