#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "felt/geometry/rect.h"

namespace felt {

/// Row and column of a square cell of a grid over the page.
using CellAddress = std::pair<std::int64_t, std::int64_t>;
/// The non-empty cells, row by row.
template <class Entry>
using CellGrid = std::map<CellAddress, std::vector<Entry>>;

/// Returns the row or column of a coordinate. The result is clamped to -10^12 .. 10^12, so that the
/// outermost rows and columns contain everything beyond them.
inline std::int64_t grid_line(double mm, double cell_mm) noexcept {
  constexpr double kLastLine = 1e12;
  return static_cast<std::int64_t>(std::clamp(std::floor(mm / cell_mm), -kLastLine, kLastLine));
}

inline CellAddress grid_cell(Point p, double cell_mm) noexcept {
  return {grid_line(p.y, cell_mm), grid_line(p.x, cell_mm)};
}

/// Calls visit(iterator) for every non-empty cell that meets the area. `visit` returns the iterator
/// of the next cell, so that it may erase the current cell. Even for a huge area, this takes no
/// longer than visiting all non-empty cells.
template <class Cells, class Visit>
void for_each_cell_in(Cells& cells, const Rect& area, double cell_mm, Visit visit) {
  const auto [top, left] = grid_cell({area.x0, area.y0}, cell_mm);
  const auto [bottom, right] = grid_cell({area.x1, area.y1}, cell_mm);
  auto cell = cells.lower_bound({top, left});
  while (cell != cells.end() && cell->first.first <= bottom) {
    const auto [row, column] = cell->first;
    if (column > right) {
      cell = cells.lower_bound({row + 1, left});
    } else if (column < left) {
      cell = cells.lower_bound({row, left});
    } else {
      cell = visit(cell);
    }
  }
}

}  // namespace felt
