#pragma once

#include <vector>

#include "tests/support/fit_box_tree.h"

namespace fit_check {

/// A short part [t0, t1] of one segment that is close to its chord from a to b.
struct Piece {
  std::size_t segment = 0;
  double t0 = 0.0, t1 = 1.0;
  Point a, b;
  double sag = 0.0;  ///< largest distance from the part to the chord
};

/// A fitted curve, cut into pieces that are nearly straight and much shorter than the tolerance.
///
/// The search cannot miss the nearest piece: a piece lies within `sag` of its chord. If the
/// distance to the chord minus `sag` is above the best distance so far, the piece cannot be nearer
/// and is skipped; all other pieces are refined by golden section search. The result is never below
/// the true distance, and exceeds it by at most 4 `sag` (in a piece with a cusp), that is 0.002
/// tolerances.
class CurvePieces {
 public:
  CurvePieces(const std::vector<Segment>& segments, double tolerance);

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// Returns the distance from p to the whole curve. `hint` is the index of the piece to try first;
  /// it is set to the index of the nearest piece.
  [[nodiscard]] double distance(Point p, std::size_t& hint) const;

 private:
  [[nodiscard]] double distance_to_piece(const Piece& piece, Point p, double bound) const;

  const std::vector<Segment>* segments_;
  std::vector<Piece> pieces_;
  BoxTree tree_;
};

}  // namespace fit_check
