#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// Converts between the stroke parameter u (segment index + t) and the arc length s along a stroke.
/// Brushes use it, because their influence falls off with the arc length
/// (docs/design/editing.md#brush), and create it once per gesture. It keeps a reference to the
/// stroke, which must outlive it.
///
/// On a closed stroke, lengths beyond the ends wrap around (modulo the whole length), so that a
/// range may cross the seam. On an open stroke, such lengths are clamped to the ends. Below, n is
/// the number of segments.
///
/// Lengths are accurate to `accuracy_mm` for each segment. Construction takes linear time in the
/// number of segments. A query takes a binary search among the segments and one call of
/// arc_length() or parameter_at_length() (cubic.h).
class ArcMap {
 public:
  explicit ArcMap(const Stroke& stroke, double accuracy_mm = 1e-6);

  /// Returns the whole length in mm, which is greater than 0.
  [[nodiscard]] double length_mm() const noexcept { return starts_.back(); }
  /// Returns the arc length in mm up to the start of `segment`; segment = n gives the whole length.
  [[nodiscard]] double start_of(int segment) const noexcept {
    return starts_[static_cast<std::size_t>(segment)];
  }
  /// Returns the arc length from the start to u in [0, n], in mm.
  [[nodiscard]] double length_at(double u) const noexcept;
  /// Returns the u in [0, n] at which the arc from the start has this length.
  [[nodiscard]] double u_at(double length_mm) const noexcept;
  /// Returns the signed distance along the stroke from s0 to s in mm. On a closed stroke, measures
  /// in the shorter direction.
  [[nodiscard]] double way(double s0_mm, double s_mm) const noexcept;

 private:
  const Stroke& stroke_;
  double accuracy_mm_;
  std::vector<double> starts_;  // arc length at the start of each segment, and at the end
};

}  // namespace felt
