#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/io/import.h"
#include "felt/replay/replay_machine.h"
#include "felt/timelapse/timelapse.h"

namespace felt {

/// A recording, and the drawing that it belongs to.
struct TimelapseInput {
  TimelapseSource source;
  /// The page of a .felt drawing, or of the drawing on which a script begins; has_page is false if
  /// there is none.
  Drawing frame{.has_page = false};
  /// Faults of the samples of raw strokes in a script.
  ImportReport report{};
};

/// Text of an event script (docs/formats/events.md).
struct TimelapseScript {
  std::string name;  ///< for messages
  const std::string& text;
  /// Folder of relative paths in it; ends with a slash; "" is the working directory.
  std::string folder;
  /// The pen that draws hand events and raw strokes, if the script contains any.
  ReplaySettings pen;
};

/// Sets the recording of `input.source` to a script. Pen samples are used as they were recorded; if
/// the script has hand events or raw strokes, the simulated pen draws it first, on
/// `input.source.start`. Returns false in that case, because paths of imports are then relative to
/// the working directory. Fails if the script is invalid ("NAME:LINE: reason").
Result<bool> use_script(const TimelapseScript& script, TimelapseInput& input);

/// Sets the recording of `input.source` to the newest one of a drawing, adds the materials of the
/// drawing, and sets the page of `input.frame`. Fails if the drawing has no recording. Messages
/// begin with `name`.
Result<void> use_newest_recording(const std::string& name, const Drawing& drawing,
                                  TimelapseInput& input);

/// Fails if nothing in the recording can change the picture. The message begins with `name`.
Result<void> check_has_moments(const std::string& name, const TimelapseInput& input);

}  // namespace felt
