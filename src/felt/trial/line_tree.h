#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/geometry/polyline.h"

namespace felt {

/// Finds the nearest of many straight lines: a tree of boxes, split at the median.
class LineTree {
 public:
  struct Line {
    Point a, b;
  };

  /// Takes n log n time. Requires finite points.
  explicit LineTree(std::vector<Line> lines);

  /// Returns the point nearest to p; `index` is the index of its line. If several lines have the
  /// same distance, returns the first. Infinitely far if there are no lines.
  [[nodiscard]] PolylineNearest nearest(Point p) const noexcept;

 private:
  static constexpr std::uint32_t kLeafLines = 4;
  struct Node {
    Point low, high;
    std::uint32_t begin = 0, end = 0;  // in order_
    std::uint32_t right = 0;           // the left child is the next node; 0: a leaf
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);
  [[nodiscard]] double distance_squared_to(const Node& node, Point p) const noexcept;
  void search_leaf(const Node& node, Point p, PolylineNearest& best) const noexcept;

  std::vector<Line> lines_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace felt
