#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "felt/stroke/stroke.h"
#include "felt/tools/eraser/parameter_set.h"

namespace felt {

/// The parts of a stroke that remain after parts were erased (R39, R40): each part that is not
/// erased becomes a separate open stroke. Segments are cut by de Casteljau's algorithm, and each
/// cut gets a breakpoint with the width of the stroke at that point. A closed stroke is opened; its
/// seam is not a cut.
///
/// Pieces that are too small are dropped (Crumbs). A cut less than 0.05 mm (I5) from a joint moves
/// to the joint, so that no segment of the piece is too short. In that case slightly more is
/// erased. Holes of less than a micrometre are ignored.
class RemainingPieces {
 public:
  static constexpr double kMinPieceMm = 0.25;
  /// Says which pieces are too small to keep. W is the width in the middle of a piece.
  enum class Crumbs {
    kOfLine,  ///< shorter than max(0.25 mm, W/2)
    kOfInk,   ///< shorter than 0.05 mm (I5), or than 0.25 mm including the round ends (length + W)
  };
  static constexpr double kMinHoleMm = 1e-3;

  explicit RemainingPieces(std::shared_ptr<const Stroke> stroke, Crumbs crumbs = Crumbs::kOfLine)
      : whole_stroke_(stroke), stroke_(std::move(stroke)), crumbs_(crumbs) {}

  /// Cuts the stroke again; pieces that have not changed stay the same Stroke objects. If `widths`
  /// is not empty, it replaces the width profile of the stroke.
  void cut(const ParameterSet& erased, std::vector<WidthKnot> widths = {});
  /// Returns true if nothing is cut off and the widths are unchanged. pieces() is then empty.
  [[nodiscard]] bool is_whole() const noexcept { return whole_; }
  /// Returns the pieces in the order of u.
  [[nodiscard]] std::vector<std::shared_ptr<const Stroke>> pieces() const;

 private:
  /// A piece. It crosses the seam if `to` > n.
  struct Piece {
    double from = 0.0;
    double to = 0.0;
    std::shared_ptr<const Stroke> stroke;  // null: dropped
  };

  /// Returns the parts between the holes, or nullopt if the set has no holes.
  [[nodiscard]] std::optional<std::vector<ParameterSet::Interval>> gaps(
      const ParameterSet& erased) const;
  [[nodiscard]] std::shared_ptr<const Stroke> make(ParameterSet::Interval part) const;

  std::shared_ptr<const Stroke> whole_stroke_;
  std::shared_ptr<const Stroke> stroke_;  // with the widths of the last cut
  Crumbs crumbs_;
  std::vector<Piece> pieces_;
  bool whole_ = true;
};

}  // namespace felt
