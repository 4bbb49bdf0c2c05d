#pragma once

#include <optional>

#include "felt/haptics/cue_law.h"
#include "felt/session/session.h"

namespace felt::desktop {

/// What of a session's doings a hand should be told: that a tool took hold of something, that there
/// was nothing to take, that an end is where it would snap, that a hovering pen came to something.
/// Looks at what the session shows, as the eye does; any one thread.
class CueWatch {
 public:
  /// Nearer than this a handle is under the pen; farther than half as much again it no longer is.
  static constexpr double kFoundMm = 3.0;

  /// The most important thing that is so now and was not at the last look.
  std::optional<CueEvent> look(const Session& session, const PenSample& pen);
  /// An edit came about: what the gesture took was something.
  void edited() noexcept { came_to_something_ = true; }

 private:
  Overlay overlay_;  // keeps its memory
  bool is_down_ = false;
  bool came_to_something_ = false;  // since it touched
  bool snaps_ = false;
  bool found_ = false;
};

}  // namespace felt::desktop
