#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace felt::rt_test {

/// Measured lateness of a loop's ticks on a real machine, in us. This is one row of
/// docs/design/loop.md#wake-up-lateness.
struct RecordedLateness {
  std::string_view name;
  double rate_hz = 1000.0;
  double p50_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
};

/// Returns all rows: four scheduling policies and a spinning loop, under light and heavy load, at
/// 1, 4 and 5 kHz.
std::span<const RecordedLateness> recorded_lateness() noexcept;

/// Returns `count` random latenesses in ns with the percentiles of `row`. Deterministic for a
/// `seed`. Between the known percentiles, the logarithm of the lateness is linear in the logarithm
/// of the rank, counted from the largest value. The maximum occurs at least once. Late ticks come
/// in bursts of `burst` ticks, as if another program occupies the processor; 1 means independent.
std::vector<std::int64_t> draw_lateness(const RecordedLateness& row, std::size_t count,
                                        std::uint64_t seed, std::size_t burst = 1);

}  // namespace felt::rt_test
