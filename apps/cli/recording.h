#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/formats/drawing_reader.h"
#include "felt/session/session.h"

namespace felt::cli {

/// Tells a recording (a script, the newest one in a .felt drawing, or "-") to a session, every
/// event as it is: its samples went through a device and a loop when it was made, and do not again.
/// What gesture is in work at the end is ended. Relative paths of imports start at the recording's
/// folder.
///
/// Returns what events do not tell of the drawing that held the recording: its page, its palette
/// and its view; nothing of a script.
///
/// Error: "PATH:LINE: ..." of a line that is no event, or of an event that the session refuses;
/// what came before it has been done.
Result<OpenedDrawing> tell_recording(const std::string& path, Session& session);

}  // namespace felt::cli
