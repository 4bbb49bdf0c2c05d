#pragma once

#include <vector>

namespace felt {

/// A set of points of a stroke: disjoint intervals of u, ascending. The set does not depend on the
/// order in which intervals are added, so the result of erasing does not depend on the eraser's
/// steps (R39).
class ParameterSet {
 public:
  struct Interval {
    double from = 0.0;
    double to = 0.0;

    friend constexpr bool operator==(Interval, Interval) noexcept = default;
  };

  /// Maximum gap between intervals that are merged. Rounding may leave such gaps between two steps
  /// of the eraser.
  static constexpr double kGap = 1e-12;

  /// Adds an interval; ignores it if from >= to. Returns true if the set grew. Takes logarithmic
  /// time, plus time linear in the number of intervals after the new one.
  bool add(Interval interval);
  /// Returns true if the whole interval is in the set.
  [[nodiscard]] bool contains(Interval interval) const noexcept;
  [[nodiscard]] const std::vector<Interval>& intervals() const noexcept { return intervals_; }
  [[nodiscard]] bool empty() const noexcept { return intervals_.empty(); }

  friend bool operator==(const ParameterSet&, const ParameterSet&) = default;

 private:
  std::vector<Interval> intervals_;
};

}  // namespace felt
