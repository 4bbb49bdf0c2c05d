#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace felt::rt_test {

/// How late a loop's ticks came on a real machine: one row of docs/design/loop.md#wake-up-lateness,
/// in us.
struct RecordedLateness {
  std::string_view name;
  double rate_hz = 1000.0;
  double p50_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
};

/// All rows: four policies and a spinning one, machine light and loaded, 1, 4 and 5 kHz.
std::span<const RecordedLateness> recorded_lateness() noexcept;

/// `count` latenesses in ns, drawn at random (seeded) so that their percentiles are those of the
/// row: between the known ones the logarithm of the lateness is linear in that of the rank from the
/// end. The maximum occurs once at least. In bursts of `burst` ticks each, the late ones come
/// together, as they do where something else keeps the processor: 1 is independent.
std::vector<std::int64_t> draw_lateness(const RecordedLateness& row, std::size_t count,
                                        std::uint64_t seed, std::size_t burst = 1);

}  // namespace felt::rt_test
