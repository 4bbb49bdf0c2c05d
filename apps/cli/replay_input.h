#pragma once

#include <string>
#include <vector>

#include "felt/document/drawing.h"
#include "felt/replay/script_run.h"
#include "felt/session/session.h"

/// Files that a replay reads. Messages begin with "PATH:LINE: " or "PATH: ".
namespace felt::cli {

/// Reads the strokes of a file: .ndjson, .felt (of visible layers), .svg of Feltline.
Result<std::vector<StrokePtr>> read_strokes(const std::string& path);

/// Reads the same files as a drawing: a .felt file with layers, ids and materials, strokes in
/// .ndjson as one layer.
Result<Drawing> read_start(const std::string& path);

/// Adds the script in a file, or from stdin ("-"), to a replay.
Result<void> read_script_file(const std::string& path, ScriptRun& run);

/// Applies a recording to a session: a script (a file, or "-" for stdin), or the newest recording
/// in a .felt drawing. Relative paths of imports start at the folder of that file. If an event
/// fails, those before it have been applied.
///
/// Returns the content of the drawing that the events do not contain: its page, its palette and its
/// view. Returns an empty drawing for a script.
Result<Drawing> apply_recording_file(const std::string& path, Session& session);

}  // namespace felt::cli
