#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "felt/render/scene_stroke.h"

namespace felt {

/// Finds the strokes of a rectangle: squares of the sheet, as many sizes of them as there are sizes
/// of strokes, each stroke in one square that is at least as large as it. Adding and removing is
/// logarithmic, finding linear in what is found and in the squares around.
class StrokeGrid {
 public:
  /// By its `box`, which must not change while it is in here.
  void add(SceneStroke& stroke);
  void remove(SceneStroke& stroke);
  /// Appends those whose boxes share a point with the area, in no useful order.
  void find(const Rect& area, std::vector<const SceneStroke*>& found) const;

 private:
  using Place = std::pair<std::int64_t, std::int64_t>;  // row, column
  struct Level {
    std::map<Place, StrokeCell> cells;
  };

  static int level_of(const Rect& box) noexcept;
  static Place place_of(const Rect& box, int level) noexcept;

  std::map<int, Level> levels_;  // level n has squares of 2^n mm
};

}  // namespace felt
