#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "felt/geometry/point.h"

namespace felt {

/// One pen sample of a trial.
struct TrialSample {
  std::int64_t time_ns = 0;
  Point position{};  ///< mm on the page
  bool contact = false;
  std::optional<double> height_mm{};  ///< above the surface, negative below; nullopt if unknown
  std::optional<double> pressure{};   ///< 0..1; nullopt if the device does not sense it
  /// The force in the page plane that was sent to the device, N; nullopt without a force device.
  std::optional<Vec> force_n{};
};

/// The largest component of a force and the largest pressure that `measure_trial` accepts.
inline constexpr double kMaxTrialForceN = 1e6;

enum class TrialPathEnds : std::uint8_t {
  kOpen,
  kClosed,  ///< the last point is joined to the first, which may be repeated at the end
};

/// The task of a trial, besides its path.
struct TrialGeometry {
  TrialPathEnds ends = TrialPathEnds::kOpen;
  /// The width of the tunnel around the path; ignored unless it is finite and positive.
  std::optional<double> tunnel_width_mm{};
  /// The diameter of the target around the end of a straight path; ignored unless it is finite and
  /// positive.
  std::optional<double> target_width_mm{};
};

/// The metrics of one trial. `trial_metric_columns()` has the unit, formula and source of each. A
/// metric is nullopt if the trial does not define it, for example `steering_id` without a tunnel.
struct TrialMetrics {
  using Value = std::optional<double>;

  // Samples
  Value samples, samples_ignored;
  // Time
  Value reaction_s, movement_s, in_air_s, lifts;
  // Lengths and speed
  Value path_length_mm, ink_length_mm, speed_mean_mm_per_s, steering_id;
  // Accuracy
  Value err_mean_mm, err_rms_mm, err_p95_mm, err_max_mm, err_total_mm, frechet_mm, err_signed_mm,
      direction_err_deg, area_mm2, coverage, out_of_tunnel_share;
  // Movement along a straight path (MacKenzie, Kauppinen, Silfverberg 2001)
  Value target_reentries, axis_crossings, direction_changes, orthogonal_changes,
      movement_variability_mm, movement_error_mm, movement_offset_mm;
  // Smoothness
  Value velocity_peaks_per_s, sparc, log_dimensionless_jerk, power_law_exponent, power_law_r2,
      power_share_3_12_hz;
  // Tasks: the end of a closed path, and what became of the ink (ink_metrics.h)
  Value end_gap_mm, is_closed, width_mean_mm, width_err_mm, width_cv, erased_extra_mm,
      erased_left_mm, erased_wrong_lines;
  // Force and pressure
  Value force_mean_n, force_impulse_n_s, work_mj, force_above_half_n_share, pressure_mean,
      pressure_cv;
};

/// Returns the metrics of one trial.
///
/// Ignores a sample if a number in it is not finite or out of range (kMaxCoordinateMm,
/// kMaxTrialForceN), or if it is not later than the last sample that was not ignored. Ignores
/// points of the path that are not finite or out of range. Returns a result for every input; where
/// a path retraces itself, the sign of an error is arbitrary.
///
/// Takes (n + m) log(n + m) time for n samples and m points of the path, if the distances between
/// ink and path are short compared with their extents; in the worst case n (m + kMaxPathSteps). The
/// Fréchet distance compares at most kMaxFrechetPoints points of each line, and smoothness uses at
/// most the first kMaxSmoothnessS seconds.
TrialMetrics measure_trial(std::span<const TrialSample> samples, std::span<const Point> path,
                           const TrialGeometry& geometry = {});

/// The distance between the points of the path whose distance to the ink is measured. They are
/// exactly equally far apart, at most this far, except on paths longer than 10 m.
inline constexpr double kPathStepMm = 0.5;
inline constexpr int kMaxPathSteps = 20'000;
inline constexpr int kMaxFrechetPoints = 256;
/// The length of ink whose direction is compared with that of the path.
inline constexpr double kDirectionStepMm = 1.0;
/// A point of the path is covered if ink is at most this far away.
inline constexpr double kCoverageMm = 1.0;
inline constexpr double kMaxSmoothnessS = 300.0;
/// Shorter movements have no measures of smoothness.
inline constexpr double kMinSmoothnessS = 0.6;

}  // namespace felt
