#include "felt/tools/pull/refit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/stroke/edit/subdivide.h"

namespace felt {
namespace {

constexpr double kLengthAccuracy = 1e-4;
/// Maximum number of pieces into which one badly shaped segment is divided.
constexpr int kMaxPieces = 6;
constexpr int kSamples = 24;
constexpr int kRounds = 4;

bool is_short(double handle_mm, double length_mm, JointKind joint, const SegmentShape& shape) {
  return joint == JointKind::kSmooth && handle_mm < shape.min_handle * length_mm;
}

bool winds(const Cubic& c, double length_mm, const SegmentShape& shape) {
  return std::max(distance(c.p[0], c.p[1]), distance(c.p[2], c.p[3])) >
             shape.max_handle * length_mm ||
         length_mm > shape.max_winding * distance(c.p[0], c.p[3]);
}

/// Finds the handle lengths of a curve with the ends and tangents of `c` that is as near to `c` as
/// possible, by a least-squares fit. Each round assigns new parameters to the samples of `c`.
class HandleFit {
 public:
  explicit HandleFit(const Cubic& c)
      : old_(c), start_(tangent(c, 0.0)), end_(tangent(c, 1.0)), now_(c) {}

  /// Returns a curve with handles of at least `min_mm`, or nullopt if such a curve is not near
  /// enough.
  std::optional<Cubic> fit(double min_mm) {
    now_ = with(std::max(min_mm, distance(old_.p[0], old_.p[1])),
                std::max(min_mm, distance(old_.p[2], old_.p[3])));
    for (int round = 0; round < kRounds; ++round) {
      const auto [a, b] = solve();
      now_ = with(std::max(a, min_mm), std::max(b, min_mm));
    }
    return farthest() <= kRefitToleranceMm ? std::optional(now_) : std::nullopt;
  }

 private:
  [[nodiscard]] Cubic with(double a, double b) const {
    return {{old_.p[0], old_.p[0] + a * start_, old_.p[3] - b * end_, old_.p[3]}};
  }
  [[nodiscard]] Point sample(int k) const { return evaluate(old_, (k + 1.0) / (kSamples + 1.0)); }

  /// Computes one round: matches samples of the old curve to their nearest points on the new curve.
  [[nodiscard]] std::pair<double, double> solve() const {
    double aa = 0.0, ab = 0.0, bb = 0.0, ra = 0.0, rb = 0.0;
    for (int k = 0; k < kSamples; ++k) {
      const double t = nearest(now_, sample(k)).t, s = 1.0 - t;
      const Vec da = 3.0 * t * s * s * start_, db = -3.0 * t * t * s * end_;
      const Vec rest = sample(k) - evaluate(with(0.0, 0.0), t);
      aa += dot(da, da);
      ab += dot(da, db);
      bb += dot(db, db);
      ra += dot(da, rest);
      rb += dot(db, rest);
    }
    const double det = aa * bb - ab * ab;
    if (!(det > 1e-12 * aa * bb)) return {0.0, 0.0};  // straight: any handle lengths fit
    return {(ra * bb - rb * ab) / det, (rb * aa - ra * ab) / det};
  }
  [[nodiscard]] double farthest() const {
    double far = 0.0;
    for (int k = 0; k < kSamples; ++k) {
      far = std::max(far, nearest(now_, sample(k)).distance_squared);
      const Point back = evaluate(now_, (k + 1.0) / (kSamples + 1.0));
      far = std::max(far, nearest(old_, back).distance_squared);
    }
    return std::sqrt(far);
  }

  Cubic old_;
  Vec start_, end_;
  Cubic now_;
};

/// Divides segment i until no piece winds or has a handle that is too long (SegmentShape). Returns
/// the number of pieces.
int unwind(Strand& strand, int i) {
  int pieces = 1;
  for (int k = 0; k < pieces && pieces < kMaxPieces;) {
    const Cubic c = strand.segment(i + k);
    if (winds(c, arc_length(c, kLengthAccuracy), {}) && strand.divide(i + k, 0.5)) {
      ++pieces;
    } else {
      ++k;
    }
  }
  return pieces;
}

/// Gives new handle lengths to a segment with a short handle, if the ink then stays in place.
void lengthen_handles(const Stroke& stroke, int i, StrokeData& data) {
  const Cubic c = stroke.segment(i);
  const double length = arc_length(c, kLengthAccuracy);
  const SegmentShape shape;
  if (!is_short(distance(c.p[0], c.p[1]), length, stroke.joint(i), shape) &&
      !is_short(distance(c.p[2], c.p[3]), length, stroke.joint(i + 1), shape)) {
    return;
  }
  // Uses a margin, because the length of the new curve differs slightly.
  const std::optional<Cubic> better = HandleFit(c).fit(1.1 * shape.min_handle * length);
  if (!better || winds(*better, length, shape)) return;
  const auto k = 3 * static_cast<std::size_t>(i);
  data.points[k + 1] = better->p[1];
  data.points[k + 2] = better->p[2];
}

/// Segments [first, first + count), wrapping around on a closed stroke.
struct Range {
  int first = 0, count = 0;
};

/// Returns the runs of changed segments, ascending by `first`. A run that crosses the seam is
/// therefore the last one.
std::vector<Range> changed_ranges(const Strand& strand) {
  const int n = strand.count();
  int start = 0;  // a start that does not divide a run
  while (strand.closed() && start < n && strand.is_changed(start)) ++start;
  if (start == n) return {{0, n}};
  std::vector<Range> ranges;
  for (int k = 0; k < n; ++k) {
    const int i = (start + k) % n;
    if (!strand.is_changed(i)) continue;
    if (k > 0 && strand.is_changed((i + n - 1) % n)) {
      ++ranges.back().count;
    } else {
      ranges.push_back({i, 1});
    }
  }
  std::sort(ranges.begin(), ranges.end(),
            [](const Range& a, const Range& b) { return a.first < b.first; });
  return ranges;
}

/// Returns the stroke with fewer segments in the range. Updates the range.
Stroke merged(const Stroke& stroke, Range& range) {
  const int n = stroke.segment_count();
  const int last = (range.first + range.count - 1) % n + 1;
  auto fewer = with_fewer_segments(stroke, range.first, last, kRefitToleranceMm);
  if (!fewer) return stroke;
  const int now = fewer->segment_count();
  // If the range crosses the seam, its start shifts by the number of removed segments.
  if (range.first + range.count > n) range.first = std::max(0, now - (n - range.first));
  range.count = std::clamp(range.count - (n - now), 1, now);
  return *std::move(fewer);
}

/// Returns the stroke with the segments of a range in good shape.
Stroke mended(const Stroke& stroke, Range range) {
  const Stroke fewer = merged(stroke, range);
  Strand strand(std::make_shared<const Stroke>(fewer));
  std::vector<int> is_mended;  // by segment of the strand
  const int n = fewer.segment_count();
  if (strand.count() != n) return fewer;  // a closed stroke of one segment was divided
  for (int k = 0, i = 0; i < n; ++i) {
    const bool inside = (i - range.first + n) % n < range.count;
    const int made = inside ? unwind(strand, k) : 1;
    is_mended.insert(is_mended.end(), static_cast<std::size_t>(made), inside ? 1 : 0);
    k += made;
  }
  const Result<Stroke> unwound = strand.stroke();
  if (!unwound) return fewer;
  StrokeData data = unwound->data();
  for (int i = 0; i < unwound->segment_count(); ++i) {
    if (is_mended[static_cast<std::size_t>(i)] != 0) lengthen_handles(*unwound, i, data);
  }
  Result<Stroke> done = Stroke::create(std::move(data));
  return done ? *std::move(done) : *unwound;
}

}  // namespace

bool is_well_shaped(const Stroke& stroke, int i, const SegmentShape& shape) noexcept {
  const Cubic c = stroke.segment(i);
  const double length = arc_length(c, kLengthAccuracy);
  return !winds(c, length, shape) &&
         !is_short(distance(c.p[0], c.p[1]), length, stroke.joint(i), shape) &&
         !is_short(distance(c.p[2], c.p[3]), length, stroke.joint(i + 1), shape);
}

Result<Stroke> with_good_shapes(const Strand& strand) {
  Result<Stroke> stroke = strand.stroke();
  if (!stroke) return stroke;
  const std::vector<Range> ranges = changed_ranges(strand);
  // Ranges are processed from the last to the first, so that the segment numbers of earlier ranges
  // stay valid. A range that crosses the seam also contains segments with low numbers, so it is
  // processed at the end, with its start corrected.
  const bool has_seam =
      !ranges.empty() && ranges.back().first + ranges.back().count > strand.count();
  for (std::size_t k = ranges.size() - (has_seam ? 1 : 0); k-- > 0;) {
    stroke = mended(*stroke, ranges[k]);
  }
  if (has_seam) {
    Range range = ranges.back();
    range.first += stroke->segment_count() - strand.count();
    stroke = mended(*stroke, range);
  }
  return stroke;
}

}  // namespace felt
