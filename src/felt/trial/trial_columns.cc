#include "felt/trial/trial_columns.h"

#include <array>
#include <charconv>

namespace felt {
namespace {

using M = TrialMetrics;

constexpr TrialColumn kTrialColumns[] = {
    {"samples", "1", "Number of valid samples.", "", &M::samples},
    {"samples_ignored", "1",
     "Number of samples that were ignored because they are invalid or out of order.", "",
     &M::samples_ignored},
    {"reaction_s", "s", "Time from the first sample to the first contact.", "", &M::reaction_s},
    {"movement_s", "s", "Time from the first to the last sample in contact.", "", &M::movement_s},
    {"in_air_s", "s", "Time without contact between the first and the last contact.", "",
     &M::in_air_s},
    {"lifts", "1", "Number of times that the pen was lifted and came down again.", "", &M::lifts},
    {"path_length_mm", "mm", "Length of the path.", "", &M::path_length_mm},
    {"ink_length_mm", "mm", "Sum of the distances between successive samples in contact.", "",
     &M::ink_length_mm},
    {"speed_mean_mm_per_s", "mm/s", "ink_length_mm divided by the time in contact.", "",
     &M::speed_mean_mm_per_s},
    {"steering_id", "1",
     "Index of difficulty of steering: path_length_mm divided by the width of the tunnel.",
     "10.1145/258549.258760", &M::steering_id},
    {"err_mean_mm", "mm",
     "Mean of two means: of the distances from the samples in contact to the path, and from points "
     "of the path (every 0.5 mm) to the ink.",
     "10.1109/ICPR.1994.576361", &M::err_mean_mm},
    {"err_rms_mm", "mm",
     "Square root of the mean of the two mean squared distances, from the samples to the path and "
     "from the path to the ink.",
     "10.1109/ICPR.1994.576361", &M::err_rms_mm},
    {"err_p95_mm", "mm",
     "Larger of the two 95 % quantiles of the distances (linear interpolation, type 7), from the "
     "samples to the path and from the path to the ink.",
     "10.2307/2684934", &M::err_p95_mm},
    {"err_max_mm", "mm",
     "Hausdorff distance: the largest distance from a sample to the path or from a point of the "
     "path to the ink.",
     "10.1109/34.232073", &M::err_max_mm},
    {"err_total_mm", "mm",
     "Mean distance in space from the samples in contact to the path, if the path is at the median "
     "height of these samples; a pen that sinks into a surface made by forces is at the surface; "
     "empty "
     "without a haptic device.",
     "10.1145/3025453.3025474", &M::err_total_mm},
    {"frechet_mm", "mm",
     "Discrete Fréchet distance of at most 256 points at equal distances on the path and on the "
     "ink; the smaller one of both directions of the path; a closed path begins at its point "
     "nearest to the first sample.",
     "10.1142/S0218195995000064", &M::frechet_mm},
    {"err_signed_mm", "mm",
     "Mean signed distance of the samples in contact from the path, positive to the right of its "
     "direction; beyond the ends of an open path, the distance from its last line extended.",
     "10.1109/TVCG.2005.49", &M::err_signed_mm},
    {"direction_err_deg", "deg",
     "Mean angle, 0 to 90, between pieces of ink of at most 1 mm and the path at the point nearest "
     "to the middle of the piece, weighted by length.",
     "", &M::direction_err_deg},
    {"area_mm2", "mm^2",
     "Integral of the distance to the path over the length of the ink (trapezoidal rule).", "",
     &M::area_mm2},
    {"coverage", "1",
     "Share of the points of the path (every 0.5 mm) that have ink at most 1 mm away.", "",
     &M::coverage},
    {"out_of_tunnel_share", "1",
     "Share of the samples in contact that are farther from the path than half the width of the "
     "tunnel.",
     "10.1145/258549.258760", &M::out_of_tunnel_share},
    {"target_reentries", "1",
     "TRE: number of times that the pen enters the target around the end of a straight path, after "
     "the first time.",
     "10.1145/365024.365028", &M::target_reentries},
    {"axis_crossings", "1",
     "TAC: number of times that the samples in contact cross the axis of a straight path.",
     "10.1145/365024.365028", &M::axis_crossings},
    {"direction_changes", "1",
     "MDC: number of changes of sign of the movement across the axis of a straight path.",
     "10.1145/365024.365028", &M::direction_changes},
    {"orthogonal_changes", "1",
     "ODC: number of changes of sign of the movement along the axis of a straight path.",
     "10.1145/365024.365028", &M::orthogonal_changes},
    {"movement_variability_mm", "mm",
     "MV: standard deviation (n - 1) of the signed distances of the samples in contact from the "
     "axis of a straight path.",
     "10.1145/365024.365028", &M::movement_variability_mm},
    {"movement_error_mm", "mm",
     "ME: mean distance of the samples in contact from the axis of a straight path.",
     "10.1145/365024.365028", &M::movement_error_mm},
    {"movement_offset_mm", "mm",
     "MO: mean signed distance of the samples in contact from the axis of a straight path, "
     "positive to the right.",
     "10.1145/365024.365028", &M::movement_offset_mm},
    {"velocity_peaks_per_s", "1/s",
     "Number of peaks of the smoothed speed that rise at least 2 % of the largest speed above the "
     "lows beside them, per second of the movement.",
     "10.1109/WHC.2007.13", &M::velocity_peaks_per_s},
    {"sparc", "1",
     "Spectral arc length: minus the length of the normalized amplitude spectrum of the smoothed "
     "speed up to the highest frequency below 10 Hz with at least 5 % of the largest amplitude.",
     "10.1186/s12984-015-0090-9", &M::sparc},
    {"log_dimensionless_jerk", "1",
     "LDLJ: -ln of the integral of the squared jerk times duration cubed, divided by the largest "
     "speed squared; positions smoothed.",
     "10.1186/s12984-015-0090-9", &M::log_dimensionless_jerk},
    {"power_law_exponent", "1",
     "Slope of the regression of ln(speed) on ln(curvature), both of the smoothed movement; about "
     "-1/3 for the two-thirds power law.",
     "10.1016/0001-6918(83)90027-6", &M::power_law_exponent},
    {"power_law_r2", "1", "Coefficient of determination of the regression of power_law_exponent.",
     "10.1016/0001-6918(83)90027-6", &M::power_law_r2},
    {"power_share_3_12_hz", "1",
     "Share of the power of the velocity (without its mean, Hann window, not smoothed) at 3 to 12 "
     "Hz, where most tremor is.",
     "10.1002/mds.870131303", &M::power_share_3_12_hz},
    {"end_gap_mm", "mm",
     "Distance between the first and the last sample in contact, if the path is closed.", "",
     &M::end_gap_mm},
    {"is_closed", "1",
     "Task close: 1 if every end of a line of ink is at most 0.01 mm from another end, otherwise "
     "0.",
     "", &M::is_closed},
    {"width_mean_mm", "mm",
     "Task width: mean width of the ink at points of its lines (at most every 0.5 mm), without the "
     "first and the last 5 mm of each line.",
     "", &M::width_mean_mm},
    {"width_err_mm", "mm",
     "Task width: mean absolute difference between the width at these points and the required "
     "width.",
     "", &M::width_err_mm},
    {"width_cv", "1",
     "Task width: standard deviation (n - 1) of the width at these points, divided by their mean.",
     "", &M::width_cv},
    {"erased_extra_mm", "mm",
     "Task erase: length of the ink that was erased although it was not meant: of the line beyond "
     "the two lines that cross it, and of all other lines.",
     "", &M::erased_extra_mm},
    {"erased_left_mm", "mm",
     "Task erase: length of the ink between the two lines that was not erased.", "",
     &M::erased_left_mm},
    {"erased_wrong_lines", "1",
     "Task erase: number of other lines that have lost more than 0.1 mm of ink.", "",
     &M::erased_wrong_lines},
    {"force_mean_n", "N", "force_impulse_n_s divided by its time.", "", &M::force_mean_n},
    {"force_impulse_n_s", "N s",
     "Integral over the movement of the magnitude of the force in the page plane (trapezoidal "
     "rule).",
     "", &M::force_impulse_n_s},
    {"work_mj", "mJ",
     "Work of the device on the hand in the page plane: integral of force times displacement "
     "(trapezoidal rule); positive if the device pushes the hand forwards.",
     "", &M::work_mj},
    {"force_above_half_n_share", "1",
     "Share of the time of the movement in which the force in the page plane exceeds 0.5 N.", "",
     &M::force_above_half_n_share},
    {"pressure_mean", "1", "Mean pressure of the samples in contact.", "", &M::pressure_mean},
    {"pressure_cv", "1",
     "Standard deviation (n - 1) of the pressure of the samples in contact, divided by their mean.",
     "", &M::pressure_cv},
};

}  // namespace

std::span<const TrialColumn> trial_metric_columns() noexcept {
  return kTrialColumns;
}

std::string trial_metric_text(const TrialMetrics::Value& value) {
  if (!value) return "NA";
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), *value).ptr;
  return {text.data(), end};
}

}  // namespace felt
