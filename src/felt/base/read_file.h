#pragma once

#include <cstddef>
#include <string>

#include "felt/base/result.h"

namespace felt {

/// All bytes of a file, or of stdin for "-". Reads what there is, whatever size the system states,
/// so that pipes and devices work. Error: it cannot be read, it is a folder, or it holds more than
/// `max_bytes`; names the file and the reason.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

/// The same of a file on a disk, for names that somebody else wrote: neither a pipe nor a device,
/// which would be waited for or has no end, nor stdin. Error: also that it is one; names it.
Result<std::string> read_regular_file(const std::string& path, std::size_t max_bytes);

}  // namespace felt
