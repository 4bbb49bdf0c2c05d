#include "felt/document/unindexed_strokes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace felt {
namespace {

constexpr double kSmallestCellMm = 32.0;
constexpr double kCellGrowth = 4.0;
/// How far a stroke can reach beyond its cell, in cells: half a cell, and a margin for rounding.
constexpr double kReachCells = 0.51;

double cell_mm(std::size_t grid) noexcept {
  return kSmallestCellMm * std::pow(kCellGrowth, static_cast<double>(grid));
}

}  // namespace

/// Returns nullopt if the stroke is too large for every grid.
std::optional<UnindexedStrokes::Place> UnindexedStrokes::place_of(const Stroke& stroke) noexcept {
  Rect box;
  for (const Point& p : stroke.data().points) box.extend(p);
  const double side = std::max(box.width(), box.height());
  std::size_t grid = 0;
  double cell = kSmallestCellMm;
  for (; !(side <= cell); cell *= kCellGrowth) {
    if (++grid == kGrids) return std::nullopt;
  }
  const Point middle{0.5 * box.x0 + 0.5 * box.x1, 0.5 * box.y0 + 0.5 * box.y1};
  return Place{grid, grid_cell(middle, cell)};
}

bool UnindexedStrokes::add(const Entry& entry) {
  const std::optional<Place> place = place_of(*entry.stroke);
  if (!place) return false;
  grids_[place->grid][place->cell].push_back(entry);
  ++size_;
  return true;
}

UnindexedStrokes::Grid::iterator UnindexedStrokes::move(Grid& grid, Grid::iterator cell,
                                                        std::vector<Entry>& taken) {
  std::vector<Entry>& entries = cell->second;
  size_ -= entries.size();
  std::move(entries.begin(), entries.end(), std::back_inserter(taken));
  return grid.erase(cell);
}

void UnindexedStrokes::take(const Rect& area, std::vector<Entry>& taken) {
  if (!(area.x0 <= area.x1 && area.y0 <= area.y1)) return;
  for (std::size_t i = 0; i < kGrids && size_ > 0; ++i) {
    Grid& grid = grids_[i];
    const double cell = cell_mm(i);
    for_each_cell_in(grid, area.inflated(kReachCells * cell), cell,
                     [&](Grid::iterator at) { return move(grid, at, taken); });
  }
}

void UnindexedStrokes::take_around(const Stroke& stroke, std::vector<Entry>& taken) {
  if (size_ == 0) return;
  const std::optional<Place> place = place_of(stroke);
  if (!place) return;
  Grid& grid = grids_[place->grid];
  const auto found = grid.find(place->cell);
  if (found != grid.end()) move(grid, found, taken);
}

}  // namespace felt
