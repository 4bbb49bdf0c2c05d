#pragma once

#include <optional>

#include "felt/haptics/cue_law.h"
#include "felt/session/session.h"

namespace felt::desktop {

/// Finds the events of a session that the hand should feel. The events are: a tool grabbed
/// something or found nothing to grab; an end reached the point where it would snap; a hovering
/// pen reached a handle. Uses only what the session shows on the screen. Not thread-safe, but
/// usable in any thread.
class CueWatch {
 public:
  /// A handle counts as reached if it is nearer to the pen than `kFoundMm`, until it is farther
  /// than 1.5 `kFoundMm`.
  static constexpr double kFoundMm = 3.0;

  /// Returns the most important event that is true now but was not true at the last call.
  std::optional<CueEvent> look(const Session& session, const PenSample& pen);
  /// Reports an edit of the document, which shows that the gesture grabbed something.
  void edited() noexcept { came_to_something_ = true; }

 private:
  Overlay overlay_;  // reused to avoid allocations
  bool is_down_ = false;
  bool came_to_something_ = false;  // the document was edited since the pen touched
  bool snaps_ = false;
  bool found_ = false;
};

}  // namespace felt::desktop
