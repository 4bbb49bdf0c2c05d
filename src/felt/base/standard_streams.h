#pragma once

namespace felt {

/// Opens /dev/null for each standard stream (descriptors 0, 1, 2) that the parent closed. Call it
/// first in main(). Otherwise, a file that is opened later may get descriptor 2, and messages for
/// stderr would be written into that file. Reading from or writing to a stream that was opened here
/// fails, as for a closed stream, so that output to a closed stdout is still an error.
void open_standard_streams() noexcept;

}  // namespace felt
