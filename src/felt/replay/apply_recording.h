#pragma once

#include <functional>
#include <string>

#include "felt/base/result.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/session/session.h"
#include "felt/store/felt_file.h"

/// Functions that apply a recording to a session, with every event unchanged. They simulate no
/// device and no haptic loop, because the recorded samples already come from a haptic loop. At the
/// end they end the gesture in progress.
///
/// Both fail at an event that the session refuses, and at an import event if its file cannot be
/// read. The events before that event have been applied.
namespace felt {

/// Reads the strokes of the file that an import event names.
using ReadImport = std::function<Result<VisibleInk>(const std::string& path)>;

/// Applies one event of a recording, and reads the file of an import event.
Result<void> apply_event(const Event& event, const ReadImport& read_import, Session& session);

/// Applies a script. `name` is for errors, "NAME:LINE: reason".
Result<void> apply_script(const std::string& name, ReadBytes read, const ReadImport& read_import,
                          Session& session);

/// Applies the newest recording in a drawing. Fails if the drawing has no recording.
Result<void> apply_recording(const Drawing& drawing, const ReadImport& read_import,
                             Session& session);

}  // namespace felt
