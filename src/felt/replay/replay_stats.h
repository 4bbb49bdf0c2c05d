#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "felt/base/histogram.h"
#include "felt/geometry/bvh.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Distances between ink and the path that the hand intended, for many strokes in bounded memory.
/// They are measured in both directions, from points on the ink to the path and from points on the
/// path to the ink, so that both a detour and a missing part are noticed.
class InkDistance {
 public:
  /// Adds one intended stroke and its ink.
  void add(std::span<const Point> meant, std::span<const Stroke> ink);

  [[nodiscard]] double mean_mm() const noexcept;
  /// Returns the distance that 95 % of the points do not exceed.
  [[nodiscard]] double p95_mm() const noexcept { return mm_of(points_nm_.quantile(0.95)); }
  [[nodiscard]] double max_mm() const noexcept { return mm_of(points_nm_.max()); }
  [[nodiscard]] std::int64_t count() const noexcept { return count_; }

 private:
  static double mm_of(std::uint64_t nm) noexcept { return 1e-6 * static_cast<double>(nm); }
  void add_point(const SegmentBvh& tree, Point point);

  Histogram points_nm_;
  double sum_mm_ = 0.0;
  std::int64_t count_ = 0;
};

/// The counts of a replay.
struct ReplayStats {
  std::int64_t ticks = 0;
  double simulated_s = 0.0;
  double wall_s = 0.0;               ///< wall time of the whole run, including reading and writing
  std::int64_t touches = 0;          ///< times that the pen came down
  std::int64_t strokes_meant = 0;    ///< strokes that the hand had to draw
  std::int64_t strokes_changed = 0;  ///< strokes added, changed or removed; each counts once
  std::int64_t strokes = 0;          ///< strokes in the document at the end
  std::int64_t segments = 0;         ///< segments of these strokes
  std::int64_t edits = 0;            ///< edits of the document, including undo and redo
  std::int64_t soft_faults = 0, hard_faults = 0;
  double max_asked_n = 0.0, max_sent_n = 0.0;
  double sent_sum_n = 0.0;  ///< sum over the ticks in contact
  std::int64_t ticks_in_contact = 0;
  std::optional<std::int64_t> cues{};  ///< ticks and vibrations, if the device plays cues
  InkDistance distance;                ///< from the intended path to the ink

  [[nodiscard]] double times_real_time() const noexcept {
    return wall_s > 0.0 ? simulated_s / wall_s : 0.0;
  }
  [[nodiscard]] double mean_sent_n() const noexcept {
    return ticks_in_contact > 0 ? sent_sum_n / static_cast<double>(ticks_in_contact) : 0.0;
  }
};

/// Returns one line of JSON. Without intended strokes, "intended_to_ink_mm" is null.
std::string stats_json(const ReplayStats& stats);

}  // namespace felt
