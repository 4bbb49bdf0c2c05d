#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "felt/document/cell_grid.h"
#include "felt/document/edit.h"

namespace felt {

/// The strokes of a large document that StrokeIndex has not sorted yet, because no query or edit
/// has come near them. Sorting 10^6 strokes into trees takes seconds, so StrokeIndex only puts them
/// into coarse grids when a document is opened, and sorts a stroke when a query or an edit comes
/// near it.
///
/// Each size class of strokes has its own grid, with cells four times as large as those of the next
/// smaller class. A stroke is stored in the cell that contains its middle, and reaches at most half
/// a cell beyond that cell. Not thread-safe.
class UnindexedStrokes {
 public:
  struct Entry {
    StrokeId id;
    LayerId layer;
    StrokePtr stroke;
  };

  /// Adds a stroke. Returns false, and adds nothing, if it is too large for every grid.
  bool add(const Entry& entry);
  /// Moves to `taken` every stroke with a curve that may intersect `area`, and some other strokes
  /// near the area.
  void take(const Rect& area, std::vector<Entry>& taken);
  /// Moves the strokes that share a cell with `stroke` to `taken`.
  void take_around(const Stroke& stroke, std::vector<Entry>& taken);
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

 private:
  using Grid = CellGrid<Entry>;
  struct Place {
    std::size_t grid = 0;
    CellAddress cell;
  };
  static constexpr std::size_t kGrids = 8;

  [[nodiscard]] static std::optional<Place> place_of(const Stroke& stroke) noexcept;
  Grid::iterator move(Grid& grid, Grid::iterator cell, std::vector<Entry>& taken);

  std::array<Grid, kGrids> grids_;
  std::size_t size_ = 0;
};

}  // namespace felt
