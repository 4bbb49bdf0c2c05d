#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// Stroke parameter u (segment index + t) against arc length s along a stroke, both ways: what
/// brushes measure their reach in (architecture section 10: the influence falls off along the arc
/// length). Made once a gesture; refers to the stroke, which must outlive it.
///
/// On a closed stroke s and u go round: lengths beyond the ends are taken modulo the whole length,
/// so that a reach across the seam needs no thought. On an open one they are held at the ends.
///
/// Accuracy: lengths within `accuracy_mm` a segment. Building is linear in the segments; a question
/// costs a search among them and one of cubic.h's lengths.
class ArcMap {
 public:
  explicit ArcMap(const Stroke& stroke, double accuracy_mm = 1e-6);

  /// Whole length, mm; more than 0.
  [[nodiscard]] double length_mm() const noexcept { return starts_.back(); }
  /// Arc length from the start of the stroke to the start of segment i; i = n is the whole length.
  [[nodiscard]] double start_of(int segment) const noexcept {
    return starts_[static_cast<std::size_t>(segment)];
  }
  /// Arc length from the start to u in [0, n].
  [[nodiscard]] double length_at(double u) const noexcept;
  /// The u in [0, n] at which the arc from the start is that long.
  [[nodiscard]] double u_at(double length_mm) const noexcept;
  /// Way along the stroke from s0 to s, signed: the shorter of the two on a closed stroke.
  [[nodiscard]] double way(double s0_mm, double s_mm) const noexcept;

 private:
  const Stroke& stroke_;
  double accuracy_mm_;
  std::vector<double> starts_;  // n + 1
};

}  // namespace felt
