#pragma once

#include <time.h>

#include <cstdint>

namespace felt::cli {

/// CPU time of the calling thread in ns: what other programs do on the machine does not count.
inline std::int64_t thread_cpu_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

}  // namespace felt::cli
