#pragma once

#include <algorithm>
#include <cstdint>

namespace felt {

/// If more time has passed between two samples, the displacement in between says nothing about the
/// present speed.
inline constexpr std::int64_t kMaxSampleGapNs = 20'000'000;
inline constexpr double kMaxSampleGapS = 1e-9 * static_cast<double>(kMaxSampleGapNs);

/// Returns the time between two samples of a pen, in ns, in the range 0 to 2^64 - 1. `time_ns` must
/// not be before `last_ns`.
constexpr std::uint64_t sample_gap_ns(std::int64_t time_ns, std::int64_t last_ns) noexcept {
  // Unsigned, because the difference of two arbitrary times may overflow.
  return static_cast<std::uint64_t>(time_ns) - static_cast<std::uint64_t>(last_ns);
}

/// Returns true if a sample of time `time_ns` may follow one of `last_ns`: it is not older, and not
/// more than kMaxSampleGapNs later.
constexpr bool is_next_sample(std::int64_t time_ns, std::int64_t last_ns) noexcept {
  return time_ns >= last_ns &&
         sample_gap_ns(time_ns, last_ns) <= static_cast<std::uint64_t>(kMaxSampleGapNs);
}

/// Returns the time in which a pen moved from the last sample to the next one, in s: the time
/// between the samples, but at least `dt_s`, that of a tick. A tick of the loop may be shorter: the
/// device repeats its sample until it has a new one, and dt_s is clamped after a stall. Requires
/// is_next_sample().
constexpr double sample_gap_s(std::int64_t time_ns, std::int64_t last_ns, double dt_s) noexcept {
  return std::max(dt_s, 1e-9 * static_cast<double>(sample_gap_ns(time_ns, last_ns)));
}

}  // namespace felt
