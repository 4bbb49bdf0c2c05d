#pragma once

#include <cstdint>

namespace felt::cli {

/// Number of times that the calling thread has called operator new so far. This program replaces
/// the global operator new by one that counts; under a sanitizer, which brings its own, the number
/// stays 0.
std::int64_t thread_allocations() noexcept;

}  // namespace felt::cli
