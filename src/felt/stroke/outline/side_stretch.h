#pragma once

#include <span>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/outline/envelope.h"
#include "felt/stroke/outline/outline.h"

namespace felt {

/// The part of a stroke from one joint or width breakpoint to the next. Its radius is the drawn one
/// (DrawnProfile), as a cubic in the parameter of the centre line.
struct InkPiece {
  Cubic center;
  double radius0_mm = 0.0;
  double radius1_mm = 0.0;
  /// Unit direction to use if the radius changes but the centre does not move. Any direction is
  /// valid, but both sides must use the same one.
  Vec heading;
  ProfileBend bend_mm{};

  [[nodiscard]] double radius(double t) const noexcept {
    return radius0_mm + t * (radius1_mm - radius0_mm) + bend_mm.at(t);
  }
  [[nodiscard]] double radius_derivative(double t) const noexcept {
    return radius1_mm - radius0_mm + bend_mm.derivative(t);
  }
};

/// Returns the same piece in the opposite direction.
constexpr InkPiece reversed(const InkPiece& piece) noexcept {
  return {reversed(piece.center), piece.radius1_mm, piece.radius0_mm, -piece.heading,
          piece.bend_mm.reversed()};
}

/// One curve or line of the left edge, with the data that a turn at its ends needs.
struct SideStretch {
  Dab from{}, to{};
  EnvelopeFrame begin{}, end{};
  /// Length of the first chord of the centre line, which begins at `from`, and of the last chord,
  /// which ends at `to`.
  double begin_length_mm = 0.0, end_length_mm = 0.0;
  Point start{}, finish{};     ///< ends of the edge
  bool curved = false;         ///< false for a straight line from `start` to `finish`
  Point handle0{}, handle1{};  ///< handles of the cubic, if curved
  /// True if the bend is tighter than the radius at the start or finish of the edge. Then that end
  /// of the edge is at the centre of the bend instead of a full radius away, because the area
  /// farther along the normal is inked by other parts of the stroke.
  bool starts_inside = false, finishes_inside = false;
};

/// Appends the left edge of consecutive pieces. If the edge is smooth, uses cubics that stay within
/// the tolerance of the true edge, as few as possible; one cubic may replace the edge of several
/// pieces. If the edge is not smooth, uses straight lines.
void append_left_edge(std::span<const InkPiece> pieces, double tolerance_mm,
                      std::vector<SideStretch>& out);

}  // namespace felt
