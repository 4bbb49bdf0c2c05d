// Converts the non-zero rule to the even-odd rule. The curves are flattened to edges between the
// points of a fine grid. Edges are split where they meet, with crossings rounded to the grid, until
// two edges have at most an end in common or are equal. Equal edges become one, which counts how
// often the boundary runs along it. All tests are exact, because the coordinates are integers. An
// edge stays if exactly one of its sides is painted. Edges that follow each other on one curve
// become a part of that curve again.
#include "felt/io/svg/svg_nonzero.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include "felt/geometry/cubic.h"
#include "felt/stroke/outline/outline.h"

namespace felt {
namespace {

constexpr double kChordMm = 0.001;
constexpr double kCellMm = 1.0 / 2048.0;
constexpr double kMaxCells = 268'435'456.0;            ///< 2^28, so that cross products fit 64 bits
constexpr std::int64_t kMaxComparisons = 300'000'000;  ///< between edges
constexpr std::size_t kMaxEdges = 2'000'000;
constexpr int kMaxSteps = 4096;  ///< for each curve
constexpr int kMaxRounds = 24;
constexpr std::int64_t kMaxSlabs = 1024;

/// A point of the grid. Points are ordered by y, then by x.
struct SnappedPoint {
  std::int64_t y = 0, x = 0;

  friend auto operator<=>(const SnappedPoint&, const SnappedPoint&) = default;
};

SnappedPoint operator+(SnappedPoint a, SnappedPoint b) {
  return {a.y + b.y, a.x + b.x};
}

SnappedPoint operator-(SnappedPoint a, SnappedPoint b) {
  return {a.y - b.y, a.x - b.x};
}

std::int64_t grid_cross(SnappedPoint a, SnappedPoint b) {
  return a.x * b.y - a.y * b.x;
}

std::int64_t grid_dot(SnappedPoint a, SnappedPoint b) {
  return a.x * b.x + a.y * b.y;
}

/// A straight part of the boundary. Requires a < b.
struct GridEdge {
  SnappedPoint a, b;
  std::size_t curve = 0;      ///< the curve that it is a part of
  double at_a = 0, at_b = 0;  ///< the parameters of its ends on that curve
  int turns = 0;              ///< how often the boundary runs from a to b, less from b to a
  bool is_new = true;
};

struct GridSplit {
  std::size_t edge = 0;
  SnappedPoint at;
};

/// Returns true if a point that is not an end lies on the edge, within the rounding of the grid.
bool is_on(const GridEdge& e, SnappedPoint p) {
  const SnappedPoint d = e.b - e.a;
  const std::int64_t length2 = grid_dot(d, d), along = grid_dot(d, p - e.a);
  if (along <= 0 || along >= length2) return false;
  const auto aside = static_cast<double>(grid_cross(d, p - e.a));
  return aside * aside <= 0.5 * static_cast<double>(length2);
}

class NonzeroArea {
 public:
  explicit NonzeroArea(const std::vector<FillLoop>& loops) {
    for (const FillLoop& loop : loops) {
      for (std::size_t i = 0; i + 1 < loop.points.size(); i += 3) {
        curves_.push_back(fill_segment(loop, i / 3));
        bounds_.extend(control_bounds(curves_.back()));
      }
    }
    const double extent = std::max(bounds_.width(), bounds_.height());
    if (!std::isfinite(extent)) return;
    while (extent / cell_mm_ > kMaxCells) cell_mm_ *= 2.0;
    for (std::size_t i = 0; i < curves_.size() && edges_.size() <= kMaxEdges; ++i) add_curve(i);
    is_complete_ = edges_.size() <= kMaxEdges;
    std::stable_sort(places_.begin(), places_.end(),
                     [](const auto& p, const auto& q) { return p.first < q.first; });
  }

  /// Returns false if the work exceeds a limit. `loops` stay as they are if they are right.
  bool run(std::vector<FillLoop>& loops) {
    if (!is_complete_) return false;
    merge_equal();
    for (int round = 0; find_splits(); ++round) {
      if (round == kMaxRounds) return false;
      split_edges();
      merge_equal();
    }
    if (comparisons_left_ < 0 || !keep_boundary()) return false;
    if (!is_changed_) return true;
    loops.clear();
    is_used_.assign(edges_.size(), false);
    sort_ends();
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!is_used_[i]) loops.push_back(chain(i));
    }
    return true;
  }

 private:
  [[nodiscard]] SnappedPoint grid_point(Point p) const {
    return {std::llround((p.y - bounds_.y0) / cell_mm_),
            std::llround((p.x - bounds_.x0) / cell_mm_)};
  }

  /// Returns the point of a curve that was rounded to this point, or the point itself.
  [[nodiscard]] Point place(SnappedPoint p) const {
    const auto found = std::lower_bound(places_.begin(), places_.end(), p,
                                        [](const auto& q, SnappedPoint v) { return q.first < v; });
    if (found != places_.end() && found->first == p) return found->second;
    return {bounds_.x0 + cell_mm_ * static_cast<double>(p.x),
            bounds_.y0 + cell_mm_ * static_cast<double>(p.y)};
  }

  void add_curve(std::size_t index) {
    const Cubic& c = curves_[index];
    const int steps = flatness(c) == 0.0 ? 1 : std::min(flatten_steps(c, 1.0, kChordMm), kMaxSteps);
    SnappedPoint from = grid_point(c.p[0]);
    places_.emplace_back(from, c.p[0]);
    double at = 0.0;
    for (int i = 1; i <= steps; ++i) {
      const double next = double(i) / steps;
      const Point p = evaluate(c, next);
      const SnappedPoint to = grid_point(p);
      if (i < steps && to == from) continue;
      places_.emplace_back(to, p);
      add_edge({from, to, index, at, next, 1, true});
      from = to;
      at = next;
    }
  }

  void add_edge(GridEdge e) {
    if (e.a == e.b) return;
    if (e.b < e.a) {
      std::swap(e.a, e.b);
      std::swap(e.at_a, e.at_b);
      e.turns = -e.turns;
    }
    edges_.push_back(e);
  }

  void merge_equal() {
    std::sort(edges_.begin(), edges_.end(), [](const GridEdge& e, const GridEdge& f) {
      return std::tie(e.a, e.b, e.curve, e.at_a, e.at_b) <
             std::tie(f.a, f.b, f.curve, f.at_a, f.at_b);
    });
    std::vector<GridEdge> merged;
    for (const GridEdge& e : edges_) {
      if (merged.empty() || merged.back().a != e.a || merged.back().b != e.b) {
        merged.push_back(e);
        continue;
      }
      merged.back().turns += e.turns;
      merged.back().is_new = merged.back().is_new && e.is_new;
      is_changed_ = true;
    }
    std::erase_if(merged, [](const GridEdge& e) { return e.turns == 0; });
    edges_ = std::move(merged);
  }

  /// Finds the points at which edges meet within an edge. Returns false if there is none, or if the
  /// comparisons are used up.
  bool find_splits() {
    splits_.clear();
    const auto left = [this](std::size_t i) { return std::min(edges_[i].a.x, edges_[i].b.x); };
    std::vector<std::size_t> order(edges_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
      return std::pair(left(i), i) < std::pair(left(k), k);
    });
    for (std::size_t n = 0; n < order.size(); ++n) {
      const GridEdge& e = edges_[order[n]];
      const std::int64_t right = std::max(e.a.x, e.b.x) + 1;
      for (std::size_t m = n + 1; m < order.size() && left(order[m]) <= right; ++m) {
        if (--comparisons_left_ < 0) return false;
        const GridEdge& f = edges_[order[m]];
        if (f.a.y > e.b.y + 1 || f.b.y + 1 < e.a.y || !(e.is_new || f.is_new)) continue;
        compare(order[n], order[m]);
      }
    }
    for (GridEdge& e : edges_) e.is_new = false;
    return !splits_.empty();
  }

  void compare(std::size_t i, std::size_t k) {
    const GridEdge &e = edges_[i], &f = edges_[k];
    const std::size_t before = splits_.size();
    for (const SnappedPoint p : {f.a, f.b}) {
      if (is_on(e, p)) splits_.push_back({i, p});
    }
    for (const SnappedPoint p : {e.a, e.b}) {
      if (is_on(f, p)) splits_.push_back({k, p});
    }
    if (splits_.size() > before) return;
    const auto sign = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
    const SnappedPoint d = e.b - e.a, g = f.b - f.a;
    const std::int64_t c = grid_cross(g, e.a - f.a);
    if (sign(grid_cross(d, f.a - e.a)) * sign(grid_cross(d, f.b - e.a)) >= 0) return;
    if (sign(c) * sign(grid_cross(g, e.b - f.a)) >= 0) return;
    const double t = static_cast<double>(c) / static_cast<double>(grid_cross(d, g));
    const SnappedPoint at{e.a.y + std::llround(t * static_cast<double>(d.y)),
                          e.a.x + std::llround(t * static_cast<double>(d.x))};
    if (at != e.a && at != e.b) splits_.push_back({i, at});
    if (at != f.a && at != f.b) splits_.push_back({k, at});
  }

  void split_edges() {
    is_changed_ = true;
    const auto along = [this](const GridSplit& s) {
      return grid_dot(edges_[s.edge].b - edges_[s.edge].a, s.at - edges_[s.edge].a);
    };
    std::sort(splits_.begin(), splits_.end(), [&](const GridSplit& s, const GridSplit& r) {
      return std::tuple(s.edge, along(s), s.at) < std::tuple(r.edge, along(r), r.at);
    });
    std::vector<GridEdge> before = std::move(edges_);
    edges_.clear();
    auto split = splits_.begin();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const GridEdge& e = before[i];
      if (split == splits_.end() || split->edge != i) {
        edges_.push_back(e);
        continue;
      }
      const auto length2 = static_cast<double>(grid_dot(e.b - e.a, e.b - e.a));
      GridEdge part = e;
      part.is_new = true;
      for (; split != splits_.end() && split->edge == i; ++split) {
        const double s = static_cast<double>(grid_dot(e.b - e.a, split->at - e.a)) / length2;
        part.b = split->at;
        part.at_b = e.at_a + s * (e.at_b - e.at_a);
        add_edge(part);
        part.a = part.b;
        part.at_a = part.at_b;
      }
      part.b = e.b;
      part.at_b = e.at_b;
      add_edge(part);
    }
  }

  /// Drops the edges whose sides are both painted or both unpainted. Returns false if the
  /// comparisons are used up.
  bool keep_boundary() {
    std::int64_t top = 0;
    for (const GridEdge& e : edges_) top = std::max(top, e.b.y);
    const auto count = std::min(kMaxSlabs, static_cast<std::int64_t>(edges_.size()) + 1);
    std::vector<std::vector<std::size_t>> slabs(static_cast<std::size_t>(count));
    const auto slab = [&](std::int64_t y) {
      return static_cast<std::size_t>(y * count / (top + 1));
    };
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for (std::size_t s = slab(edges_[i].a.y); s <= slab(edges_[i].b.y); ++s)
        slabs[s].push_back(i);
    }
    std::vector<GridEdge> kept;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const GridEdge& e = edges_[i];
      const auto& near = slabs[slab((e.a.y + e.b.y) / 2)];
      comparisons_left_ -= static_cast<std::int64_t>(near.size());
      if (comparisons_left_ < 0) return false;
      const int right = turns_right_of(i, near);
      if ((right == 0) != (right + e.turns == 0)) kept.push_back(e);
    }
    is_changed_ = is_changed_ || kept.size() != edges_.size();
    edges_ = std::move(kept);
    return true;
  }

  /// Returns the winding number just to the right of the middle of an edge, by the edges that a ray
  /// from there to +x meets. The ray is turned by less than any angle of the grid, towards -y, so
  /// that it never runs along an edge.
  [[nodiscard]] int turns_right_of(std::size_t index, const std::vector<std::size_t>& near) const {
    const SnappedPoint middle2 = edges_[index].a + edges_[index].b;
    int turns = 0;
    for (const std::size_t k : near) {
      const GridEdge& f = edges_[k];
      if (k == index || middle2 < f.a + f.a || !(middle2 < f.b + f.b)) continue;
      if (grid_cross(f.b - f.a, middle2 - (f.a + f.a)) > 0) turns += f.turns;
    }
    return turns;
  }

  /// Sorts the edges along the curves, so that loops begin at the beginning of a curve if they can.
  void sort_ends() {
    std::sort(edges_.begin(), edges_.end(), [](const GridEdge& e, const GridEdge& f) {
      return std::tuple(e.curve, std::min(e.at_a, e.at_b), e.a, e.b) <
             std::tuple(f.curve, std::min(f.at_a, f.at_b), f.a, f.b);
    });
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      ends_.emplace_back(edges_[i].a, i);
      ends_.emplace_back(edges_[i].b, i);
    }
    std::sort(ends_.begin(), ends_.end());
  }

  /// Returns the unused edge at a point that continues an edge best: on its curve, or else next to
  /// it in the file.
  [[nodiscard]] std::optional<std::size_t> next_edge(SnappedPoint at, std::size_t from) const {
    std::optional<std::size_t> best;
    std::size_t best_step = 0;
    for (auto end = std::lower_bound(ends_.begin(), ends_.end(), std::pair(at, std::size_t{0}));
         end != ends_.end() && end->first == at; ++end) {
      if (is_used_[end->second]) continue;
      const std::size_t a = edges_[end->second].curve, b = edges_[from].curve;
      const std::size_t step = a < b ? b - a : a - b;
      if (best && step >= best_step) continue;
      best = end->second;
      best_step = step;
    }
    return best;
  }

  /// Returns the loop of unused edges that begins with an edge. An even number of edges end at
  /// every point, so it always closes.
  FillLoop chain(std::size_t first) {
    const bool is_forward = edges_[first].turns > 0;
    const SnappedPoint begin = is_forward ? edges_[first].a : edges_[first].b;
    FillLoop loop{{place(begin)}, {}};
    SnappedPoint at = begin;
    std::size_t curve = edges_[first].curve;
    double from = is_forward ? edges_[first].at_a : edges_[first].at_b, to = from;
    for (std::optional<std::size_t> next = first; next;) {
      const GridEdge& e = edges_[*next];
      is_used_[*next] = true;
      const bool up = e.a == at;
      const double e_from = up ? e.at_a : e.at_b, e_to = up ? e.at_b : e.at_a;
      const bool continues =
          e.curve == curve && e_from == to && (e_to - e_from) * (to - from) >= 0.0;
      if (!continues) {
        append(loop, sub_segment(curves_[curve], from, to), at);
        curve = e.curve;
        from = e_from;
      }
      to = e_to;
      at = up ? e.b : e.a;
      next = at == begin ? std::nullopt : next_edge(at, *next);
    }
    append(loop, sub_segment(curves_[curve], from, to), at);
    return loop;
  }

  void append(FillLoop& loop, const Cubic& part, SnappedPoint end) const {
    loop.points.insert(loop.points.end(), {part.p[1], part.p[2], place(end)});
  }

  std::vector<Cubic> curves_;
  Rect bounds_;
  double cell_mm_ = kCellMm;
  std::vector<std::pair<SnappedPoint, Point>> places_;
  std::vector<GridEdge> edges_;
  std::vector<GridSplit> splits_;
  std::int64_t comparisons_left_ = kMaxComparisons;
  bool is_complete_ = false;  ///< false if there are too many edges, or the bounds overflow
  bool is_changed_ = false;
  std::vector<std::pair<SnappedPoint, std::size_t>> ends_;
  std::vector<bool> is_used_;
};

}  // namespace

bool make_even_odd(std::vector<FillLoop>& loops) {
  return NonzeroArea(loops).run(loops);
}

}  // namespace felt
