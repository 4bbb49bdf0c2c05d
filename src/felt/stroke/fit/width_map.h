#pragma once

#include <cstdint>
#include <optional>

#include "felt/stroke/fit/ink_sample.h"

namespace felt {

/// How pressure and lean become tone (WidthKnot::tone), for a medium that has its own:
///   tone = (light + (heavy - light) p^gamma) (1 + (lean - 1) l)
struct ToneMapOptions {
  double light = 0.0;  ///< tone at p = 0; 0..1
  double heavy = 1.0;  ///< at p = 1; 0..1
  double gamma = 1.0;  ///< > 0
  double lean = 1.0;   ///< tone of a pen that leans fully, in tones of an upright one; 0..1

  friend bool operator==(const ToneMapOptions&, const ToneMapOptions&) = default;
};

/// How pressure becomes width: W = (min + (max - min) p^gamma) (1 + (lean_width - 1) l), by
/// specification section 5b and the lean share l of geometry/lean.h. The defaults are those of the
/// haptic plane, where pressing is the paper's way to draw broader, without any lean.
struct WidthMapOptions {
  double min_mm = 0.3;                   ///< width at p = 0; not below kMinWidthMm
  double max_mm = 6.0;                   ///< width at p = 1; not below min_mm
  double gamma = 1.0;                    ///< > 0; above 1 keeps a light hand thin
  double absent_pressure = 0.5;          ///< p where the source has none (a mouse)
  double time_constant_ms = 20.0;        ///< of the low-pass on p; 0 switches it off
  double interval_ms = 7.5;              ///< between samples without times (a tablet at 133 Hz)
  double lean_width = 1.0;               ///< width of a pen that leans fully, in upright ones; >= 1
  double absent_lean_deg = 0.0;          ///< lean where the source has none
  std::optional<ToneMapOptions> tone{};  ///< absent: tone_of_width of the width

  friend bool operator==(const WidthMapOptions&, const WidthMapOptions&) = default;
};

/// Widths of an ordinary pen: what tablet and mouse ink gets unless asked otherwise. A tablet
/// reports about 0.3..0.6 in writing, which would be 2..4 mm on the scale of the haptic plane.
inline constexpr WidthMapOptions kPenWidths{.min_mm = 0.3, .max_mm = 2.0};

/// Width in mm of the pressure p. p is clamped to [0, 1], NaN counts as absent. Non-decreasing
/// in p; exactly min_mm at 0 and max_mm at 1 (R14).
double width_of_pressure(const WidthMapOptions& options, double p) noexcept;

/// Likewise of pressure and lean share, both clamped. Exactly width_of_pressure() at l = 0.
double width_of(const WidthMapOptions& options, double p, double l) noexcept;

/// Tone of pressure and lean share, 0..1; that of the width when the medium has none of its own.
/// Monotonic in both.
double tone_of(const WidthMapOptions& options, double p, double l) noexcept;

/// What the ink is like under the pen.
struct InkWidth {
  double width_mm = 0.0;
  double tone = 0.0;

  friend constexpr bool operator==(const InkWidth&, const InkWidth&) noexcept = default;
};

/// Filtered widths and tones of one stroke's samples, one after the other.
///
/// Pressure and lean share each pass a first-order low-pass before they are mapped, since the noise
/// of the sensor and the tremor of the hand would otherwise cost 2.6 to 8.5 times as many width
/// segments (specification, decision 9). Implicit Euler, y += (x - y) dt / (tau + dt): stable and
/// without overshoot for every dt, and free of transcendental functions whose last bit depends on
/// the machine.
class WidthMap {
 public:
  /// Out-of-range options are moved to the nearest sensible value.
  explicit WidthMap(const WidthMapOptions& options = {}) noexcept;

  /// Forgets the last stroke. The first sample sets the filters to its pressure and lean.
  void begin() noexcept;
  /// Takes the next sample and returns its width and tone. A sample without pressure or lean holds
  /// the last one of the stroke. Time that stands still or runs backwards counts as 0.2 ms, the
  /// tick of the fastest device, so a stuck clock cannot freeze the width.
  InkWidth push(const InkSample& sample) noexcept;

  [[nodiscard]] const WidthMapOptions& options() const noexcept { return options_; }

 private:
  double elapsed_ms(const InkSample& sample) noexcept;

  WidthMapOptions options_;
  bool is_first_ = true;
  double pressure_ = 0.0, lean_ = 0.0;  // the last ones seen, 0..1
  double filtered_pressure_ = 0.0, filtered_lean_ = 0.0;
  std::optional<std::int64_t> last_time_ns_;
};

}  // namespace felt
