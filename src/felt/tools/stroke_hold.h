#pragma once

#include <memory>
#include <optional>

#include "felt/stroke/arc_map.h"
#include "felt/tools/scene.h"

namespace felt {

/// A stroke that a brush works along, and the place on it under the pen (specification 5c,
/// "tracking"): found among all strokes once, then followed along the arc, so that a pen that rubs
/// where a stroke passes itself stays on the branch that it took hold of.
///
///   hold.take(scene, pen);        // hover, touch
///   hold.follow(scene, pen);      // each further sample of the gesture
///
/// Edit thread only.
class StrokeHold {
 public:
  /// Farther from the stroke a pen does nothing (R20).
  static constexpr double kReachMm = 8.0;
  /// The place is looked for within this way along the stroke of the last one, and as far again as
  /// the pen has moved.
  static constexpr double kWindowMm = 5.0;

  /// The place under the pen.
  struct Place {
    double u = 0.0;
    double length_mm = 0.0;  ///< from the start of the stroke, along it
    Point point;
  };

  /// Takes the stroke under the pen, if there is one within kReachMm that may be edited; else lets
  /// go. True when it holds one. Linear in its segments when it is another than before.
  bool take(const Scene& scene, Point pen);
  /// Follows the pen along the stroke that is held. False while the pen is too far away; the place
  /// then stays. When it comes back elsewhere on the stroke, the place is there. Requires holds().
  bool follow(const Scene& scene, Point pen);
  void release() noexcept;

  [[nodiscard]] bool holds() const noexcept { return stroke_ != nullptr; }
  /// Requires holds(), as everything below.
  [[nodiscard]] StrokeId id() const noexcept { return id_; }
  [[nodiscard]] const StrokePtr& stroke() const noexcept { return stroke_; }
  [[nodiscard]] const ArcMap& map() const noexcept { return *map_; }
  [[nodiscard]] const Place& place() const noexcept { return place_; }
  /// Way along the stroke from the place before to this one, signed (ArcMap::way); nothing when the
  /// pen came from elsewhere or was away.
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
