#pragma once

#include <string>
#include <vector>

#include "felt/replay/apply_recording.h"

namespace felt {

/// Returns a function that reads the files of import events with `read`. Relative paths are
/// relative to `folder`, which ends with a slash; "" is the working directory. It fails for a file
/// that is one of the outputs ("" and "-": none), because writing would overwrite what was read.
ReadImport guarded_imports(std::string folder, std::vector<std::string> outputs, ReadImport read);

}  // namespace felt
