#pragma once

namespace felt {

/// Opens /dev/null in the place of standard streams (descriptors 0, 1, 2) that the parent closed.
/// Call first in main(): without it the next file that is opened gets such a number, and messages
/// for stderr are written into it. The streams opened here fail when used, as closed ones do, so
/// that output for a closed stdout is still an error.
void open_standard_streams() noexcept;

}  // namespace felt
