#pragma once

#include <cstdint>

namespace felt::cli {

/// Returns how often the calling thread has called operator new so far, in the program or in a
/// linked library. Calls of malloc are not counted. allocation_counter.cc replaces the global
/// operator new of each program that links it (feltline, bench_fit). In a build with a sanitizer,
/// which has its own operator new, the number stays 0.
std::int64_t thread_allocations() noexcept;

}  // namespace felt::cli
