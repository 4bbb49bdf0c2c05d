#include "tests/devices/rt/recorded_lateness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace felt::rt_test {
namespace {

constexpr std::array kRows{
    // docs/design/loop.md#wake-up-lateness, machine under light load
    RecordedLateness{"other, light, 1 kHz", 1000, 70, 827, 5118, 6149},
    RecordedLateness{"other, light, 4 kHz", 4000, 59, 148, 1252, 3951},
    RecordedLateness{"other, light, 5 kHz", 5000, 57, 153, 1216, 5292},
    RecordedLateness{"slack 1, light, 1 kHz", 1000, 18, 87, 1022, 1742},
    RecordedLateness{"slack 1, light, 4 kHz", 4000, 11, 64, 1164, 4938},
    RecordedLateness{"slack 1, light, 5 kHz", 5000, 5, 304, 3924, 5328},
    RecordedLateness{"nice, light, 1 kHz", 1000, 17, 79, 1187, 3158},
    RecordedLateness{"nice, light, 4 kHz", 4000, 12, 73, 156, 3307},
    RecordedLateness{"nice, light, 5 kHz", 5000, 6, 12, 57, 138},
    RecordedLateness{"fifo, light, 1 kHz", 1000, 24, 95, 285, 978},
    RecordedLateness{"fifo, light, 4 kHz", 4000, 11, 60, 130, 1463},
    RecordedLateness{"fifo, light, 5 kHz", 5000, 5, 14, 60, 1690},
    RecordedLateness{"spin, light, 1 kHz", 1000, 0, 148, 3930, 3953},
    RecordedLateness{"spin, light, 4 kHz", 4000, 0, 10, 3200, 5179},
    RecordedLateness{"spin, light, 5 kHz", 5000, 0, 1643, 4445, 8060},
    // the same, machine under heavy load
    RecordedLateness{"other, loaded, 1 kHz", 1000, 63, 5482, 10497, 19504},
    RecordedLateness{"other, loaded, 4 kHz", 4000, 59, 3799, 11816, 20538},
    RecordedLateness{"slack 1, loaded, 1 kHz", 1000, 11, 3933, 5414, 6930},
    RecordedLateness{"slack 1, loaded, 4 kHz", 4000, 7, 3811, 13076, 16063},
    RecordedLateness{"nice, loaded, 1 kHz", 1000, 10, 40, 3940, 4334},
    RecordedLateness{"nice, loaded, 4 kHz", 4000, 7, 18, 249, 7606},
    RecordedLateness{"fifo, loaded, 1 kHz", 1000, 14, 151, 767, 16174},
    RecordedLateness{"fifo, loaded, 4 kHz", 4000, 8, 119, 466, 15715},
    // "a FIFO run in a quiet moment once showed 29 ms"
    RecordedLateness{"fifo, quiet, once", 1000, 21, 98, 218, 29000},
    // docs/design/loop.md#wake-up-lateness, second series
    RecordedLateness{"other, other jobs", 1000, 64, 1173, 4260, 7122},
    RecordedLateness{"fifo, other jobs", 1000, 12, 35, 282, 684},
    RecordedLateness{"other, stress", 1000, 3202, 20080, 35980, 42111},
    RecordedLateness{"fifo, stress", 1000, 10, 24, 440, 3411},
};

// Returns the lateness in us at a rank. Rank 1 is the smallest lateness, rank 0 the largest.
double lateness_us(const RecordedLateness& row, double rank) {
  struct Known {
    double rank;
    double us;
  };
  const double floor_us = 0.5;  // because the logarithm of 0 is undefined
  const std::array<Known, 5> known{{{1.0, std::max(0.25 * row.p50_us, floor_us)},
                                    {0.5, std::max(row.p50_us, floor_us)},
                                    {0.01, row.p99_us},
                                    {0.001, row.p999_us},
                                    {1e-5, row.max_us}}};
  if (rank <= known.back().rank) return row.max_us;
  std::size_t i = 1;
  while (rank < known[i].rank) ++i;
  const Known& a = known[i - 1];
  const Known& b = known[i];
  const double f = std::log(rank / a.rank) / std::log(b.rank / a.rank);
  return a.us * std::pow(b.us / a.us, f);
}

}  // namespace

std::span<const RecordedLateness> recorded_lateness() noexcept {
  return kRows;
}

std::vector<std::int64_t> draw_lateness(const RecordedLateness& row, std::size_t count,
                                        std::uint64_t seed, std::size_t burst) {
  std::mt19937_64 random(seed);
  // One value of each rank, in random order, so that the percentiles do not depend on the seed.
  std::vector<std::int64_t> made(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double rank = i == 0 ? 0.0 : (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    made[i] = static_cast<std::int64_t>(1e3 * lateness_us(row, rank));
  }
  const std::size_t group = std::max<std::size_t>(burst, 1);
  const std::size_t groups = count / group;
  for (std::size_t i = groups; i > 1; --i) {  // Fisher-Yates shuffle of whole groups
    const std::size_t j = random() % i;
    if (j == i - 1) continue;
    for (std::size_t k = 0; k < group; ++k)
      std::swap(made[(i - 1) * group + k], made[j * group + k]);
  }
  return made;
}

}  // namespace felt::rt_test
