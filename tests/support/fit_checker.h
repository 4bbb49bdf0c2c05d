#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tests/support/fit_plane.h"

/// Checks curve fits, those of Feltline and of other programs. It shares no code with the fitters.
///
/// It measures for each stroke:
///   error      the distance from each input sample, including repeated ones, to the nearest point
///              of the whole fitted curve;
///   breaks     joints at which the tangent turns although they are not declared corners;
///   kinks      positions at which the curve turns like a corner that is not declared: by
///              60 degrees within an arc length of a quarter of a tolerance;
///   overshoot  the largest distance from the curve to the input polyline. It finds loops and
///              spikes between samples, which the error does not show;
///   corners    the angle by which the ink itself turns at each declared corner.
namespace fit_check {

/// The samples of one stroke, in mm.
struct Ink {
  std::string id;
  std::string source;
  std::vector<Point> samples;
};

/// The curve fitted to the samples of one stroke.
struct FitCurve {
  std::string id;
  bool closed = false;
  std::vector<Segment> segments;
  /// True for each joint that is declared a corner. Joint i follows segment i. A curve of n
  /// segments has n - 1 joints, or n if it is closed. If values are missing, these joints are
  /// smooth.
  std::vector<bool> corners;
};

/// Limits in degrees: if the tangent turns by more at an undeclared joint, the joint is a break.
inline constexpr std::array kBreakDeg{1e-3, 5.0, 30.0};
/// Arm lengths, in tolerances, with which the turn of the ink at a declared corner is measured.
inline constexpr std::array kArmInTolerances{2.0, 4.0, 8.0};
/// Smallest turns that a declared corner ought to have, in degrees.
inline constexpr std::array kCornerDeg{45.0, 50.0, 60.0};
/// Maximum distance between a declared corner and the turn of the ink, in tolerances. One tolerance
/// is the allowed error of the curve; the second is needed because the sample with the largest turn
/// may not be the nearest one.
inline constexpr double kCornerReachInTolerances = 2.0;
/// A curve may be this many tolerances plus the sample gap away from the ink. The sample gap is the
/// length of the nearest line of the ink, or of another line at the same part of the curve.
inline constexpr double kOvershootInTolerances = 4.0;

/// The results for one stroke or, after `add`, for several.
struct Report {
  int strokes = 0;
  std::int64_t samples = 0;
  std::int64_t segments = 0;

  double max_error = 0.0;
  double error_sum = 0.0;
  int over_tolerance = 0;  ///< strokes with an error above the tolerance
  std::string worst_id;    ///< stroke with the largest error

  int invalid = 0;              ///< strokes without segments or with a number that is not finite
  int missing = 0;              ///< strokes that have ink but no curve
  int degenerate_segments = 0;  ///< segments with four equal points
  double max_gap = 0.0;         ///< largest gap between a segment's end and the next one's start
  std::array<int, kBreakDeg.size()> breaks{};
  double max_smooth_turn_deg = 0.0;
  std::string most_broken_id;
  int kinks = 0;

  /// Overshoot of each stroke, in the order of the calls of `add`.
  std::vector<double> overshoots;
  std::string overshoot_id;
  double overshoot_excess = -1e300;  ///< largest overshoot - 4 tolerances - sample gap
  std::string excess_id;
  int overshoot_violations = 0;  ///< strokes with a positive excess

  int corners = 0;
  /// weak_corners[arm][limit] is the number of declared corners at which the ink turns by less than
  /// kCornerDeg[limit], measured with arms of kArmInTolerances[arm].
  std::array<std::array<int, kCornerDeg.size()>, kArmInTolerances.size()> weak_corners{};
  int corners_near_end = 0;   ///< corners at most 2 tolerances from an end of the ink
  int corners_bend_less = 0;  ///< declared corners where the curve itself turns by under 5 degrees

  void add(const Report& other);
  [[nodiscard]] double mean_error() const;
  [[nodiscard]] double max_overshoot() const;
  /// Returns the overshoot that a share of `fraction` of the strokes does not exceed.
  [[nodiscard]] double overshoot_quantile(double fraction) const;
  /// Returns true if every guarantee holds: the curves are valid, complete, without gaps, within
  /// the tolerance, G1 outside declared corners, and the overshoot is bounded.
  [[nodiscard]] bool clean() const;
};

/// Checks one stroke. Requires tolerance > 0. An invalid curve gets an infinite error.
Report check_stroke(const Ink& ink, const FitCurve& curve, double tolerance);

/// Checks many strokes. Curves are matched with their ink by id, or by their order if no curve has
/// an id.
Report check_all(const std::vector<Ink>& inks, const std::vector<FitCurve>& curves,
                 double tolerance, std::map<std::string, Report>* by_source = nullptr);

}  // namespace fit_check
