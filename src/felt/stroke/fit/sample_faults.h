#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "felt/stroke/fit/ink_fit.h"

namespace felt {

/// What is wrong with the pressures and times of a stroke's samples. Programs write raw pressures
/// (0 to 1023), times in seconds, or no times at all (every sample at 0).
struct SampleFaults {
  std::size_t samples = 0;
  /// Number of pressures outside 0..1 by more than kPressureSlack, and the farthest of them. They
  /// count as 0 or 1.
  std::size_t bad_pressures = 0;
  double farthest_pressure = 0.0;
  /// Number of samples that are earlier than the sample before them.
  std::size_t backward_times = 0;
  /// True if the times cannot be those of a pen in milliseconds: they advance by less than
  /// kMinIntervalMs from sample to sample, or a quarter of them or more run backwards. The samples
  /// then count as samples without times.
  bool has_no_clock = false;
  /// True if the result depends on the times, because pressure or tilt vary.
  bool needs_times = false;

  friend bool operator==(const SampleFaults&, const SampleFaults&) noexcept = default;
};

/// Tolerance for pressures outside 0..1, because drivers slightly exceed their own range.
inline constexpr double kPressureSlack = 0.05;
/// The time between two samples of the fastest device (5 kHz).
inline constexpr double kMinIntervalMs = 0.2;

/// Finds the faults of one stroke's samples, one sample after the other. No allocation.
class SampleCheck {
 public:
  /// Discards the previous stroke.
  void begin() noexcept { *this = {}; }
  /// Adds the next sample, with its pressure as the source reported it.
  void add(const InkSample& sample) noexcept;
  /// Returns the faults of the samples so far.
  [[nodiscard]] SampleFaults faults() const noexcept;

 private:
  struct Range {
    bool is_empty = true;
    double low = 0.0, high = 0.0;
    void extend(double value) noexcept;
  };
  void add_time(std::int64_t time_ns) noexcept;

  SampleFaults faults_;
  Range pressures_, tilts_;
  std::optional<std::int64_t> last_time_ns_;
  std::size_t steps_ = 0;    // between samples with times
  double forward_ms_ = 0.0;  // sum of the steps that advance
};

/// Returns `sample` with its pressure limited to 0..1; a pressure that is not a number is absent.
InkSample with_valid_pressure(InkSample sample) noexcept;

/// Removes the times of a whole stroke's samples if SampleFaults::has_no_clock is true for them.
/// Returns true if it removed them.
bool drop_bad_times(std::span<InkSample> samples) noexcept;

/// Returns the faults that the fit of a stroke found together with those that were found, and
/// mended, in its samples before the fit.
SampleFaults combined_faults(SampleFaults of_fit, const SampleFaults& before) noexcept;

/// Returns true if faults of the times are worth a notice: the result depends on the times, and
/// there are at least four samples. Fewer samples can have been taken in the same millisecond.
bool times_matter(const SampleFaults& faults) noexcept;

/// Returns a clause for each fault that matters, as for a notice that begins with the name of a
/// stroke. The clauses contain no numbers, so that equal faults of many strokes can be counted
/// (ImportReport).
std::vector<std::string> fault_clauses(const SampleFaults& faults);

/// Returns the name of a stroke for a notice about its faults: "stroke 's1' (3 of 40 pressures, for
/// example 1023)".
std::string name_with_faults(std::string name, const SampleFaults& faults);

}  // namespace felt
