#pragma once

#include <cstdint>
#include <optional>

#include "felt/stroke/ink_sample.h"

namespace felt {

/// How pressure becomes width: W = min + (max - min) p^gamma (specification section 5b).
/// The defaults are those of the haptic plane, where pressing is the paper's way to draw broader.
struct WidthMapOptions {
  double min_mm = 0.3;             ///< width at p = 0; not below kMinWidthMm
  double max_mm = 6.0;             ///< width at p = 1; not below min_mm
  double gamma = 1.0;              ///< > 0; above 1 keeps a light hand thin
  double absent_pressure = 0.5;    ///< p where the source has none (a mouse)
  double time_constant_ms = 20.0;  ///< of the low-pass on p; 0 switches it off
  double interval_ms = 7.5;        ///< between samples without times (a tablet at 133 Hz)
};

/// Widths of an ordinary pen: what tablet and mouse ink gets unless asked otherwise. A tablet
/// reports about 0.3..0.6 in writing, which would be 2..4 mm on the scale of the haptic plane.
inline constexpr WidthMapOptions kPenWidths{.min_mm = 0.3, .max_mm = 2.0};

/// Width in mm of the pressure p. p is clamped to [0, 1], NaN counts as absent. Non-decreasing
/// in p; exactly min_mm at 0 and max_mm at 1 (R14).
double width_of_pressure(const WidthMapOptions& options, double p) noexcept;

/// Filtered widths of one stroke's samples, one after the other.
///
/// Pressure passes a first-order low-pass before it is mapped, since the noise of the sensor and
/// the tremor of the hand would otherwise cost 2.6 to 8.5 times as many width segments
/// (specification, decision 9). Implicit Euler, y += (x - y) dt / (tau + dt): stable and without
/// overshoot for every dt, and free of transcendental functions whose last bit depends on the
/// machine.
class WidthMap {
 public:
  /// Out-of-range options are moved to the nearest sensible value.
  explicit WidthMap(const WidthMapOptions& options = {}) noexcept;

  /// Forgets the last stroke. The first sample sets the filter to its pressure.
  void begin() noexcept;
  /// Takes the next sample and returns its width in mm. A sample without pressure holds the last
  /// one of the stroke. Time that stands still or runs backwards counts as 0.2 ms, the tick of the
  /// fastest device, so a stuck clock cannot freeze the width.
  double push(const InkSample& sample) noexcept;

  [[nodiscard]] const WidthMapOptions& options() const noexcept { return options_; }

 private:
  double elapsed_ms(const InkSample& sample) noexcept;

  WidthMapOptions options_;
  std::optional<double> filtered_;
  double pressure_ = 0.0;  // the last one seen, clamped
  std::optional<std::int64_t> last_time_ns_;
};

}  // namespace felt
