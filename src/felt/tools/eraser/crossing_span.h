#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "felt/tools/eraser/parameter_set.h"
#include "felt/tools/scene.h"

namespace felt {

/// Where a stroke is crossed, touched or overlapped by strokes that may be edited, itself included:
/// the places at which erasing up to the next crossing stops. A stroke whose end lies within
/// kTeeMm of this one counts as crossing it (hands rarely meet a line exactly).
///
/// Found segment by segment, as they are asked for, with a budget: a sample of the pen must not
/// wait for a stroke that is crossed a thousand times. What is found is kept, so that the answers
/// are those of the time when they were first asked for.
class StrokeCrossings {
 public:
  static constexpr double kTeeMm = 0.5;
  /// Limit on pairs of pieces for one pair of segments (intersect.h): copies a hair apart would
  /// take all that there is.
  static constexpr int kMostPairs = 1024;

  StrokeCrossings(StrokeId id, StrokePtr stroke) : id_(id), stroke_(std::move(stroke)) {}

  /// The places u on a segment, ascending, or null when the budget does not suffice for now; it is
  /// lowered by the work done, about a unit for 0.2 us.
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
  /// The segment that is being looked at.
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

/// Finds the part of a stroke between the crossings next to a part of it that was touched. Ends of
/// an open stroke end it too; a closed stroke with a single crossing, and one without, goes whole.
class SpanSearch {
 public:
  explicit SpanSearch(ParameterSet::Interval touched) : from_(touched.from), to_(touched.to) {}

  /// Goes on; true when the span is known. Each call uses up some of the budget.
  bool advance(StrokeCrossings& crossings, const Scene& scene, int& budget);
  /// Its start and end, once known. On a closed stroke to() <= from() means: through the seam.
  [[nodiscard]] double from() const noexcept { return from_; }
  [[nodiscard]] double to() const noexcept { return to_; }
  /// True when all of the stroke goes.
  [[nodiscard]] bool is_whole() const noexcept { return whole_; }

 private:
  bool go_left(StrokeCrossings& crossings, const Scene& scene, int& budget);
  bool go_right(StrokeCrossings& crossings, const Scene& scene, int& budget);

  double from_, to_;
  int left_ = 0, right_ = 0;  // segments looked at so far
  bool left_done_ = false, right_done_ = false;
  bool whole_ = false;
};

}  // namespace felt
