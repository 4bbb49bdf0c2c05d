#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "felt/stroke/stroke.h"
#include "felt/tools/eraser/parameter_set.h"

namespace felt {

/// What is left of a stroke of which places are erased (specification 5f; R39, R40): each gap in
/// the set becomes an open stroke of its own, cut by de Casteljau, with a width breakpoint that
/// keeps the width at each cut. A closed stroke is opened; its seam is no cut.
///
/// Pieces shorter than max(0.25 mm, W/2), W being the width in their middle, are dropped. A cut
/// less than I5 (0.05 mm) from a joint moves to the joint, so that the piece gets no sliver of a
/// segment: that much more goes. Holes of less than a micrometre are no holes.
class Remains {
 public:
  static constexpr double kLeastPieceMm = 0.25;
  static constexpr double kLeastHoleMm = 1e-3;

  explicit Remains(std::shared_ptr<const Stroke> stroke) : stroke_(std::move(stroke)) {}

  /// Cuts anew; pieces that stay as they were are the same objects as before.
  void cut(const ParameterSet& erased);
  /// True when nothing is cut off: there are no pieces then.
  [[nodiscard]] bool is_whole() const noexcept { return whole_; }
  /// In the order of u.
  [[nodiscard]] std::vector<std::shared_ptr<const Stroke>> pieces() const;

 private:
  /// A piece from u0 to u1; through the seam when u1 > n.
  struct Piece {
    double from = 0.0;
    double to = 0.0;
    std::shared_ptr<const Stroke> stroke;  // null: dropped
  };

  /// Between the holes; nothing when there is no hole.
  [[nodiscard]] std::optional<std::vector<ParameterSet::Interval>> gaps(
      const ParameterSet& erased) const;
  [[nodiscard]] std::shared_ptr<const Stroke> make(ParameterSet::Interval part) const;

  std::shared_ptr<const Stroke> stroke_;
  std::vector<Piece> pieces_;
  bool whole_ = true;
};

}  // namespace felt
