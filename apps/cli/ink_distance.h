#pragma once

#include <span>
#include <vector>

#include "felt/geometry/bvh.h"
#include "felt/stroke/stroke.h"
#include "latency_histogram.h"

namespace felt::cli {

/// How far ink is from the path that the hand meant: gathers distances of many strokes in bounded
/// memory. Both ways: from places on the ink to the path, and from places on the path to the ink,
/// so that neither a detour nor a missing part stays unseen.
class InkDistance {
 public:
  /// One stroke that was meant and what came of it.
  void add(std::span<const Point> meant, std::span<const Stroke> ink);

  [[nodiscard]] double mean_mm() const noexcept;
  /// 95 % of the places are no farther.
  [[nodiscard]] double p95_mm() const noexcept {
    return 1e-6 * double_of(places_.quantile_ns(0.95));
  }
  [[nodiscard]] double max_mm() const noexcept { return 1e-6 * double_of(places_.max_ns()); }
  [[nodiscard]] std::int64_t count() const noexcept { return count_; }

 private:
  static double double_of(std::uint64_t value) noexcept { return static_cast<double>(value); }
  void add_place(const SegmentBvh& tree, Point place);

  LatencyHistogram places_;  // in nm, which stand for its ns
  double sum_mm_ = 0.0;
  std::int64_t count_ = 0;
};

}  // namespace felt::cli
