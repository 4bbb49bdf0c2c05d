#pragma once

#include <cstdint>

namespace felt::cli {

/// Number of times that the calling thread has called operator new so far, in the program or in a
/// library it links; calls of malloc are not seen. Whoever links this file gets its operator new in
/// place of the global one (the program, bench_fit); under a sanitizer, which brings its own, the
/// number stays 0.
std::int64_t thread_allocations() noexcept;

}  // namespace felt::cli
