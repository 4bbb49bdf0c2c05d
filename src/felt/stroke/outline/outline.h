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

/// Maximum number of steps of one segment. Bounds the memory if a tolerance is extremely fine for
/// the size of the segment.
inline constexpr int kMaxFlattenSteps = 1 << 14;

/// Maximum number of steps of a stroke with many segments. The steps are divided evenly among the
/// segments, with at least one step for each; 2^24 dabs take 540 MB.
inline constexpr int kMaxStrokeSteps = 1 << 24;

/// Returns the number of equal steps of t, at least 1, into which a part of c with the length
/// `span` in t must be divided. The straight lines between the steps are then within the tolerance
/// of the curve at the same t. Uses the bound h^2 max|f''| / 8 (Wang, "The subdivision method for
/// finding the intersection between two Bezier curves", 1984), which also holds at cusps and zero
/// handles.
int flatten_steps(const Cubic& c, double span, double tolerance_mm) noexcept;

/// Replaces `out` by dabs along the stroke. If radius and centre are interpolated linearly between
/// dabs, they are within the tolerance of the drawn values (DrawnProfile) at the same parameter,
/// unless this needs more than the maximum number of steps; tones are within 0.02. Each end of a
/// segment and each width breakpoint gets a dab. The seam of a closed stroke appears at both ends.
void flatten(const Stroke& stroke, double tolerance_mm, std::vector<Dab>& out);

/// Replaces `out` by the dabs of the segments from `first` up to, but not including, `last`. They
/// are the same dabs as in the whole stroke. Requires 0 <= first < last <= segment_count().
void flatten(const Stroke& stroke, int first, int last, double tolerance_mm, std::vector<Dab>& out);
/// Does the same, and replaces `ends` by the index of the dab at the end of each of these segments.
void flatten(const Stroke& stroke, int first, int last, double tolerance_mm, std::vector<Dab>& out,
             std::vector<std::size_t>& ends);

struct Stretch;

/// Closed polygons that are filled together with the non-zero rule. The points of all contours are
/// in one vector, so that the buffer can be reused without allocating.
struct Outline {
  std::vector<Point> points{};
  std::vector<std::size_t> ends{};  ///< contour k is points [ends[k - 1], ends[k])

  [[nodiscard]] std::size_t contour_count() const noexcept { return ends.size(); }
  /// Returns contour k; its last point is connected to its first.
  [[nodiscard]] std::span<const Point> contour(std::size_t k) const noexcept {
    const std::size_t begin = k == 0 ? 0 : ends[k - 1];
    return std::span(points).subspan(begin, ends[k] - begin);
  }
  void clear() noexcept {
    points.clear();
    ends.clear();
  }
};

/// Traces the edge of variable-width strokes: the union of the dabs along a stroke as ONE outline
/// with the non-zero rule, so that a transparent colour covers every point once.
///
/// An open stroke gives one contour: left side, round cap, right side, round cap. A closed stroke
/// gives two contours with opposite orientation, so that the ring is inked but not its hole.
/// Corners are round. Bends tighter than the half width, cusps, dots, zero handles and widths that
/// change faster than the arc length are all covered without gaps (envelope.h has the proof).
///
/// The object keeps its buffers, so it does not allocate after warm-up. Use it from one thread at a
/// time.
class StrokeOutliner {
 public:
  StrokeOutliner();
  ~StrokeOutliner();
  StrokeOutliner(StrokeOutliner&&) noexcept;
  StrokeOutliner& operator=(StrokeOutliner&&) noexcept;

  /// Returns the outline of a stroke. Every point of the outline is within the tolerance of the
  /// true edge or inside the ink. Requires tolerance_mm > 0. The result is valid until the next
  /// call.
  const Outline& trace(const Stroke& stroke, double tolerance_mm);

  /// Returns the outline of a row of dabs joined by tapered strips. The outline is exact, except
  /// for arcs and gentle bends, which are within the tolerance. The outline of an empty row has no
  /// contour.
  const Outline& trace(std::span<const Dab> dabs, bool closed, double tolerance_mm);

 private:
  void link(std::span<const Dab> dabs, bool closed);
  void trace_side(bool closed, int direction);
  void turn(const Dab& dab, const Stretch& from, const Stretch& to, int direction);
  void arc(const Dab& dab, Vec normal, double sweep);
  void close_contour();

  std::vector<Dab> flattened_;
  std::vector<Dab> dabs_;       // neighbours differ in centre or radius
  std::vector<Stretch> edges_;  // edge i leads from dab i to the next one
  double tolerance_mm_ = 0.0;
  Outline outline_;
};

/// Returns the outline of one stroke; for callers that do not reuse buffers.
Outline outline_of(const Stroke& stroke, double tolerance_mm);

}  // namespace felt
