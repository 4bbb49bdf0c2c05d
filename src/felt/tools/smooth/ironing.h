#pragma once

#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/tools/smooth/iron_places.h"
#include "felt/tools/smooth/ironed_stroke.h"
#include "felt/tools/smooth/jerk_filter.h"

namespace felt {

/// What ironing does to a stroke.
struct IronOptions {
  /// The longest wave that goes when the iron stays long enough, mm.
  double wave_mm = 10.0;
  bool smooth_corners = false;
  /// Of the fit at the end.
  double tolerance_mm = 0.05;
};

/// A stroke under the iron: a pure function of the stroke at the touch and of the dose that each
/// place has got since. The order does not matter, nor into how many portions a dose was cut.
///
/// With a dose d, waves shorter than  wave_mm sqrt(1 - exp(-d))  go (JerkFilter), so first the fine
/// jitter goes, then longer and longer waves. A bend of mean curvature c is a wave of length 2 pi/c
/// itself: waves longer than kBendShare of that are never taken away, hence a circle of any radius
/// keeps it within 0.02 % a time. Corners that are kept and ends stay where they are; without a
/// dose nothing moves.
class Ironing {
 public:
  static constexpr double kBendShare = 0.24;
  /// The same at ends and corners that stay, where the filter has one side only and is less flat.
  static constexpr double kEndBendShare = 0.05;
  /// Less than this is no edit, mm: a pen does not resolve it, and fits that follow each other on
  /// smooth ink would add up.
  static constexpr double kLeastMm = 0.02;

  /// Both must outlive this.
  Ironing(const Stroke& stroke, const ArcMap& map, const IronOptions& options);

  /// The iron stands at a length along the stroke: places within `reach_mm` of it get
  /// dose S(way/reach). Bounded by the reach.
  void add(double length_mm, double reach_mm, double dose);
  /// How rough the ink is around a place, mm: rms of what is still to be ironed out within
  /// `reach_mm`, of which kSmoothMm count as nothing. Bounded by the reach.
  [[nodiscard]] double roughness_mm(double length_mm, double reach_mm);
  /// Irons what got a dose since the last time, with kMarginWaves to both sides, beyond which it
  /// makes no difference that could be seen. Bounded by what got a dose, but for a quick look.
  void catch_up();
  /// The stroke as ironed at the last catch_up(), in many segments, within a hundredth of a
  /// millimetre, to be shown; only where it changed it is fitted anew. Nothing when nothing has
  /// moved.
  [[nodiscard]] std::optional<Stroke> shown();
  /// The same from all doses at once, in as few segments as are found within the tolerance.
  [[nodiscard]] std::optional<Stroke> finished();

  static constexpr double kSmoothMm = 0.01;
  static constexpr double kMarginWaves = 0.5;

 private:
  struct Run {
    int first, last;  // places; these two stay, or are ends of the stroke
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
  std::vector<double> longest_;  // wave at each place that may go, mm; NaN: not asked for yet
  std::vector<Point> ironed_;    // where dosed
  std::vector<char> is_new_;     // blocks that got a dose since they were ironed
  IronedBlocks blocks_;
  JerkFilter filter_;
  std::vector<FilterPlace> row_;
  std::vector<Point> out_;
};

}  // namespace felt
