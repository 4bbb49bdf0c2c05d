#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/stroke/fit/width_map.h"

namespace felt {

/// The path of a line in progress with its widths, for gestures. A sample is kept if it is farther
/// than kStepMm from the last kept one.
class DrawnPath {
 public:
  static constexpr double kStepMm = 0.2;
  /// A longer line is not a gesture; then the path is empty.
  static constexpr std::size_t kMaxPoints = 20'000;

  void begin() noexcept;
  void push(Point at, const InkWidth& ink);

  [[nodiscard]] std::span<const Point> points() const noexcept;
  /// Returns the median width and the median tone of the line. Requires that points() is not empty.
  [[nodiscard]] InkWidth usual_ink() const;

 private:
  std::vector<Point> points_;
  std::vector<InkWidth> inks_;
};

}  // namespace felt
