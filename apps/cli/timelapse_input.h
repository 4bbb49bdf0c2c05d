#pragma once

#include <string>

#include "console.h"
#include "felt/timelapse/timelapse_input.h"

namespace felt::cli {

/// The files on the command line; "-" is stdin or stdout.
struct TimelapseFiles {
  std::string input;
  /// A drawing on which a script begins; "" for none. It cannot be used with a .felt input, because
  /// its recording begins with an empty page.
  std::string on;
  std::string output;
};

/// Reads a recording: the newest one of a .felt drawing, a script (.ndjson, or "-" for stdin) of
/// pen samples as they were recorded, or a script with hand events or raw strokes. A simulated pen
/// draws the last kind first, as `feltline replay` does with its defaults. Fails if the file cannot
/// be read or contains nothing to show; messages begin with "PATH:LINE: " or "PATH: ". Later, the
/// source fails if the recording imports the output.
Result<TimelapseInput> read_timelapse(const TimelapseFiles& files, Console& console);

}  // namespace felt::cli
