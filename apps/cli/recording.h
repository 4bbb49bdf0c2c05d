#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt::cli {

/// Tells a recording (a script, the newest one in a .felt drawing, or "-") to a session, every
/// event as it is: its samples went through a device and a loop when it was made, and do not again.
/// What gesture is in work at the end is ended. Relative paths of imports start at the recording's
/// folder.
///
/// Error: "PATH:LINE: ..." of a line that is no event, or of an event that the session refuses;
/// what came before it has been done.
Result<void> tell_recording(const std::string& path, Session& session);

}  // namespace felt::cli
