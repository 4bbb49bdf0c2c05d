#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "felt/stroke/stroke.h"
#include "felt/tools/eraser/parameter_set.h"

namespace felt {

/// What is left of a stroke when places of it are erased (R39, R40): each gap in
/// the set becomes an open stroke of its own, cut by de Casteljau, with a width breakpoint that
/// keeps the width at each cut. A closed stroke is opened; its seam is no cut.
///
/// Crumbs are dropped (Crumbs). A cut less than I5 (0.05 mm) from a joint moves to the joint, so
/// that the piece gets no sliver of a segment: that much more goes. Holes of less than a micrometre
/// are ignored.
class Remains {
 public:
  static constexpr double kLeastPieceMm = 0.25;
  /// Which pieces are too small to keep, W being the width in their middle.
  enum class Crumbs {
    kOfLine,  ///< shorter than max(0.25 mm, W/2)
    kOfInk,   ///< shorter than I5, or their ink is less than 0.25 mm long
  };
  static constexpr double kLeastHoleMm = 1e-3;

  explicit Remains(std::shared_ptr<const Stroke> stroke, Crumbs crumbs = Crumbs::kOfLine)
      : whole_stroke_(stroke), stroke_(std::move(stroke)), crumbs_(crumbs) {}

  /// Cuts again; pieces that stay as they were are the same objects as before. If `widths` is not
  /// empty, it replaces the width profile of the stroke.
  void cut(const ParameterSet& erased, std::vector<WidthKnot> widths = {});
  /// True if nothing is cut off and the widths are the old ones: there are no pieces then.
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

  std::shared_ptr<const Stroke> whole_stroke_;
  std::shared_ptr<const Stroke> stroke_;  // with the widths of the last cut
  Crumbs crumbs_;
  std::vector<Piece> pieces_;
  bool whole_ = true;
};

}  // namespace felt
