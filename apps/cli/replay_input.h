#pragma once

#include <string>
#include <vector>

#include "felt/document/drawing.h"
#include "felt/replay/apply_recording.h"
#include "felt/replay/script_run.h"
#include "felt/session/session.h"

/// Functions that read the files of a replay. Error messages begin with "PATH:LINE: " or "PATH: ".
namespace felt::cli {

/// Reads the strokes of a file: .ndjson, .felt (visible layers only), or .svg written by Feltline.
Result<VisibleInk> read_strokes(const std::string& path);

/// Reads a file of one of the formats of read_strokes() as a drawing. The layers, ids and materials
/// of a .felt file are kept; strokes in .ndjson become one layer.
Result<Drawing> read_start(const std::string& path);

/// Returns the folder of a path, with its slash. Returns an empty string for the working directory.
std::string folder_of(const std::string& path);

/// Returns a function that reads the files of import events, whose paths are relative to the folder
/// of the script. It fails for a file that is one of the outputs ("" and "-": none), because
/// writing would overwrite what was read.
ReadImport reads_imports(const std::string& script, std::vector<std::string> outputs);

/// Reads a script from a file, or from stdin ("-"), and adds it to a replay.
Result<void> read_script_file(const std::string& path, ScriptRun& run);

/// Applies a recording to a session: a script (a file, or "-" for stdin), or the newest recording
/// in a .felt drawing. Relative paths of imports are relative to the folder of the script or
/// drawing. If an event fails, the events before it have been applied.
///
/// For a drawing, returns the content that the events do not include: its page, its palette and its
/// view. For a script, returns an empty drawing.
Result<Drawing> apply_recording_file(const std::string& path, Session& session);

}  // namespace felt::cli
