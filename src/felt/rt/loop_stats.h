#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace felt {

/// A histogram of durations from 1 ns to 18 min, with eight buckets for each doubling. So a
/// percentile is at most 1/8 too large and never too small. The size is constant, and adding is
/// real-time safe.
class TimeHistogram {
 public:
  /// Adds a duration. A negative duration counts as 0.
  constexpr void add(std::int64_t ns) noexcept {
    const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0));
    ++buckets_[index_of(value)];
    ++count_;
    max_ns_ = std::max(max_ns_, value);
  }
  constexpr void merge(const TimeHistogram& other) noexcept {
    for (std::size_t i = 0; i < kBuckets; ++i) buckets_[i] += other.buckets_[i];
    count_ += other.count_;
    max_ns_ = std::max(max_ns_, other.max_ns_);
  }

  [[nodiscard]] constexpr std::uint64_t count() const noexcept { return count_; }
  [[nodiscard]] constexpr std::int64_t max_ns() const noexcept {
    return static_cast<std::int64_t>(max_ns_);
  }
  /// Returns the smallest bucket bound such that the fraction `q` (0..1) of all durations is at
  /// most that bound; 0 if the histogram is empty.
  [[nodiscard]] constexpr std::int64_t percentile_ns(double q) const noexcept {
    const double wanted = std::clamp(q, 0.0, 1.0) * static_cast<double>(count_);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < kBuckets; ++i) {
      seen += buckets_[i];
      if (seen > 0 && static_cast<double>(seen) >= wanted) {
        return static_cast<std::int64_t>(std::min(largest_of(i), max_ns_));
      }
    }
    return max_ns();
  }

 private:
  static constexpr int kLargestBit = 40;
  static constexpr std::size_t kBuckets = 8 * (kLargestBit - 1);

  static constexpr std::size_t index_of(std::uint64_t value) noexcept {
    if (value < 8) return static_cast<std::size_t>(value);
    const int bit = static_cast<int>(std::bit_width(value)) - 1;
    if (bit > kLargestBit) return kBuckets - 1;
    return static_cast<std::size_t>(8 * (bit - 2)) + ((value >> (bit - 3)) & 7U);
  }
  static constexpr std::uint64_t largest_of(std::size_t index) noexcept {
    if (index < 8) return index;
    if (index == kBuckets - 1) return UINT64_MAX;
    const std::size_t bit = index / 8 + 2;
    return ((8 + index % 8 + 1) << (bit - 3)) - 1;
  }

  std::array<std::uint64_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  std::uint64_t max_ns_ = 0;
};

/// Statistics of how a haptic loop kept its deadlines. The object has constant size and is
/// trivially copyable, so that it can be passed between threads as a value: the haptic thread adds
/// ticks, the edit thread merges and prints.
///
/// The code that runs the loop defines "late". RealtimeThread measures from the deadline until
/// which it slept. Servo knows only the times of its calls, so it measures from one period after
/// the previous call.
class LoopStats {
 public:
  /// Adds a tick at `now_ns` that was `late_ns` late. Real-time safe.
  constexpr void tick(std::int64_t now_ns, std::int64_t late_ns, std::int64_t period_ns) noexcept {
    if (lateness_.count() == 0) first_ns_ = now_ns;
    last_ns_ = now_ns;
    lateness_.add(late_ns);
    if (period_ns > 0 && late_ns >= period_ns) {
      missed_ += static_cast<std::uint64_t>(late_ns / period_ns);
    }
  }
  /// Excludes an intentional pause between two ticks. Real-time safe.
  constexpr void leave_out(std::int64_t ns) noexcept {
    if (lateness_.count() > 0) first_ns_ += ns;
  }
  /// Adds the CPU time of one tick. Real-time safe.
  constexpr void add_cpu(std::int64_t ns) noexcept { cpu_.add(ns); }
  /// Adds the statistics of another run or loop. The rate is then computed over the sum of both
  /// durations.
  constexpr void merge(const LoopStats& other) noexcept {
    const std::int64_t together = duration_ns() + other.duration_ns();
    last_ns_ = first_ns_ + together;
    lateness_.merge(other.lateness_);
    cpu_.merge(other.cpu_);
    missed_ += other.missed_;
    runs_ += other.runs_;
  }

  [[nodiscard]] constexpr std::uint64_t ticks() const noexcept { return lateness_.count(); }
  /// Returns the number of periods without a tick.
  [[nodiscard]] constexpr std::uint64_t missed() const noexcept { return missed_; }
  /// Returns the time from the first tick to the last, without pauses.
  [[nodiscard]] constexpr std::int64_t duration_ns() const noexcept { return last_ns_ - first_ns_; }
  /// Returns ticks per second; 0 before the second tick.
  [[nodiscard]] constexpr double rate_hz() const noexcept {
    if (ticks() <= runs_ || duration_ns() <= 0) return 0.0;
    return 1e9 * static_cast<double>(ticks() - runs_) / static_cast<double>(duration_ns());
  }
  [[nodiscard]] constexpr const TimeHistogram& lateness() const noexcept { return lateness_; }
  /// Returns the CPU times; empty if they were not measured.
  [[nodiscard]] constexpr const TimeHistogram& cpu() const noexcept { return cpu_; }

 private:
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
  std::uint64_t missed_ = 0;
  std::uint64_t runs_ = 1;  // merged runs; each has one interval fewer than it has ticks
  TimeHistogram lateness_;
  TimeHistogram cpu_;
};

/// Returns one line for the user with rate, lateness, missed ticks and CPU time. Edit thread only.
std::string describe(const LoopStats& stats);

}  // namespace felt
