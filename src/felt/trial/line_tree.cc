#include "felt/trial/line_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace felt {

LineTree::LineTree(std::vector<Line> lines) : lines_(std::move(lines)), order_(lines_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!lines_.empty()) build(0, static_cast<std::uint32_t>(lines_.size()));
}

std::uint32_t LineTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node node{.low = lines_[order_[begin]].a, .high = lines_[order_[begin]].a};
  node.begin = begin;
  node.end = end;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const Point p : {lines_[order_[i]].a, lines_[order_[i]].b}) {
      node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y)};
      node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y)};
    }
  }
  nodes_.push_back(node);
  if (end - begin <= kLeafLines) return index;

  const bool wide = node.high.x - node.low.x > node.high.y - node.low.y;
  const auto key = [&](std::uint32_t i) {
    const Line& line = lines_[i];
    return wide ? line.a.x + line.b.x : line.a.y + line.b.y;
  };
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  nodes_[index].right = right;
  return index;
}

double LineTree::distance_squared_to(const Node& node, Point p) const noexcept {
  const Point inside{std::clamp(p.x, node.low.x, node.high.x),
                     std::clamp(p.y, node.low.y, node.high.y)};
  return distance_squared(inside, p);
}

void LineTree::search_leaf(const Node& node, Point p, PolylineNearest& best) const noexcept {
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    const std::size_t index = order_[i];
    const LineNearest hit = nearest_on_line(lines_[index].a, lines_[index].b, p);
    const bool ties = hit.distance_squared == best.distance_squared && index < best.index;
    if (hit.distance_squared < best.distance_squared || ties)
      best = {index, hit.t, hit.distance_squared, hit.point};
  }
}

PolylineNearest LineTree::nearest(Point p) const noexcept {
  PolylineNearest best;
  best.distance_squared = std::numeric_limits<double>::infinity();
  if (nodes_.empty()) return best;
  // The depth is at most 32, because each node has half the lines of its parent.
  std::array<std::pair<double, std::uint32_t>, 64> open{};
  std::size_t count = 0;
  open[count++] = {distance_squared_to(nodes_[0], p), 0};
  while (count > 0) {
    const auto [near, index] = open[--count];
    if (near > best.distance_squared) continue;
    const Node& node = nodes_[index];
    if (node.right == 0) {
      search_leaf(node, p, best);
      continue;
    }
    std::pair first{distance_squared_to(nodes_[index + 1], p), index + 1};
    std::pair second{distance_squared_to(nodes_[node.right], p), node.right};
    if (second.first < first.first) std::swap(first, second);
    open[count++] = second;
    open[count++] = first;
  }
  return best;
}

}  // namespace felt
