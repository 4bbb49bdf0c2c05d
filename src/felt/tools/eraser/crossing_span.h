#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "felt/tools/eraser/parameter_set.h"
#include "felt/tools/scene.h"

namespace felt {

/// The points at which a stroke crosses, touches or overlaps editable strokes, including itself.
/// Erasing up to the next crossing stops at these points. If another stroke ends within kTeeMm of
/// this stroke, that counts as a crossing, because people rarely hit a line exactly.
///
/// The crossings are computed segment by segment on request, with a budget, so that a pen sample
/// does not wait for a stroke with a thousand crossings. Each result is cached at the first request
/// and does not change afterwards, even if other strokes change.
class StrokeCrossings {
 public:
  static constexpr double kTeeMm = 0.5;
  /// Maximum number of pairs of pieces that are compared for one pair of segments (intersect.h).
  /// Without this limit, two almost identical curves would use up any budget.
  static constexpr int kMaxPairs = 1024;

  StrokeCrossings(StrokeId id, StrokePtr stroke) : id_(id), stroke_(std::move(stroke)) {}

  /// Returns the crossings u on a segment, ascending. Returns null if the budget is exhausted; the
  /// caller can try again later. The budget is reduced by the work done, about one unit per 0.2 us.
  const std::vector<double>* on_segment(int segment, const Scene& scene, int& budget);
  [[nodiscard]] const Stroke& stroke() const noexcept { return *stroke_; }
  [[nodiscard]] StrokeId id() const noexcept { return id_; }
  [[nodiscard]] const StrokePtr& pointer() const noexcept { return stroke_; }

 private:
  struct Candidate {
    StrokeId stroke;
    int segment = 0;

    friend auto operator<=>(const Candidate&, const Candidate&) noexcept = default;
  };
  /// The segment in progress.
  struct Work {
    int segment = -1;
    std::vector<Candidate> candidates;
    std::size_t next = 0;
    std::vector<double> places;
  };

  void start(int segment, const Scene& scene);
  void meet(const Candidate& with, const Scene& scene, int& budget);
  void meet_itself();
  void meet_tips(const Candidate& with, const Stroke& other, const Cubic& mine);
  [[nodiscard]] bool is_at_shared_joint(const Candidate& with, double t, Point at) const;

  StrokeId id_;
  StrokePtr stroke_;
  std::map<int, std::vector<double>> found_;
  Work work_;
};

/// Finds the span to erase around a touched part of a stroke: it extends on both sides to the next
/// crossing or to the end of an open stroke. A closed stroke with at most one crossing is erased
/// whole.
class SpanSearch {
 public:
  explicit SpanSearch(ParameterSet::Interval touched) : from_(touched.from), to_(touched.to) {}

  /// Continues the search. Returns true if the search is complete. Each call uses up some of the
  /// budget.
  bool advance(StrokeCrossings& crossings, const Scene& scene, int& budget);
  /// Return the start and end of the span. Require that advance() has returned true. On a closed
  /// stroke, to() <= from() means that the span crosses the seam.
  [[nodiscard]] double from() const noexcept { return from_; }
  [[nodiscard]] double to() const noexcept { return to_; }
  /// Returns true if the span is the whole stroke. Requires that advance() has returned true.
  [[nodiscard]] bool is_whole() const noexcept { return whole_; }

 private:
  bool go_left(StrokeCrossings& crossings, const Scene& scene, int& budget);
  bool go_right(StrokeCrossings& crossings, const Scene& scene, int& budget);

  double from_, to_;
  int left_ = 0, right_ = 0;  // number of segments searched so far
  bool left_done_ = false, right_done_ = false;
  bool whole_ = false;
};

}  // namespace felt
