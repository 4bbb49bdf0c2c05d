#pragma once

#include <optional>

#include "felt/haptics/cue_law.h"
#include "felt/session/session.h"

namespace felt::desktop {

/// Finds the events of a session that the hand should feel: a tool grabbed something, there was
/// nothing to grab, an end is where it would snap, a hovering pen reached a handle. Uses what the
/// session shows on the screen. Not thread-safe; any thread.
class CueWatch {
 public:
  /// A handle nearer than this is under the pen, until it is 1.5 times as far.
  static constexpr double kFoundMm = 3.0;

  /// Returns the most important event that is true now and was not at the last call.
  std::optional<CueEvent> look(const Session& session, const PenSample& pen);
  /// The document was edited, so the gesture grabbed something.
  void edited() noexcept { came_to_something_ = true; }

 private:
  Overlay overlay_;  // reused, so that it keeps its memory
  bool is_down_ = false;
  bool came_to_something_ = false;  // since the pen touched
  bool snaps_ = false;
  bool found_ = false;
};

}  // namespace felt::desktop
