#pragma once

#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// Around the ink of segment i: its control points, widened by half of the stroke's largest width
/// there. Requires 0 <= i < segment_count(). Logarithmic in the width's breakpoints.
Rect segment_area(const Stroke& stroke, int i) noexcept;

/// Neighbouring segments of a stroke, from `first` up to, not including, `last`.
struct SegmentRun {
  int first = 0;
  int last = 0;
};

/// Which segments of a stroke may ink an area: what lies elsewhere need not be traced. Keeps its
/// buffer.
class SegmentRuns {
 public:
  void find(const Stroke& stroke, const Rect& area);
  /// In the order of the stroke.
  [[nodiscard]] const std::vector<SegmentRun>& runs() const noexcept { return runs_; }
  /// It is all segments.
  [[nodiscard]] bool is_whole(const Stroke& stroke) const noexcept {
    return runs_.size() == 1 && runs_[0].first == 0 && runs_[0].last == stroke.segment_count();
  }

 private:
  std::vector<SegmentRun> runs_;
};

}  // namespace felt
