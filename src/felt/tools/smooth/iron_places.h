#pragma once

#include <vector>

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Places about 0.25 mm apart along the way of a stroke, evenly between the corners that are kept,
/// numbered 0 to count(). On a closed stroke place count() is place 0, the seam. Points are worked
/// out when they are first asked for.
///
/// The way is what is left of the ink when jitter is averaged out: ink that jitters is up to twice
/// as long as its way, and would be ironed half as much were its own arc the measure. Where ink is
/// smooth both are the same.
class IronPlaces {
 public:
  static constexpr double kSpacingMm = 0.25;
  /// A corner is kept when the ink turns by more than this between arms of this length along it,
  /// the shorter ones and the longer ones: at what tremor makes it does not.
  static constexpr double kCornerDeg = 30.0;
  static constexpr double kCornerArmMm = 3.0;
  static constexpr double kLongArmMm = 4.5;
  /// Corners that turn to and fro, each within this length along the ink of the next one and this
  /// near to the line between its two neighbours, are what a shaky hand makes: none of them is
  /// kept.
  static constexpr double kShakeLengthMm = 8.0;
  static constexpr double kShakeHeightMm = 2.0;
  /// Averaged over so much of the ink for the way.
  static constexpr double kGuideMm = 3.0;
  /// The ink is taken to be at most so many times as long as its way: small loops are no jitter.
  static constexpr double kMostInflation = 2.5;

  /// Both must outlive this. Without `keep_corners` no corner is kept.
  IronPlaces(const Stroke& stroke, const ArcMap& map, bool keep_corners);

  [[nodiscard]] int count() const noexcept { return static_cast<int>(lengths_.size()) - 1; }
  [[nodiscard]] bool closed() const noexcept { return stroke_.closed(); }
  [[nodiscard]] double length_at(int k) const noexcept {
    return lengths_[static_cast<std::size_t>(k)];
  }
  /// Ink per way around a place, 1 where it is smooth, to kMostInflation.
  [[nodiscard]] double inflation(int k) const noexcept;
  /// The place nearest to a length on the stroke.
  [[nodiscard]] int nearest(double length_mm) const noexcept;
  /// Number within 0..count()-1 of a place of a closed stroke beyond its ends; of an open one, the
  /// place itself, held at the ends.
  [[nodiscard]] int wrapped(int k) const noexcept;
  [[nodiscard]] double u(int k) const;
  [[nodiscard]] Point point(int k) const;
  /// True for a corner that is kept and for the ends of an open stroke.
  [[nodiscard]] bool is_fixed(int k) const noexcept { return fixed_[static_cast<std::size_t>(k)]; }
  /// Way to the nearest fixed place, most_mm at most.
  [[nodiscard]] double from_fixed_mm(int k, double most_mm) const noexcept;
  /// Mean curvature around a place within half of `window_mm` to both sides, 1/mm: how much the ink
  /// turns in all. Tremor turns to and fro.
  [[nodiscard]] double mean_curvature(int k, double window_mm) const;

 private:
  /// A place on the ink by its length, and the way up to there from the start of its span.
  struct Step {
    double length_mm, way_mm;
  };
  [[nodiscard]] std::vector<Step> steps_between(int from_joint, int to_joint) const;
  void add_span(int from_joint, int to_joint);
  /// Joints 1 to n - 1 that are kept as corners.
  [[nodiscard]] std::vector<int> corners() const;
  [[nodiscard]] bool is_corner_at(int joint) const;
  [[nodiscard]] bool turns_at(int joint, double arm_mm) const;
  [[nodiscard]] double turn(int k) const;

  const Stroke& stroke_;
  const ArcMap& map_;
  std::vector<double> lengths_;
  std::vector<bool> fixed_;
  mutable std::vector<double> us_;     // NaN: not asked for yet
  mutable std::vector<double> turns_;  // likewise
  mutable std::vector<Point> points_;
};

}  // namespace felt
