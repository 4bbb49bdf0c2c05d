#pragma once

#include <memory>
#include <optional>

#include "felt/stroke/arc_map.h"
#include "felt/tools/scene.h"

namespace felt {

/// Tracks the point of a stroke under the pen, for tools that work along a stroke
/// (docs/design/editing.md#nearest-point). All strokes are searched once. After that the point is
/// tracked along the arc, so that the pen stays on the branch on which it started if a stroke
/// crosses itself.
///
///   hold.take(scene, pen);        // hover, touch
///   hold.follow(scene, pen);      // each further sample of the gesture
///
/// Use it on the edit thread only.
class StrokeHold {
 public:
  /// Maximum distance of the pen from the stroke, mm. A pen that is farther away has no effect
  /// (R20).
  static constexpr double kReachMm = 8.0;
  /// The next point is searched for within this arc length of the last point, plus twice the
  /// distance that the pen has moved.
  static constexpr double kWindowMm = 5.0;

  /// The point of the stroke under the pen.
  struct Place {
    double u = 0.0;
    double length_mm = 0.0;  ///< arc length from the start of the stroke
    Point point;
  };

  /// Holds the editable stroke nearest to the pen, or none if no stroke is within kReachMm. Returns
  /// holds(). If the stroke is not the one held before, takes time linear in its segments.
  bool take(const Scene& scene, Point pen);
  /// Follows the pen along the held stroke. Returns false, and keeps the point, while the pen is
  /// too far away. If the pen comes back elsewhere on the stroke, tracking continues there.
  /// Requires holds().
  bool follow(const Scene& scene, Point pen);
  void release() noexcept;

  [[nodiscard]] bool holds() const noexcept { return stroke_ != nullptr; }
  /// This and all following functions require holds().
  [[nodiscard]] StrokeId id() const noexcept { return id_; }
  [[nodiscard]] const StrokePtr& stroke() const noexcept { return stroke_; }
  [[nodiscard]] const ArcMap& map() const noexcept { return *map_; }
  [[nodiscard]] const Place& place() const noexcept { return place_; }
  /// Returns the signed arc length from the previous point to this one (ArcMap::way), or nullopt if
  /// there is no previous point or the pen was too far away.
  [[nodiscard]] std::optional<double> way_mm() const noexcept { return way_mm_; }

 private:
  [[nodiscard]] double find_near(Point pen, double window_mm, double& u) const noexcept;
  void go_to(double u) noexcept;

  StrokeId id_;
  StrokePtr stroke_;
  std::unique_ptr<ArcMap> map_;  // refers to *stroke_
  Place place_;
  Point pen_;
  bool is_near_ = false;
  std::optional<double> way_mm_;
};

}  // namespace felt
