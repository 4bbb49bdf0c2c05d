#pragma once

#include <vector>

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Evenly spaced sample positions ("places") along a stroke, numbered 0 to count() from the start
/// of the stroke to its end. The parameter u of a place is computed on first use. The same stroke
/// always has the same places, so that successive edits do not accumulate breakpoints. On a closed
/// stroke place count() is the same point as place 0, reached from the other side of the seam.
class ArcPlaces {
 public:
  /// `stroke` and `map` must outlive this object. The spacing is rounded so that a whole number of
  /// cells fits.
  ArcPlaces(const Stroke& stroke, const ArcMap& map, double spacing_mm);

  [[nodiscard]] long count() const noexcept { return count_; }
  [[nodiscard]] double spacing_mm() const noexcept { return spacing_mm_; }
  [[nodiscard]] double length_at(long k) const noexcept {
    return spacing_mm_ * static_cast<double>(k);
  }
  /// Returns the stroke parameter of place k, 0 <= k <= count().
  [[nodiscard]] double u(long k) const;
  /// Returns the k of the cell [k, k + 1] that contains an arc length.
  [[nodiscard]] long cell(double length_mm) const noexcept;
  /// Returns the array index for data of place k. Any integer k is allowed: k is wrapped around on
  /// a closed stroke and clamped to the ends on an open one.
  [[nodiscard]] std::size_t slot(long k) const noexcept;
  [[nodiscard]] std::size_t slot_count() const noexcept { return us_.size(); }

 private:
  const ArcMap& map_;
  bool closed_;
  int segments_;
  long count_;
  double spacing_mm_;
  mutable std::vector<double> us_;  // NaN: not computed yet
};

}  // namespace felt
