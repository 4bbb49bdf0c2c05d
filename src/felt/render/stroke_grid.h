#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "felt/render/scene_stroke.h"

namespace felt {

/// Finds the strokes in a rectangle. Each size class of strokes has its own grid of squares. Each
/// stroke is in one square that is at least as large as the stroke. Adding and removing take
/// logarithmic time; finding takes linear time in the number of strokes found and of nearby
/// squares.
class StrokeGrid {
 public:
  /// Adds a stroke. Its `box` must not change until the stroke is removed.
  void add(SceneStroke& stroke);
  void remove(SceneStroke& stroke);
  /// Appends the strokes whose boxes share a point with the area, in unspecified order.
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
