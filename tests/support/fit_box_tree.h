#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "tests/support/fit_plane.h"

namespace fit_check {

/// An axis-parallel box; the default one is empty.
struct Box {
  double x0 = std::numeric_limits<double>::infinity();
  double y0 = std::numeric_limits<double>::infinity();
  double x1 = -std::numeric_limits<double>::infinity();
  double y1 = -std::numeric_limits<double>::infinity();

  void extend(const Box& o) {
    x0 = std::min(x0, o.x0);
    y0 = std::min(y0, o.y0);
    x1 = std::max(x1, o.x1);
    y1 = std::max(y1, o.y1);
  }
};

/// Returns the box of the straight line from a to b, extended by `margin` on all sides.
inline Box box_of_line(Point a, Point b, double margin = 0.0) {
  return {std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::max(a.x, b.x) + margin,
          std::max(a.y, b.y) + margin};
}

/// Returns the smallest distance from p to the box.
inline double distance_to_box(const Box& b, Point p) {
  const double dx = std::max({b.x0 - p.x, 0.0, p.x - b.x1});
  const double dy = std::max({b.y0 - p.y, 0.0, p.y - b.y1});
  return std::sqrt(dx * dx + dy * dy);
}

/// A tree of boxes over items that are consecutive along a path. Each box of a level covers four
/// neighbours of the level below. A search visits the nearest boxes first and skips those beyond
/// the bound, so it never misses an item within the bound.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> items) {
    levels_.push_back(std::move(items));
    while (levels_.back().size() > 1) {
      const std::vector<Box>& below = levels_.back();
      std::vector<Box> level((below.size() + kFan - 1) / kFan);
      for (std::size_t i = 0; i < below.size(); ++i) level[i / kFan].extend(below[i]);
      levels_.push_back(std::move(level));
    }
  }

  /// Calls `bound = visit(item)` for every item whose box is at most `bound` away from p; near
  /// items come first. `visit` gets an index and returns the bound for the rest of the search.
  template <class Visit>
  void search(Point p, double bound, Visit&& visit) const {
    if (!levels_.front().empty()) descend(levels_.size() - 1, 0, p, bound, visit);
  }

 private:
  static constexpr std::size_t kFan = 4;

  template <class Visit>
  void descend(std::size_t level, std::size_t node, Point p, double& bound, Visit& visit) const {
    if (level == 0) {
      bound = visit(node);
      return;
    }
    const std::vector<Box>& below = levels_[level - 1];
    const std::size_t first = node * kFan;
    const std::size_t count = std::min(kFan, below.size() - first);
    std::array<std::pair<double, std::size_t>, kFan> children;
    for (std::size_t i = 0; i < count; ++i) {
      children[i] = {distance_to_box(below[first + i], p), first + i};
    }
    std::sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count && children[i].first <= bound; ++i) {
      descend(level - 1, children[i].second, p, bound, visit);
    }
  }

  std::vector<std::vector<Box>> levels_;
};

}  // namespace fit_check
