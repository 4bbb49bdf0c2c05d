#pragma once

namespace felt {

/// Opens /dev/null for each standard stream (descriptors 0, 1, 2) that the parent closed. Call it
/// first in main(): otherwise the next opened file gets that descriptor, and messages for stderr
/// are written into it. Reading or writing a stream opened here fails, as it does for a closed
/// stream, so that output to a closed stdout is still an error.
void open_standard_streams() noexcept;

}  // namespace felt
