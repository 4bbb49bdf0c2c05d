#pragma once

#include <vector>

#include "felt/stroke/arc_map.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Places about 0.25 mm apart along a stroke, evenly between the corners that are kept, numbered 0
/// to count(). On a closed stroke place count() is place 0, the seam. Points are worked out when
/// they are first asked for.
class IronPlaces {
 public:
  static constexpr double kSpacingMm = 0.25;
  /// A corner is kept when the ink turns by more than this between arms of this length along it:
  /// at what tremor makes it does not.
  static constexpr double kCornerDeg = 30.0;
  static constexpr double kCornerArmMm = 3.0;

  /// Both must outlive this. Without `keep_corners` no corner is kept.
  IronPlaces(const Stroke& stroke, const ArcMap& map, bool keep_corners);

  [[nodiscard]] int count() const noexcept { return static_cast<int>(lengths_.size()) - 1; }
  [[nodiscard]] bool closed() const noexcept { return stroke_.closed(); }
  [[nodiscard]] double length_at(int k) const noexcept {
    return lengths_[static_cast<std::size_t>(k)];
  }
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
  void add_span(double from_mm, double to_mm);
  [[nodiscard]] bool is_corner_at(int joint) const;
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
