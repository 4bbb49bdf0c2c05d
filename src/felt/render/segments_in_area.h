#pragma once

#include <span>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// Returns bounds of the ink of segment i: those of its control points, expanded on each side by
/// half of the stroke's largest width on the segment. Requires 0 <= i < segment_count(). Takes
/// logarithmic time in the number of width breakpoints.
Rect segment_area(const Stroke& stroke, int i) noexcept;

/// Neighbouring segments of a stroke: [first, last).
struct SegmentRun {
  int first = 0;
  int last = 0;
};

/// Finds the segments of a stroke that may ink an area, so that the others need not be traced.
/// Reuses its buffer.
class SegmentsInArea {
 public:
  /// `areas` are the segment_area() of all segments of a stroke.
  void find(std::span<const Rect> areas, const Rect& area);
  /// Returns the runs in the order of the stroke.
  [[nodiscard]] const std::vector<SegmentRun>& runs() const noexcept { return runs_; }
  /// Returns true if the runs cover all segments of the stroke.
  [[nodiscard]] bool is_whole(const Stroke& stroke) const noexcept {
    return runs_.size() == 1 && runs_[0].first == 0 && runs_[0].last == stroke.segment_count();
  }

 private:
  std::vector<SegmentRun> runs_;
};

}  // namespace felt
