#pragma once

#include <cstddef>
#include <vector>

namespace felt {

/// A signal over time in bounded memory, for plots: one value a tick comes in, and the smallest and
/// largest of each stretch of time are kept. When the stretches get too many, neighbours merge in
/// pairs, so that any recording fits and no peak is ever lost.
class PlotTrace {
 public:
  /// Smallest and largest value of one stretch; `low` > `high` where there was none.
  struct Stretch {
    double low = 1.0;
    double high = -1.0;
    [[nodiscard]] constexpr bool empty() const noexcept { return !(low <= high); }
  };

  PlotTrace() = default;
  /// The first value is that of `start_s`, the next one comes `step_s` later. Keeps at most
  /// `capacity` (even, >= 2) stretches.
  PlotTrace(double start_s, double step_s, std::size_t capacity = 4096);

  /// The next value; one that is not finite is a gap.
  void add(double value);

  [[nodiscard]] std::size_t size() const noexcept { return stretches_.size(); }
  [[nodiscard]] const Stretch& operator[](std::size_t i) const noexcept { return stretches_[i]; }
  /// Duration of a stretch, a power of two times the step.
  [[nodiscard]] double stretch_s() const noexcept {
    return step_s_ * static_cast<double>(per_stretch_);
  }
  /// Begin of stretch i; i = size() is the end of the last one.
  [[nodiscard]] double time_s(std::size_t i) const noexcept {
    return start_s_ + static_cast<double>(i) * stretch_s();
  }
  /// Smallest and largest value of the stretches from `begin` up to, not including, `end`.
  [[nodiscard]] Stretch merged(std::size_t begin, std::size_t end) const noexcept;
  /// Smallest and largest value between two times; empty where there is none.
  [[nodiscard]] Stretch range(double from_s, double to_s) const noexcept;

 private:
  void halve();

  double start_s_ = 0.0;
  double step_s_ = 1.0;
  std::size_t capacity_ = 0;
  std::size_t per_stretch_ = 1;  // values that make a full one
  std::size_t in_last_ = 0;      // values in the last one so far
  std::vector<Stretch> stretches_;
};

}  // namespace felt
