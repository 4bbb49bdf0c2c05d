#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// A rough line: the points of its path, in mm.
using RoughLine = std::vector<Point>;

/// Cross-sections of rough lines: at the middle of every step of every line, a straight line across
/// it, and the other lines that it crosses. Strips of strokes are measured on such sections, as in
/// StrokeAggregator (doi:10.1145/3197517.3201314) and StrokeStrip (doi:10.1145/3450626.3459777).

/// A line that a section crosses.
struct SectionHit {
  std::uint32_t line = 0;
  double offset_mm = 0.0;  ///< signed distance from the section's point, positive towards perp()
  double along_mm = 0.0;   ///< arc length of the crossing, from the first point of `line`
  /// Cosine of the angle between both lines: 1 for the same direction, -1 for opposite directions.
  double cosine = 1.0;
};

/// One section: a point of a line, and the lines on both sides of it.
struct LineSection {
  std::uint32_t line = 0;
  double along_mm = 0.0;  ///< arc length of the point, from the first point of `line`
  Point point;
  Vec normal;  ///< unit vector across the line: perp() of its direction
  /// The hits on each side (negative and positive offsets), from the nearest to the farthest.
  std::span<const SectionHit> below, above;
};

/// Settings of the sections.
struct SectionOptions {
  double step_mm = 1.0;   ///< distance of the sections along a line; > 0
  double reach_mm = 8.0;  ///< length of a section to each side; > 0
  /// Smallest absolute cosine of a hit: lines at larger angles belong to no strip.
  double min_cosine = 0.866;
  /// A section keeps the nearest hits on each side, at most so many, because the lines in between
  /// connect those that are farther away. This bounds the work in dense drawings.
  std::size_t max_hits = 16;
  /// A line crosses its own sections if the arc length in between exceeds this; in mm.
  double own_mm = 1e300;
};

/// Lines, resampled at equal distances and sorted into a grid for sections. A line that is shorter
/// than four steps gets four steps, a longer one at most 4,000.
class LineGrid {
 public:
  /// Requires finite points in range (is_in_range). Lines may be empty or points.
  LineGrid(std::span<const RoughLine> lines, const SectionOptions& options);

  /// Calls `visit` for the sections of line i, in order along the line. A line without length has
  /// no sections. Valid during the call only.
  void sections(std::uint32_t i, const std::function<void(const LineSection&)>& visit) const;

  /// Returns the resampled points of line i; empty if the line has no length.
  [[nodiscard]] std::span<const Point> points(std::uint32_t i) const noexcept { return lines_[i]; }

  /// How much work the sections of all lines take.
  struct Crowd {
    std::uint64_t tests = 0;  ///< tests of a piece against a section, within the section's cell
    Point densest;            ///< a point in the cell that holds the most pieces
  };
  /// Returns the work of sections(), before it is done. Takes time proportional to the cells.
  [[nodiscard]] Crowd crowd() const noexcept;

  [[nodiscard]] double length_mm(std::uint32_t i) const noexcept { return lengths_[i]; }

 private:
  struct Piece {
    std::uint32_t line, index;  ///< from point `index` of the line to the next one
  };
  struct Ray;
  [[nodiscard]] int column(double x) const noexcept;
  [[nodiscard]] int row(double y) const noexcept;
  template <class Visit>
  void cells_of(std::uint32_t line, std::uint32_t index, const Visit& visit) const;
  void fill_cells();
  void collect(const Ray& ray, std::vector<SectionHit>& hits) const;
  void test_cell(const Ray& ray, int cell, std::vector<SectionHit>& hits) const;

  SectionOptions options_;
  std::vector<RoughLine> lines_;
  std::vector<double> lengths_;
  Rect box_;
  double cell_mm_ = 1.0;
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> begins_;  // of each cell in pieces_
  std::vector<Piece> pieces_;
};

}  // namespace felt
