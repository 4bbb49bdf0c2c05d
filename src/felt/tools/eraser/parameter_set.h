#pragma once

#include <vector>

namespace felt {

/// A set of places on a stroke: intervals of u, ascending and apart. Whatever the order in which
/// they were added, the same set: what an eraser has swept does not depend on its steps (R39).
class ParameterSet {
 public:
  struct Interval {
    double from = 0.0;
    double to = 0.0;

    friend constexpr bool operator==(Interval, Interval) noexcept = default;
  };

  /// Intervals this near to each other are one: what rounding left between two steps.
  static constexpr double kGap = 1e-12;

  /// Unites with an interval; nothing when from >= to. True when the set grew. Logarithmic, and
  /// linear in the intervals after it.
  bool add(Interval interval);
  /// True when all of it is in the set.
  [[nodiscard]] bool contains(Interval interval) const noexcept;
  [[nodiscard]] const std::vector<Interval>& intervals() const noexcept { return intervals_; }
  [[nodiscard]] bool empty() const noexcept { return intervals_.empty(); }

  friend bool operator==(const ParameterSet&, const ParameterSet&) = default;

 private:
  std::vector<Interval> intervals_;
};

}  // namespace felt
