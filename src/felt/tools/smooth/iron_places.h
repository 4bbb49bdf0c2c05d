#pragma once

#include <vector>

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Sample positions ("places") along the smoothed path of a stroke, numbered 0 to count(). They are
/// about 0.25 mm apart and evenly spaced between the kept corners. On a closed stroke, place
/// count() is the same as place 0, the seam. Points are computed on first use.
///
/// The smoothed path ("way") is the ink with its jitter averaged out. Jittery ink is up to twice as
/// long as its path. If doses (ironing.h) were measured along the arc of the ink, jittery ink would
/// be ironed only half as much. For smooth ink both lengths are the same.
class IronPlaces {
 public:
  static constexpr double kSpacingMm = 0.25;
  /// A corner is kept if the ink turns by more than kCornerDeg in two measurements: over
  /// kCornerArmMm and over kLongArmMm of ink to each side. Corners made by tremor do not pass this
  /// test.
  static constexpr double kCornerDeg = 30.0;
  static constexpr double kCornerArmMm = 3.0;
  static constexpr double kLongArmMm = 4.5;
  /// Corners that alternately turn left and right come from a shaky hand and are not kept. They are
  /// removed if each corner is within kShakeLengthMm of the next one, measured along the ink, and
  /// within kShakeHeightMm of the straight line between its two neighbours.
  static constexpr double kShakeLengthMm = 8.0;
  static constexpr double kShakeHeightMm = 2.0;
  /// Length of ink over which the smoothed path is averaged.
  static constexpr double kGuideMm = 3.0;
  /// Maximum ratio of ink length to path length; greater ratios are reduced to this value. They
  /// come from small loops, which are not jitter.
  static constexpr double kMaxInflation = 2.5;

  /// `stroke` and `map` must outlive this object. If `keep_corners` is false, no corner is kept.
  IronPlaces(const Stroke& stroke, const ArcMap& map, bool keep_corners);

  [[nodiscard]] int count() const noexcept { return static_cast<int>(lengths_.size()) - 1; }
  [[nodiscard]] bool closed() const noexcept { return stroke_.closed(); }
  [[nodiscard]] double length_at(int k) const noexcept {
    return lengths_[static_cast<std::size_t>(k)];
  }
  /// Returns the ratio of ink length to path length around a place, 1 (smooth ink) to
  /// kMaxInflation.
  [[nodiscard]] double inflation(int k) const noexcept;
  /// Returns the place nearest to an arc length on the stroke.
  [[nodiscard]] int nearest(double length_mm) const noexcept;
  /// Returns k wrapped to 0..count()-1 on a closed stroke, or clamped to 0..count() on an open one.
  [[nodiscard]] int wrapped(int k) const noexcept;
  [[nodiscard]] double u(int k) const;
  [[nodiscard]] Point point(int k) const;
  /// Returns true for kept corners and the ends of an open stroke.
  [[nodiscard]] bool is_fixed(int k) const noexcept { return fixed_[static_cast<std::size_t>(k)]; }
  /// Returns the arc length to the nearest fixed place, at most max_mm.
  [[nodiscard]] double from_fixed_mm(int k, double max_mm) const noexcept;
  /// Returns the mean curvature within half of `window_mm` on both sides of a place, 1/mm. It is
  /// the total turn divided by the length, so that tremor, which turns left and right, cancels out.
  [[nodiscard]] double mean_curvature(int k, double window_mm) const;

 private:
  /// A point on the ink by arc length, with the path length from the start of its span.
  struct Step {
    double length_mm, way_mm;
  };
  [[nodiscard]] std::vector<Step> steps_between(int from_joint, int to_joint) const;
  void add_span(int from_joint, int to_joint);
  /// Returns the joints from 1 to n - 1 that are kept as corners.
  [[nodiscard]] std::vector<int> corners() const;
  [[nodiscard]] bool is_corner_at(int joint) const;
  [[nodiscard]] bool turns_at(int joint, double arm_mm) const;
  /// Returns true if the line goes on behind the corner as before it: within kShakeLengthMm it
  /// leaves its direction by at most kShakeHeightMm and comes back.
  [[nodiscard]] bool is_spike(int joint) const;
  [[nodiscard]] double turn(int k) const;

  const Stroke& stroke_;
  const ArcMap& map_;
  std::vector<double> lengths_;
  std::vector<bool> fixed_;
  mutable std::vector<double> us_;     // NaN: not computed yet
  mutable std::vector<double> turns_;  // NaN: not computed yet
  mutable std::vector<Point> points_;
};

}  // namespace felt
