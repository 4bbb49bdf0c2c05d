#pragma once

#include <map>
#include <vector>

#include "felt/tools/scene.h"

namespace felt {

/// A stroke near the path of a brush, as points, and how far the brush has moved along each point.
struct BrushedStroke {
  StrokePtr stroke;
  LayerId layer;
  /// At nearly equal distances. A closed stroke has its seam once, as the first point.
  std::vector<Point> points;
  std::vector<double> us;        ///< parameters of the points
  std::vector<Vec> directions;   ///< unit tangents, averaged over half of the radius
  std::vector<double> along_mm;  ///< length of brush path in whose reach the point was, and along
                                 ///< which the stroke runs there
  std::vector<double> sense_mm;  ///< the same; path against the direction of the stroke is negative
};

/// The path of a brush, and the editable strokes that came within its radius.
///
/// The path advances in steps of kStepShare of the radius, so the result does not depend on the
/// sample rate. The direction of the brush is that of its last kDirectionSteps steps. Takes time
/// linear in the points of the strokes near the path for each step.
class BrushPath {
 public:
  static constexpr double kStepShare = 0.25;
  static constexpr std::size_t kDirectionSteps = 4;
  /// A stroke runs along the brush if its angle to it has at least this cosine (37 degrees).
  static constexpr double kMinCosine = 0.8;

  /// Starts a path. Requires radius_mm > 0.
  BrushPath(Point pen, double radius_mm) : radius_mm_(radius_mm), nodes_{pen} {}

  /// Moves the brush. Returns true if it has made a step. The document must stay the same.
  bool move(Point pen, const Scene& scene);

  [[nodiscard]] double radius_mm() const noexcept { return radius_mm_; }
  /// Returns the unit direction of the brush; 0 before the first step.
  [[nodiscard]] Vec direction() const noexcept { return direction_; }
  [[nodiscard]] const std::map<StrokeId, BrushedStroke>& strokes() const noexcept {
    return strokes_;
  }

 private:
  void step_to(Point node, const Scene& scene);
  [[nodiscard]] BrushedStroke sampled(const Scene& scene, StrokeId id) const;

  double radius_mm_;
  std::vector<Point> nodes_;  // the last ones of the path
  Vec direction_;
  std::map<StrokeId, BrushedStroke> strokes_;
};

}  // namespace felt
