#pragma once

#include <cstdint>
#include <string>

#include "ink_distance.h"

namespace felt::cli {

/// What a replay counts.
struct ReplayStats {
  std::int64_t ticks = 0;
  double simulated_s = 0.0;
  double wall_s = 0.0;               ///< of the whole loop, reading and writing included
  std::int64_t touches = 0;          ///< times that the pen came down
  std::int64_t strokes_meant = 0;    ///< that the hand was told to draw
  std::int64_t strokes_changed = 0;  ///< that became others, came or went; each counted once
  std::int64_t strokes = 0;          ///< in the document at the end
  std::int64_t segments = 0;         ///< of these
  std::int64_t edits = 0;            ///< that the document took, undo and redo included
  std::int64_t soft_faults = 0, hard_faults = 0;
  double max_asked_n = 0.0, max_sent_n = 0.0;
  double sent_sum_n = 0.0;  ///< over the ticks in contact
  std::int64_t ticks_in_contact = 0;
  InkDistance distance;  ///< from the path that the hand meant to the ink

  [[nodiscard]] double times_real_time() const noexcept {
    return wall_s > 0.0 ? simulated_s / wall_s : 0.0;
  }
  [[nodiscard]] double mean_sent_n() const noexcept {
    return ticks_in_contact > 0 ? sent_sum_n / static_cast<double>(ticks_in_contact) : 0.0;
  }
};

/// One line of JSON. Without hand targets "intended_to_ink_mm" is null.
std::string stats_json(const ReplayStats& stats);

}  // namespace felt::cli
