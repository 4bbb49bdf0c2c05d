#pragma once

#include <cstddef>
#include <vector>

namespace felt {

/// A signal over time in bounded memory, for plots. It receives one value per tick and keeps the
/// smallest and largest value of each interval. When there are too many intervals, neighbours are
/// merged in pairs, so that a recording of any length fits and no peak is lost.
class PlotTrace {
 public:
  /// Smallest and largest value of one interval; `low` > `high` if it has no value.
  struct Stretch {
    double low = 1.0;
    double high = -1.0;
    [[nodiscard]] constexpr bool empty() const noexcept { return !(low <= high); }
  };

  PlotTrace() = default;
  /// The first value is at `start_s`; each next value is `step_s` later. Keeps at most `capacity`
  /// (even, >= 2) intervals.
  PlotTrace(double start_s, double step_s, std::size_t capacity = 4096);

  /// Adds the next value. A value that is not finite is a gap.
  void add(double value);

  [[nodiscard]] std::size_t size() const noexcept { return stretches_.size(); }
  [[nodiscard]] const Stretch& operator[](std::size_t i) const noexcept { return stretches_[i]; }
  /// Returns the duration of an interval, a power of two times the step.
  [[nodiscard]] double stretch_s() const noexcept {
    return step_s_ * static_cast<double>(per_stretch_);
  }
  /// Returns the start of interval i; for i = size(), the end of the last interval.
  [[nodiscard]] double time_s(std::size_t i) const noexcept {
    return start_s_ + static_cast<double>(i) * stretch_s();
  }
  /// Returns the smallest and largest value of intervals [begin, end).
  [[nodiscard]] Stretch merged(std::size_t begin, std::size_t end) const noexcept;
  /// Returns the smallest and largest value between two times; empty if the interval has no value.
  [[nodiscard]] Stretch range(double from_s, double to_s) const noexcept;

 private:
  void halve();

  double start_s_ = 0.0;
  double step_s_ = 1.0;
  std::size_t capacity_ = 0;
  std::size_t per_stretch_ = 1;  // values in a full interval
  std::size_t in_last_ = 0;      // values in the last interval so far
  std::vector<Stretch> stretches_;
};

}  // namespace felt
