#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/cubic.h"

namespace felt {

/// A closed polygon; the last point is joined to the first.
using Ring = std::vector<Point>;

/// Whether the edges of the border become shorter towards inner corners, where the heights are not
/// smooth (docs/design/solids.md#mesh).
enum class InnerCorners : std::uint8_t { kGraded, kPlain };

/// The lengths that decide how the outline of a body is sampled, in mm.
struct RingSpec {
  double edge_mm = 1.0;        ///< the longest edge of the border
  double tolerance_mm = 0.01;  ///< the largest distance of the border from the outline
  double tip_mm = 0.01;        ///< tips are cut off where they are narrower than this
  /// A bend of the border turns by at most this at each of its points, unless its edges become
  /// shorter than `min_edge_mm`.
  double max_turn_rad = 0.14;
  double min_edge_mm = 0.1;
  InnerCorners inner_corners = InnerCorners::kGraded;
};

/// Returns a polygon that follows the curves within a twentieth of the tolerance, with edges of at
/// most a third of an edge of the border. Points nearer to each other than half of `tip_mm` become
/// one, and tips are cut off where they are narrower than `tip_mm`, because the coordinates of a
/// file could not tell their sides apart. Empty if less than a triangle is left.
Ring fine_ring(std::span<const Cubic> curve, const RingSpec& spec);

/// Returns a part of a polygon with few points: those that Douglas-Peucker keeps, and more of the
/// line between them where an edge would be too long or the line bends, and towards inner corners:
/// those that turn to the right, as the area is at the left of the line. The ends are kept.
std::vector<Point> border_points(std::span<const Point> line, const RingSpec& spec);

/// Tells whether a point is near one of many straight edges. Each cell of a grid lists the edges
/// within the reach of its points.
class EdgeGrid {
 public:
  struct Edge {
    Point a, b;
  };

  /// Sorts the edges into cells. Requires reach_mm > 0.
  EdgeGrid(std::vector<Edge> edges, double reach_mm);

  /// Returns true if the distance of p from an edge is at most the reach.
  [[nodiscard]] bool is_near(Point p) const;
  /// Returns the indices of two edges that cross or touch and do not share an end bit for bit; two
  /// equal indices if there are none.
  [[nodiscard]] std::pair<std::size_t, std::size_t> crossing() const;

  [[nodiscard]] const std::vector<Edge>& edges() const noexcept { return edges_; }

 private:
  [[nodiscard]] std::size_t column(double x) const;
  [[nodiscard]] std::size_t row(double y) const;

  std::vector<Edge> edges_;
  double reach_mm_;
  Point corner_;
  double cell_mm_ = 1.0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace felt
