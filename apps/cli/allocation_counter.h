#pragma once

#include <cstdint>

namespace felt::cli {

/// Returns how often the calling thread has called operator new so far, in the program or in a
/// library it links; calls of malloc are not counted. A program that links this file (feltline,
/// bench_fit) gets its operator new in place of the global one. Under a sanitizer, which has its
/// own, the number stays 0.
std::int64_t thread_allocations() noexcept;

}  // namespace felt::cli
