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

/// A stroke being ironed. The result is a pure function of the stroke at the touch and of the total
/// dose at each place. The order and the number of portions in which a dose is added do not matter.
///
/// A dose d removes waves shorter than wave_mm sqrt(1 - exp(-d)) (JerkFilter): first the fine
/// jitter, then longer and longer waves. A bend of mean curvature c is itself a wave of length 2
/// pi/c, so waves longer than kBendShare times this length are never removed. Therefore the radius
/// of a circle changes by at most 0.02 % per gesture. Kept corners and ends do not move. Places
/// without a dose do not move.
class Ironing {
 public:
  static constexpr double kBendShare = 0.24;
  /// The value of kBendShare at ends and kept corners. It is smaller because the filter is
  /// one-sided there and changes long waves more.
  static constexpr double kEndBendShare = 0.05;
  /// Minimum change that makes an edit, mm. A pen does not resolve smaller changes, and the errors
  /// of the fits would add up if smooth ink were ironed repeatedly.
  static constexpr double kMinMm = 0.02;

  /// `stroke` and `map` must outlive this object.
  Ironing(const Stroke& stroke, const ArcMap& map, const IronOptions& options);

  /// Irons at an arc length of the stroke: each place nearer than `reach_mm` along the stroke gets
  /// the dose `dose` * bump(distance / reach_mm) * inflation, with bump() of brush_bump.h and the
  /// inflation of the place. Takes time linear in the reach.
  void add(double length_mm, double reach_mm, double dose);
  /// Returns the roughness of the ink around an arc length, mm: the rms distance within `reach_mm`
  /// between the ink as ironed so far and fully ironed ink, minus kSmoothMm, at least 0. Takes time
  /// linear in reach_mm + wave_mm.
  [[nodiscard]] double roughness_mm(double length_mm, double reach_mm);
  /// Filters the places that got a dose since the last call, with a margin of kMarginWaves times
  /// wave_mm on both sides. Beyond the margin the effect is invisible. Takes time linear in those
  /// places, plus a fast loop over all places.
  void catch_up();
  /// Returns the stroke as of the last catch_up() for display, or nullopt if nothing has moved. It
  /// has many segments and is exact within 0.01 mm; only changed parts are refitted.
  [[nodiscard]] std::optional<Stroke> shown();
  /// Returns the final stroke from all doses, or nullopt if nothing has moved. It has as few
  /// segments as the fit finds within the tolerance.
  [[nodiscard]] std::optional<Stroke> finished();

  static constexpr double kSmoothMm = 0.01;
  static constexpr double kMarginWaves = 0.5;

 private:
  struct Run {
    int first, last;  // first and last place
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
