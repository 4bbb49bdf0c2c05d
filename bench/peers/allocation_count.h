#pragma once

#include <cstdint>

namespace felt::bench {

/// How often this thread has called operator new, in the program or in a library it links. Calls
/// of malloc are not seen.
std::int64_t allocation_count();

}  // namespace felt::bench
