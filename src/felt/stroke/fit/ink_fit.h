#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/stroke/stroke.h"

/// Input, options and result of a fit of ink (InkFitter).
namespace felt {

/// One pen sample with only the values that determine ink: position, pressure, time and tilt.
struct InkSample {
  Point position;                       ///< mm, page coordinates
  std::optional<double> pressure;       ///< 0..1; absent if the source reports none
  std::optional<std::int64_t> time_ns;  ///< since the session began; can run backwards
  std::optional<double> tilt_deg{};  ///< tilt from the upright, 0..90 (geometry/tilt.h converts it
                                     ///< to 0..1); absent if the source reports none

  friend constexpr bool operator==(const InkSample&, const InkSample&) noexcept = default;
};

/// The tolerance of a curve fit.
struct CurveFitOptions {
  /// Largest distance from any sample to the curve, in mm. Values below kMinSegmentMm, the
  /// resolution of the stroke model (I5), count as kMinSegmentMm.
  double tolerance_mm = 0.15;
  [[nodiscard]] double effective_tolerance_mm() const noexcept {
    return std::max(tolerance_mm, kMinSegmentMm);
  }
};

/// Thresholds by which PenFilter recognises artefacts of the pen. Times are those of the samples.
struct PenFilterOptions {
  /// Delay of each sample before it becomes ink. Artefacts can be corrected within this time of
  /// either end of the stroke.
  double window_ms = 30.0;
  /// Assumed time between samples without times (a tablet at 133 Hz).
  double interval_ms = 7.5;

  /// A pressure blob: within blob_ms and blob_mm of an end of the stroke, the pressure is more than
  /// blob_ratio times the pressure one window away from that end.
  double blob_ratio = 1.3;
  double blob_ms = 25.0;
  double blob_mm = 0.5;

  /// A hook at lift: at most hook_max_mm of path after a turn by at least hook_angle_deg, with
  /// pressures of at most hook_pressure_ratio times the largest pressure up to the turn. If the
  /// stroke ends nearer than hook_min_mm to the turn, the turn counts as noise.
  double hook_max_mm = 1.5;
  double hook_min_mm = 0.15;
  double hook_angle_deg = 90.0;
  double hook_pressure_ratio = 0.5;

  /// A stray sample is farther from its neighbours than jump_mm and faster than jump_mm_per_s.
  /// Hands reach 1.5 to 2.5 m/s in fast strokes.
  double jump_mm = 10.0;
  double jump_mm_per_s = 5000.0;
};

/// How pressure p and tilt l become tone (WidthKnot::tone), for a medium with its own tone:
///   tone = (light + (heavy - light) p^gamma) (1 + (tilt - 1) l)
struct ToneMapOptions {
  double light = 0.0;  ///< tone at p = 0; 0..1
  double heavy = 1.0;  ///< tone at p = 1; 0..1
  double gamma = 1.0;  ///< > 0
  double tilt = 1.0;   ///< tone of a fully tilted pen relative to an upright one; 0..1

  friend bool operator==(const ToneMapOptions&, const ToneMapOptions&) = default;
};

/// How pressure becomes width: W = (min + (max - min) p^gamma) (1 + (tilt_width - 1) l), by
/// docs/design/strokes.md#width, with the tilt l in 0..1 (geometry/tilt.h). The defaults are for
/// the haptic plane, where lines become broader when the user presses harder, as in the paper. By
/// default, tilt has no effect.
struct WidthMapOptions {
  double min_mm = 0.3;             ///< width at p = 0; not below kMinWidthMm
  double max_mm = 6.0;             ///< width at p = 1; not below min_mm
  double gamma = 1.0;              ///< > 0; above 1 keeps light strokes thin
  double absent_pressure = 0.5;    ///< p to use if the source reports none (a mouse)
  double time_constant_ms = 20.0;  ///< of the low-pass filters of p and l; 0: no filters
  double interval_ms = 7.5;        ///< assumed time between samples without times
  double tilt_width = 1.0;         ///< width of a fully tilted pen relative to an upright one; >= 1
  double absent_tilt_deg = 0.0;    ///< tilt to use if the source reports none
  std::optional<ToneMapOptions> tone{};  ///< if absent, the tone is tone_of_width(width)

  friend bool operator==(const WidthMapOptions&, const WidthMapOptions&) = default;
};

/// Widths of an ordinary pen: the default for tablet and mouse ink. In writing, a tablet reports
/// pressures of about 0.3..0.6, which would give 2..4 mm with the widths of the haptic plane.
inline constexpr WidthMapOptions kPenWidths{.min_mm = 0.3, .max_mm = 2.0};

/// Tolerances of the fit of a width profile.
struct WidthFitOptions {
  /// Largest difference between the profile and the filtered width of any sample, in mm. With 0,
  /// every sample that is not on the line between its neighbours gets a knot.
  double tolerance_mm = 0.15;
  double min_mm = kMinWidthMm;  ///< widths are clamped to [min_mm, max_mm] (I4)
  double max_mm = 6.0;
  /// Largest difference between the profile and the tone of any sample, if samples have their own
  /// tone. In handwriting on a tablet with widths of 0.3..2 mm, a fit with tone needs as many knots
  /// as a fit of the widths alone if this tolerance is 0.1, 11 % more if it is 0.05, and 28 % more
  /// if it is 0.03. With widths of 0.3..6 mm, 0.05 adds no knots.
  double tone_tolerance = 0.05;
};

/// The scheme by which the curve of a stroke is fitted.
enum class FitScheme {
  kFeltline,   ///< Feltline's own: all samples within the tolerance, G1 joints, sharp corners
  kPaper2002,  ///< the scheme of the paper (eq. 2, R6), for study: neighbouring segments share
               ///< samples
};

/// Options of the whole path from samples to a stroke.
struct InkFitOptions {
  FitScheme scheme = FitScheme::kFeltline;
  CurveFitOptions curve;
  /// s of [Paper eq. 2]: neighbouring segments share 2s + 1 samples. Used by kPaper2002 only.
  int shared_samples = 4;
  bool filter_artefacts = false;  ///< pen-down / pen-up filter before the fit (PenFilter)
  PenFilterOptions filter;
  WidthMapOptions width_map = kPenWidths;
  WidthFitOptions width;
  std::string medium = StrokeData{}.medium;  ///< medium of the stroke
};

/// A chain of joined cubics fitted to samples.
struct FittedCurve {
  std::vector<Point> points;      ///< 3n + 1 control points; empty before the first segment
  std::vector<JointKind> joints;  ///< n - 1 kinds of the inner joints
  /// For each sample that the n segments cover, in order: its parameter u = segment index + t on
  /// the curve. The parameters never decrease, and the curve at u lies within the tolerance of the
  /// sample.
  std::vector<double> sample_u;

  [[nodiscard]] int segment_count() const noexcept {
    return points.empty() ? 0 : static_cast<int>(points.size() / 3);
  }
  [[nodiscard]] Cubic segment(int i) const noexcept {
    const auto k = static_cast<std::size_t>(3 * i);
    return {{points[k], points[k + 1], points[k + 2], points[k + 3]}};
  }

  friend bool operator==(const FittedCurve&, const FittedCurve&) = default;
};

/// The position on a curve that `count` consecutive samples share.
struct SamplePlace {
  double u = 0.0;
  std::uint32_t count = 0;
};

}  // namespace felt
