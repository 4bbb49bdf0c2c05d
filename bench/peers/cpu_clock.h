#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>

namespace felt::bench {

/// Returns the CPU time of the calling thread. It does not include other programs.
inline std::int64_t thread_cpu_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
}

/// Returns the median of 1,001 empty measurements. Every per-call figure includes this cost, which
/// is not subtracted.
inline std::int64_t timer_overhead_ns() {
  std::array<std::int64_t, 1001> empty{};
  for (auto& value : empty) {
    const std::int64_t start = thread_cpu_ns();
    value = thread_cpu_ns() - start;
  }
  std::nth_element(empty.begin(), empty.begin() + 500, empty.end());
  return empty[500];
}

}  // namespace felt::bench
