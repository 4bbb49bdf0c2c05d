#include "felt/render/stroke_grid.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr int kFinest = 2;  // squares of 4 mm
constexpr int kCoarsest = 62;

std::int64_t column(double mm, int level) noexcept {
  // Columns beyond the range of 64-bit integers are merged into the outermost one.
  constexpr double kFarthest = 4e18;
  return static_cast<std::int64_t>(
      std::floor(std::clamp(std::ldexp(mm, -level), -kFarthest, kFarthest)));
}

void find_in(const StrokeCell& cell, const Rect& area, std::vector<const SceneStroke*>& found) {
  for (const SceneStroke* stroke : cell.strokes) {
    if (area.intersects(stroke->box)) found.push_back(stroke);
  }
}

}  // namespace

int StrokeGrid::level_of(const Rect& box) noexcept {
  int exponent = 0;
  std::frexp(std::max(box.width(), box.height()), &exponent);  // the size is below 2^exponent
  return std::clamp(exponent, kFinest, kCoarsest);
}

StrokeGrid::Place StrokeGrid::place_of(const Rect& box, int level) noexcept {
  return {column(0.5 * (box.y0 + box.y1), level), column(0.5 * (box.x0 + box.x1), level)};
}

void StrokeGrid::add(SceneStroke& stroke) {
  const int level = level_of(stroke.box);
  StrokeCell& cell = levels_[level].cells[place_of(stroke.box, level)];
  stroke.cell = &cell;
  stroke.cell_slot = cell.strokes.size();
  cell.strokes.push_back(&stroke);
}

void StrokeGrid::remove(SceneStroke& stroke) {
  auto& strokes = stroke.cell->strokes;
  strokes[stroke.cell_slot] = strokes.back();
  strokes[stroke.cell_slot]->cell_slot = stroke.cell_slot;
  strokes.pop_back();
  if (strokes.empty()) {
    const int level = level_of(stroke.box);
    const auto found = levels_.find(level);
    found->second.cells.erase(place_of(stroke.box, level));
    if (found->second.cells.empty()) levels_.erase(found);
  }
  stroke.cell = nullptr;
}

void StrokeGrid::find(const Rect& area, std::vector<const SceneStroke*>& found) const {
  for (const auto& [level, squares] : levels_) {
    const auto& cells = squares.cells;
    // A stroke extends beyond its square by at most half a square. The coarsest level also contains
    // larger strokes, so all its squares are searched.
    const bool is_all = level == kCoarsest;
    const Rect reach = area.inflated(std::ldexp(0.5, level));
    const std::int64_t y0 = column(reach.y0, level), y1 = column(reach.y1, level);
    const std::int64_t x0 = column(reach.x0, level), x1 = column(reach.x1, level);
    const double rows = static_cast<double>(y1) - static_cast<double>(y0) + 1.0;
    if (is_all || rows > static_cast<double>(cells.size())) {
      for (const auto& [place, cell] : cells) find_in(cell, area, found);
      continue;
    }
    for (std::int64_t y = y0; y <= y1; ++y) {
      for (auto at = cells.lower_bound({y, x0}); at != cells.end() && at->first <= Place{y, x1};
           ++at) {
        find_in(at->second, area, found);
      }
    }
  }
}

}  // namespace felt
