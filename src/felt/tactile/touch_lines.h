#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/document/edit.h"
#include "felt/geometry/rect.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A point of a line, as a fingertip meets it.
struct TouchPoint {
  Point at{};
  double half_mm = 0.0;  ///< half of the width of the ink
  /// Arc length from the start of the line. Trips into pointed corners and corners of flat ends
  /// have no length, because they are part of the line that they end or bend.
  double along_mm = 0.0;
  std::uint32_t line = 0;  ///< index of its line
};

/// A stroke as points at most kStepMm apart.
struct TouchLine {
  static constexpr double kStepMm = 0.25;

  StrokeId stroke{};
  bool is_closed = false;
  double length_mm = 0.0;
  double mean_width_mm = 0.0;  ///< by length; the width of a dot
  Rect bounds{};               ///< of the ink
  std::size_t first = 0;       ///< of its points
  std::size_t count = 0;

  /// Returns the length of the path along the line between two of its points.
  [[nodiscard]] double path_mm(double a_mm, double b_mm) const noexcept;
};

/// The lines of a drawing with all their points, line by line.
struct TouchLines {
  std::vector<TouchLine> lines;
  std::vector<TouchPoint> points;

  void add(StrokeId id, const Stroke& stroke);
  [[nodiscard]] std::span<const TouchPoint> points_of(const TouchLine& line) const noexcept {
    return std::span(points).subspan(line.first, line.count);
  }
};

/// Finds the points near a position. Keeps a reference to the points.
class TouchGrid {
 public:
  /// Requires cell_mm > 0.
  TouchGrid(std::span<const TouchPoint> points, double cell_mm);

  /// Calls `visit(index)` for every point in the 3 x 3 cells around a position: at least those
  /// within cell_mm.
  template <typename Visit>
  void visit_near(Point at, Visit&& visit) const {
    const Cell middle = cell_of(at);
    for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
      const auto [from, to] = row(y, middle.x - 1, middle.x + 1);
      for (std::size_t i = from; i < to; ++i) visit(entries_[i].point);
    }
  }

 private:
  struct Cell {
    std::int64_t y, x;
    friend auto operator<=>(const Cell&, const Cell&) = default;
  };
  struct Entry {
    Cell cell;
    std::uint32_t point;
  };
  [[nodiscard]] Cell cell_of(Point at) const noexcept;
  [[nodiscard]] std::pair<std::size_t, std::size_t> row(std::int64_t y, std::int64_t x0,
                                                        std::int64_t x1) const noexcept;

  double cell_mm_;
  std::vector<Entry> entries_;  // ordered by cell
};

}  // namespace felt
