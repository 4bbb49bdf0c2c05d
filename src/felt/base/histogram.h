#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace felt {

/// Counts whole numbers, such as durations in ns or distances in nm, in buckets. The width of a
/// bucket is at most 1/64 of the numbers in it; numbers below 128 are counted exactly. The memory
/// is constant, and the histograms of several threads can be added. Based on Gil Tene's
/// HdrHistogram.
class Histogram {
 public:
  /// Counts one number; a negative number counts as 0.
  void add(std::int64_t number) noexcept {
    const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(number, 0));
    ++counts_[bucket_of(value)];
    ++total_;
    max_ = std::max(max_, value);
  }

  void add(const Histogram& other) noexcept {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
    total_ += other.total_;
    max_ = std::max(max_, other.max_);
  }

  /// Returns the exact largest number, or 0 if the histogram is empty.
  [[nodiscard]] std::uint64_t max() const noexcept { return max_; }

  /// Returns the upper edge of the lowest bucket such that at least `fraction` of all numbers are
  /// in this bucket or below it. Never returns more than max().
  [[nodiscard]] std::uint64_t quantile(double fraction) const noexcept {
    const double wanted = fraction * static_cast<double>(total_);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      seen += counts_[i];
      if (seen > 0 && static_cast<double>(seen) >= wanted) return std::min(edge_of(i), max_);
    }
    return max_;
  }

 private:
  static constexpr unsigned kBits = 6;  // 2^kBits buckets for each power of two
  static constexpr std::uint64_t kSteps = std::uint64_t{1} << kBits;

  static std::size_t bucket_of(std::uint64_t value) noexcept {
    if (value < 2 * kSteps) return static_cast<std::size_t>(value);
    const unsigned shift = static_cast<unsigned>(std::bit_width(value)) - kBits - 1;
    return static_cast<std::size_t>(shift * kSteps + (value >> shift));
  }
  static std::uint64_t edge_of(std::size_t bucket) noexcept {
    if (bucket < 2 * kSteps) return bucket;
    const std::uint64_t shift = bucket / kSteps - 1;
    return ((bucket - shift * kSteps + 1) << shift) - 1;
  }

  std::array<std::uint64_t, (64 - kBits + 1) * kSteps> counts_{};
  std::uint64_t total_ = 0;
  std::uint64_t max_ = 0;
};

}  // namespace felt
