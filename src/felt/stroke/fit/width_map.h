#pragma once

#include <cstdint>
#include <optional>

#include "felt/stroke/fit/ink_fit.h"

namespace felt {

/// Returns the width in mm for the pressure p, which is clamped to [0, 1]. NaN counts as absent:
/// then the pressure is `absent_pressure` of the options. The width never decreases as p increases,
/// and is exactly min_mm at 0 and max_mm at 1 (R14).
double width_of_pressure(const WidthMapOptions& options, double p) noexcept;

/// Returns the width in mm for the pressure p and the tilt l, both clamped to [0, 1]. At l = 0, the
/// result is exactly width_of_pressure().
double width_of(const WidthMapOptions& options, double p, double l) noexcept;

/// Returns the tone, 0..1, for the pressure p and the tilt l, or the default tone of the width if
/// the options define no tone. The tone is monotonic in p and in l.
double tone_of(const WidthMapOptions& options, double p, double l) noexcept;

/// Width and tone of the ink under the pen.
struct InkWidth {
  double width_mm = 0.0;
  double tone = 0.0;

  friend constexpr bool operator==(const InkWidth&, const InkWidth&) noexcept = default;
};

/// Computes the filtered widths and tones of one stroke's samples, one after the other.
///
/// Pressure and tilt each pass a first-order low-pass before they are mapped, because the noise of
/// the sensor and the tremor of the hand would otherwise cause 2.6 to 8.5 times as many width
/// segments (docs/design/strokes.md#width). The low-pass is integrated by implicit Euler, y += (x -
/// y) dt / (tau + dt), which is stable and does not overshoot for any dt. It uses no transcendental
/// functions, because their last bit depends on the machine.
class WidthMap {
 public:
  /// Moves options that are out of range to the nearest valid value.
  explicit WidthMap(const WidthMapOptions& options = {}) noexcept;

  /// Discards the previous stroke. The first sample sets the filters to its pressure and tilt.
  void begin() noexcept;
  /// Processes the next sample and returns its width and tone. If a sample has no pressure or no
  /// tilt, uses the value of the last sample of the stroke that had it, or the default of the
  /// options if no sample has had it yet. Time that stands still or runs backwards counts as 0.2
  /// ms, the tick of the fastest device, so a stuck clock cannot freeze the width.
  InkWidth push(const InkSample& sample) noexcept;

  [[nodiscard]] const WidthMapOptions& options() const noexcept { return options_; }

 private:
  double elapsed_ms(const InkSample& sample) noexcept;

  WidthMapOptions options_;
  bool is_first_ = true;
  double pressure_ = 0.0, tilt_ = 0.0;  // of the last sample that had them, 0..1
  double filtered_pressure_ = 0.0, filtered_tilt_ = 0.0;
  std::optional<std::int64_t> last_time_ns_;
};

}  // namespace felt
