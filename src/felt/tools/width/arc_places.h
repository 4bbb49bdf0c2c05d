#pragma once

#include <vector>

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Places evenly spaced along a stroke, numbered 0 to count() from its start to its end; the u of
/// each is worked out when it is first asked for. The same stroke always has the same places, so
/// that edits one after the other do not pile up breakpoints. On a closed stroke place count() is
/// place 0, at the other side of the seam.
class ArcPlaces {
 public:
  /// Both must outlive this. The spacing is rounded so that a whole number of cells fits.
  ArcPlaces(const Stroke& stroke, const ArcMap& map, double spacing_mm);

  [[nodiscard]] long count() const noexcept { return count_; }
  [[nodiscard]] double spacing_mm() const noexcept { return spacing_mm_; }
  [[nodiscard]] double length_at(long k) const noexcept {
    return spacing_mm_ * static_cast<double>(k);
  }
  /// Stroke parameter of place k, 0 <= k <= count().
  [[nodiscard]] double u(long k) const;
  /// The cell [k, k + 1] that holds a length on the stroke.
  [[nodiscard]] long cell(double length_mm) const noexcept;
  /// Where to keep something for place k, any whole number: what is the same place of a closed
  /// stroke has the same slot, beyond the ends of an open one the ends are meant.
  [[nodiscard]] std::size_t slot(long k) const noexcept;
  [[nodiscard]] std::size_t slot_count() const noexcept { return us_.size(); }

 private:
  const ArcMap& map_;
  bool closed_;
  int segments_;
  long count_;
  double spacing_mm_;
  mutable std::vector<double> us_;  // NaN: not asked for yet
};

}  // namespace felt
