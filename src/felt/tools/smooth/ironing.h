#pragma once

#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/tools/smooth/iron_places.h"
#include "felt/tools/smooth/ironed_stroke.h"
#include "felt/tools/smooth/jerk_filter.h"

namespace felt {

/// Options of ironing.
struct IronOptions {
  /// Longest wave that is removed if the iron stays long enough, mm.
  double wave_mm = 10.0;
  bool smooth_corners = false;
  /// Tolerance of the final fit, mm.
  double tolerance_mm = 0.05;
};

/// A stroke being ironed: a pure function of the stroke at the touch and of the total dose at each
/// place. The order and the number of portions of a dose do not matter.
///
/// A dose d removes waves shorter than wave_mm sqrt(1 - exp(-d)) (JerkFilter): first the fine
/// jitter, then longer and longer waves. A bend of mean curvature c is itself a wave of length 2
/// pi/c, so waves longer than kBendShare of that are never removed; therefore a circle of any
/// radius keeps it within 0.02 % each time. Kept corners and ends do not move; without a dose
/// nothing moves.
class Ironing {
 public:
  static constexpr double kBendShare = 0.24;
  /// Same at ends and kept corners, where the filter is one-sided and less flat.
  static constexpr double kEndBendShare = 0.05;
  /// Smaller changes are not an edit, mm, because a pen does not resolve them and repeated fits on
  /// smooth ink would add up.
  static constexpr double kMinMm = 0.02;

  /// `stroke` and `map` must outlive this object.
  Ironing(const Stroke& stroke, const ArcMap& map, const IronOptions& options);

  /// Irons at an arc length of the stroke: places at a distance below `reach_mm` along it get dose
  /// S(distance/reach), times their inflation. Linear in the reach.
  void add(double length_mm, double reach_mm, double dose);
  /// Returns the roughness of the ink around an arc length, mm: the rms distance still to be ironed
  /// out within `reach_mm`, less kSmoothMm, at least 0. Linear in the reach plus wave_mm.
  [[nodiscard]] double roughness_mm(double length_mm, double reach_mm);
  /// Filters the places that got a dose since the last call, with a margin of kMarginWaves to both
  /// sides, beyond which the effect is invisible. Linear in those places, plus a quick scan.
  void catch_up();
  /// Returns the stroke as of the last catch_up() for display: in many segments, within 0.01 mm;
  /// only changed parts are refitted. Nullopt if nothing has moved.
  [[nodiscard]] std::optional<Stroke> shown();
  /// Returns the final stroke from all doses, in as few segments as are found within the tolerance.
  /// Nullopt if nothing has moved.
  [[nodiscard]] std::optional<Stroke> finished();

  static constexpr double kSmoothMm = 0.01;
  static constexpr double kMarginWaves = 0.5;

 private:
  struct Run {
    int first, last;  // places; both stay, or are ends of the stroke
  };

  [[nodiscard]] double weight_of(int k, double share);
  [[nodiscard]] bool is_dosed(int k) const noexcept { return doses_[index(k)] > 0.0; }
  [[nodiscard]] bool is_new(int k) const noexcept {
    return is_new_[index(k) / IronedBlocks::kPlaces] != 0;
  }
  [[nodiscard]] std::size_t index(int k) const noexcept {
    return static_cast<std::size_t>(places_.wrapped(k));
  }
  void catch_up_all_around();
  void catch_up_stretches(int start);
  void filter_new(Run scanned, Run row);
  void filter_row(Run row, Run kept);
  [[nodiscard]] bool has_moved() const;
  [[nodiscard]] std::vector<Run> runs() const;
  std::optional<Stroke> build(std::vector<Run>& joints, IronedStroke::Detail detail);

  const Stroke& stroke_;
  const ArcMap& map_;
  IronOptions options_;
  IronPlaces places_;
  std::vector<double> doses_;
  std::vector<double> longest_;  // longest wave to remove at each place, mm; NaN: not computed yet
  std::vector<Point> ironed_;    // valid where doses_ > 0
  std::vector<char> is_new_;     // by block: got a dose since the last catch_up()
  IronedBlocks blocks_;
  JerkFilter filter_;
  std::vector<FilterPlace> row_;
  std::vector<Point> out_;
};

}  // namespace felt
