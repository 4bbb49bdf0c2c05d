#pragma once

#include <vector>

#include "felt/fill/document_map.h"
#include "felt/geometry/rect.h"
#include "felt/tools/scene.h"

namespace felt {

/// Returns true if fills of the layer may be added and changed.
inline bool can_fill_in(const Layer& layer) noexcept {
  return layer.visible && !layer.locked;
}

/// The areas that one gesture has reached, and the edit that fills them. The document and the map
/// must not change while it is used.
class FillGesture {
 public:
  /// Starts a gesture; null as `map`: no area can be found. If `removes` is true, it removes the
  /// fills that it reaches.
  FillGesture(const Scene& scene, FillMap* map, double gap_mm, bool removes);

  /// Looks for a fill, or an area without one, at a point. Returns true if it is a new one.
  bool visit(Point p, const Scene& scene);
  /// Returns the edit. Areas are filled with the colour of the scene, and fills get it. If the
  /// gesture has reached nothing but one fill of this colour, the edit removes it.
  [[nodiscard]] Edit edit(const Scene& scene) const;
  /// Returns the area at a point that visit() has reached, or null.
  [[nodiscard]] const Fill* area_at(Point p) const;

  [[nodiscard]] bool is_empty() const noexcept { return targets_.empty(); }
  [[nodiscard]] bool removes() const noexcept { return removes_; }
  /// Returns the bridges that close gaps of the new fills.
  [[nodiscard]] const std::vector<TipLink>& bridges() const noexcept { return bridges_; }

 private:
  struct Target {
    FillId id;  ///< zero: a new fill
    FillPtr fill;
    Rect box;
  };

  static const Target* find(const std::vector<Target>& targets, Point p);

  FillMap* map_;
  double gap_mm_;
  bool removes_;
  std::vector<Target> present_;  // the fills of all open layers, the highest first
  std::vector<Target> targets_;
  std::vector<TipLink> bridges_;
};

}  // namespace felt
