#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/stroke/outline/envelope.h"
#include "felt/stroke/outline/flatten.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Closed polygons that are filled together by the non-zero rule. Points of all contours lie one
/// after another, so that a buffer is reused without allocating.
struct Outline {
  std::vector<Point> points{};
  std::vector<std::size_t> ends{};  ///< contour k is points [ends[k - 1], ends[k])

  [[nodiscard]] std::size_t contour_count() const noexcept { return ends.size(); }
  /// Contour k; its last point joins its first.
  [[nodiscard]] std::span<const Point> contour(std::size_t k) const noexcept {
    const std::size_t begin = k == 0 ? 0 : ends[k - 1];
    return std::span(points).subspan(begin, ends[k] - begin);
  }
  void clear() noexcept {
    points.clear();
    ends.clear();
  }
};

/// Traces the edge of variable-width strokes: what the union of the dabs along a stroke looks
/// like, as ONE non-zero outline, so that a transparent colour covers every place once.
///
/// An open stroke gives one contour: left side, round cap, right side, round cap. A closed one
/// gives two, wound against each other so that the ring is inked and its hole is not. Corners are
/// round. Bends tighter than the half width, cusps, dots, standing handles and widths that change
/// faster than the stroke moves on are all covered without gap (envelope.h says why).
///
/// The object keeps its buffers: no allocation per stroke after warm-up. One thread at a time.
class StrokeOutliner {
 public:
  /// The outline of a stroke. Every point of it lies within the tolerance of the true edge or
  /// inside the ink. Requires tolerance_mm > 0. The result is valid until the next call.
  const Outline& trace(const Stroke& stroke, double tolerance_mm);

  /// The outline of a row of dabs joined by tapered strips, exact but for arcs and gentle bends,
  /// which are within the tolerance. An empty row has no contour.
  const Outline& trace(std::span<const Dab> dabs, bool closed, double tolerance_mm);

 private:
  void link(std::span<const Dab> dabs, bool closed);
  void trace_side(bool closed, int direction);
  void turn(const Dab& dab, const Stretch& from, const Stretch& to, int direction);
  void arc(const Dab& dab, Vec normal, double sweep);
  void close_contour();

  std::vector<Dab> flattened_;
  std::vector<Dab> dabs_;       // neighbours differ in place or radius
  std::vector<Stretch> edges_;  // from dab i to the next one
  double tolerance_mm_ = 0.0;
  Outline outline_;
};

/// The outline of one stroke, for callers that do not care about buffers.
Outline outline_of(const Stroke& stroke, double tolerance_mm);

}  // namespace felt
