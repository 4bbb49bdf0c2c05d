#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tests/support/fit_plane.h"

/// The judge of curve fits, ours and the peers' alike. It shares no code with what it judges.
///
/// Per stroke it measures
///   error      distance from each input sample, repeated ones included, to the nearest point of
///              the whole fitted curve;
///   breaks     joints that are not declared corners where the tangent turns;
///   kinks      places that are as good as a corner without being declared one: 60 degrees of
///              turning within a quarter of a tolerance of arc;
///   overshoot  largest distance from the curve back to the input polyline: finds the loops and
///              spikes between samples that the error cannot see;
///   corners    for each declared corner, how much the ink itself turns there.
namespace fit_check {

/// The samples of one stroke, in mm.
struct Ink {
  std::string id;
  std::string source;
  std::vector<Point> samples;
};

/// The curve fitted to them.
struct FitCurve {
  std::string id;
  bool closed = false;
  std::vector<Segment> segments;
  /// For each joint, whether it is declared a corner. Joint i follows segment i; n - 1 of them,
  /// n when closed. Missing ones are smooth.
  std::vector<bool> corners;
};

/// Tangent turns above which an undeclared joint is a break, degrees.
inline constexpr std::array kBreakDeg{1e-3, 5.0, 30.0};
/// Arm lengths at which the ink's turn at a declared corner is measured, in tolerances.
inline constexpr std::array kArmInTolerances{2.0, 4.0, 8.0};
/// Turns that a declared corner ought to have, degrees.
inline constexpr std::array kCornerDeg{45.0, 50.0, 60.0};
/// How far from the declared corner the ink may have its turn, in tolerances: the curve is allowed
/// one, and the sample that turns most need not be the nearest.
inline constexpr double kCornerReachInTolerances = 2.0;
/// A curve may leave the ink by this many tolerances plus the sample gap there: the length of the
/// ink's line that it is nearest to, or of one that belongs to the same stretch of the curve.
inline constexpr double kOvershootInTolerances = 4.0;

/// What was found. Sums of reports are reports: `add`.
struct Report {
  int strokes = 0;
  std::int64_t samples = 0;
  std::int64_t segments = 0;

  double max_error = 0.0;
  double error_sum = 0.0;
  int over_tolerance = 0;  ///< strokes
  std::string worst_id;    ///< stroke with the largest error

  int invalid = 0;              ///< strokes without segments or with a number that is not finite
  int missing = 0;              ///< strokes that have ink and no curve
  int degenerate_segments = 0;  ///< all four points equal
  double max_gap = 0.0;         ///< between the end of a segment and the start of the next
  std::array<int, kBreakDeg.size()> breaks{};
  double max_smooth_turn_deg = 0.0;
  std::string most_broken_id;
  int kinks = 0;

  /// Per stroke, in the order of `add`.
  std::vector<double> overshoots;
  std::string overshoot_id;
  double overshoot_excess = -1e300;  ///< largest of overshoot - 4 tolerances - sample gap
  std::string excess_id;
  int overshoot_violations = 0;  ///< strokes with a positive excess

  int corners = 0;
  /// [arm][limit]: declared corners at which the ink turns by less.
  std::array<std::array<int, kCornerDeg.size()>, kArmInTolerances.size()> weak_corners{};
  int corners_near_end = 0;   ///< an arm of 4 tolerances meets the ink's end within half of it
  int corners_bend_less = 0;  ///< declared corners where the curve itself turns by under 5 degrees

  void add(const Report& other);
  [[nodiscard]] double mean_error() const;
  [[nodiscard]] double max_overshoot() const;
  /// The value that `fraction` of the strokes do not exceed.
  [[nodiscard]] double overshoot_quantile(double fraction) const;
  /// Every guarantee kept: valid, complete, joined, within tolerance, G1 outside declared corners,
  /// overshoot bounded.
  [[nodiscard]] bool clean() const;
};

/// Judges one stroke. Requires tolerance > 0. An invalid curve gets an infinite error.
Report check_stroke(const Ink& ink, const FitCurve& curve, double tolerance);

/// Judges many; curves find their ink by id, or by order when no curve has an id.
Report check_all(const std::vector<Ink>& inks, const std::vector<FitCurve>& curves,
                 double tolerance, std::map<std::string, Report>* by_source = nullptr);

}  // namespace fit_check
