#pragma once

#include <vector>

#include "tests/support/fit_box_tree.h"

namespace fit_check {

/// A short part [t0, t1] of one segment, close to its chord a-b.
struct Piece {
  std::size_t segment = 0;
  double t0 = 0.0, t1 = 1.0;
  Point a, b;
  double sag = 0.0;  ///< no place of the part is farther than this from the chord
};

/// A fitted curve cut into so many pieces that each one is nearly straight and short against the
/// tolerance.
///
/// The nearest point cannot be missed: a piece lies within `sag` of its chord, hence every piece
/// whose chord distance less `sag` is not above the best distance so far is refined (golden
/// section), and no other piece can be nearer. A result is an upper bound that exceeds the true
/// distance by at most 4 `sag` (in a piece that holds a cusp), that is by 0.002 tolerances.
class CurvePieces {
 public:
  CurvePieces(const std::vector<Segment>& segments, double tolerance);

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// Distance from p to the whole curve. `hint` is a piece index to begin with; it becomes the
  /// nearest piece.
  [[nodiscard]] double distance(Point p, std::size_t& hint) const;

 private:
  [[nodiscard]] double distance_to_piece(const Piece& piece, Point p, double bound) const;

  const std::vector<Segment>* segments_;
  std::vector<Piece> pieces_;
  BoxTree tree_;
};

}  // namespace fit_check
