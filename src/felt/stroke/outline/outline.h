#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// A round dab of ink. A stroke inks the union of the dabs along its centre line.
struct Dab {
  Point center;
  double radius_mm = 0.0;
  double tone = 0.0;  ///< WidthKnot::tone

  friend constexpr bool operator==(const Dab&, const Dab&) noexcept = default;
};

/// Steps that one segment is divided into at most: bounds memory where a tolerance is absurdly
/// fine for the size of the segment.
inline constexpr int kMaxFlattenSteps = 1 << 14;

/// Steps that a stroke of many segments is divided into at most, shared evenly (but at least one
/// a segment): 2^24 dabs take 540 MB.
inline constexpr int kMaxStrokeSteps = 1 << 24;

/// Parameter steps, at least 1, so that straight lines between equal steps of t over a part of c
/// `span` of t long stay within the tolerance of the curve at the same t. By the bound
/// h^2 max|f''| / 8 (Wang, "The subdivision method for finding the intersection between two
/// Bezier curves", 1984), which holds through cusps and standing handles.
int flatten_steps(const Cubic& c, double span, double tolerance_mm) noexcept;

/// Replaces `out` by dabs along the stroke: radius and centre, taken linearly from each dab to
/// the next, stay within the tolerance of those of the stroke at the same parameter, unless that
/// would take more than the largest number of steps; tones are exact. Segment ends and width
/// breakpoints are hit exactly. A closed stroke's seam appears at both ends.
void flatten(const Stroke& stroke, double tolerance_mm, std::vector<Dab>& out);

/// Likewise along the segments from `first` up to, not including, `last`: the same dabs as those of
/// the whole stroke there. Requires 0 <= first < last <= segment_count().
void flatten(const Stroke& stroke, int first, int last, double tolerance_mm, std::vector<Dab>& out);

struct Stretch;

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
  StrokeOutliner();
  ~StrokeOutliner();
  StrokeOutliner(StrokeOutliner&&) noexcept;
  StrokeOutliner& operator=(StrokeOutliner&&) noexcept;

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
