#pragma once

#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Moves points along the rays from a centre, up to a distance from it
/// (docs/design/editing.md#bulge). With d the vector from the centre to a point, x = |d| /
/// radius_mm and w the influence of brush_reach.h:
///
///   p -> centre + (1 + gain w(x)) d
///
/// A positive gain spreads the points (a bulge), a negative one draws them to the centre (a pinch).
/// From the radius on, nothing moves, and the map is continuously differentiable there. Within
/// kMinGain to kMaxGain it maps no two points to the same one.
struct RadialMap {
  static constexpr double kMinGain = -0.8, kMaxGain = 1.2;

  Point centre;
  double radius_mm = 20.0;  ///< positive
  double gain = 0.0;        ///< kMinGain to kMaxGain

  [[nodiscard]] Point operator()(Point p) const noexcept;
  /// Returns the derivative of the map at p in the direction v.
  [[nodiscard]] Vec derivative(Point p, Vec v) const noexcept;
  /// Returns true if p is where the map moves points.
  [[nodiscard]] bool reaches(Point p) const noexcept {
    return distance_squared(p, centre) < radius_mm * radius_mm;
  }
};

/// Bulges or pinches one stroke. The constructor divides the stroke where it crosses the circle,
/// and within it until one cubic can approximate the mapped piece. Each piece of the result has the
/// mapped positions and derivatives at its ends, so smooth joints stay smooth, and the result
/// depends on the gain alone (R23, R24). Ink outside the circle stays the same bit for bit, except
/// between the circle and a joint that is nearer to it than kMinSegmentMm.
class BulgePull {
 public:
  /// Prepares a stroke for gains between 0 and map.gain. Takes linear time in its segments. The ink
  /// of at() is within a fifth of the tolerance of the mapped ink, except in cusps and tiny loops.
  /// The points at the parameters `fixed`, where other strokes end on this one, are mapped exactly.
  BulgePull(StrokePtr snapshot, const RadialMap& map, double tolerance_mm,
            std::span<const double> fixed = {});

  /// Returns false if the circle does not reach the stroke.
  [[nodiscard]] bool moves() const noexcept { return moves_; }
  /// Returns the stroke mapped with another gain, or exactly the snapshot for 0. A segment that
  /// would become shorter than I5 allows keeps handles of 0.03 mm.
  [[nodiscard]] Result<Stroke> at(double gain) const;
  /// Returns the stroke to commit: the same with as few segments as the tolerance allows.
  [[nodiscard]] Result<Stroke> finished(double gain) const;

 private:
  void divide(const std::vector<double>& us);
  void mark();
  [[nodiscard]] std::vector<double> crossings() const;
  [[nodiscard]] std::vector<double> crooked() const;
  [[nodiscard]] bool is_fixed(Point joint) const noexcept;
  [[nodiscard]] Cubic segment(std::size_t i) const noexcept;

  StrokePtr snapshot_;
  RadialMap map_;
  double tolerance_mm_;
  StrokeData base_;             // the snapshot, divided
  std::vector<Point> fixed_;    // positions of joints of base_ that finished() must not move
  std::vector<bool> is_moved_;  // by segment
  bool moves_ = false;
};

}  // namespace felt
