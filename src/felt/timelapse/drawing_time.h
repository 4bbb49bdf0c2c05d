#pragma once

#include <cstdint>
#include <optional>

#include "felt/session/event.h"

namespace felt {

/// The clock of a recording without its pauses. It runs while the pen touches the surface. Between
/// two moments at which the picture may change (touches, lifts, and events such as undo or delete),
/// it advances by at most kLongestPauseNs. Hovering, and events that choose tools or options, do
/// not count.
class DrawingTime {
 public:
  static constexpr std::int64_t kLongestPauseNs = 250'000'000;

  /// Returns the time of this event in ns. The first moment has the time 0, and times never
  /// decrease. Call it for all events in order.
  std::int64_t at(const Event& event);
  /// Returns the time of the last event.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  /// Returns true if there was a moment at which the picture may have changed.
  [[nodiscard]] bool has_begun() const noexcept { return last_moment_ns_.has_value(); }

 private:
  bool is_down_ = false;
  std::optional<std::int64_t> last_moment_ns_;
  std::int64_t now_ns_ = 0;
};

}  // namespace felt
