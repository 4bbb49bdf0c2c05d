#pragma once

#include <cstdint>
#include <optional>

#include "felt/haptics/cue_law.h"
#include "felt/session/session.h"

namespace felt {

/// Detects the events of a session that the hand should feel. The events are: a tool grabbed
/// something; a guide of the drawing ticked; a gesture ended without grabbing anything; the end of
/// a line came so close to a point that it would snap to it; a hovering pen reached a handle. Uses
/// only the session's overlay and preview. Not thread-safe, but usable in any thread.
class CueWatch {
 public:
  /// A handle counts as reached when its distance to the pen is at most `kFoundMm`, and until the
  /// distance exceeds 1.5 `kFoundMm`.
  static constexpr double kFoundMm = 3.0;

  /// Returns the event that occurred since the last call; if several occurred, the most important
  /// one.
  std::optional<CueEvent> look(const Session& session, const PenSample& pen);
  /// Must be called when the document was edited, which shows that the gesture grabbed something.
  void edited() noexcept { came_to_something_ = true; }

 private:
  Overlay overlay_;  // reused to avoid allocations
  bool is_down_ = false;
  bool came_to_something_ = false;  // the document was edited since the pen touched
  bool snaps_ = false;
  bool found_ = false;
  std::uint64_t guide_ticks_ = 0;  // Session::guide_ticks()
};

}  // namespace felt
