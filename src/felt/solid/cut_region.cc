#include "felt/solid/cut_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "felt/geometry/rect.h"
#include "felt/solid/stroke_path.h"

namespace felt {
namespace cut_regions {

constexpr int kMarginCells = 4;
constexpr double kHalfDiagonal = 0.75;  // of a cell, in cells; a little more than sqrt(0.5)

struct Cell {
  int x = 0, y = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The cells of a picture, and those that the body and the stroke cover.
class Grid {
 public:
  explicit Grid(const Rect& area)
      : cell_mm_(std::max({area.width(), area.height(), 1e-6}) / kCutCells),
        corner_{area.x0 - kMarginCells * cell_mm_, area.y0 - kMarginCells * cell_mm_},
        width_(static_cast<int>(area.width() / cell_mm_) + 2 * kMarginCells + 1),
        height_(static_cast<int>(area.height() / cell_mm_) + 2 * kMarginCells + 1),
        covered_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {}

  [[nodiscard]] double cell_mm() const noexcept { return cell_mm_; }
  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }
  [[nodiscard]] Cell cell_at(Point p) const {
    const auto number = [](double v, int end) {
      return static_cast<int>(std::clamp(std::floor(v), 0.0, end - 1.0));
    };
    return {number((p.x - corner_.x) / cell_mm_, width_),
            number((p.y - corner_.y) / cell_mm_, height_)};
  }
  [[nodiscard]] Point centre(Cell c) const {
    return {corner_.x + (c.x + 0.5) * cell_mm_, corner_.y + (c.y + 0.5) * cell_mm_};
  }
  [[nodiscard]] std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(c.x);
  }
  [[nodiscard]] bool contains(Cell c) const {
    return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_;
  }
  [[nodiscard]] bool is_covered(Cell c) const { return covered_[index(c)] != 0; }
  void cover(Cell c) { covered_[index(c)] = 1; }
  void uncover(Cell c) { covered_[index(c)] = 0; }

  /// Covers the cells that a triangle touches, and some beside them.
  void cover_triangle(std::array<Point, 3> t);

 private:
  double cell_mm_;
  Point corner_;
  int width_, height_;
  std::vector<std::uint8_t> covered_;
};

void Grid::cover_triangle(std::array<Point, 3> t) {
  if (cross(t[1] - t[0], t[2] - t[0]) < 0.0) std::swap(t[1], t[2]);
  Rect box;
  for (const Point p : t) box.extend(p);
  const Cell low = cell_at({box.x0 - cell_mm_, box.y0 - cell_mm_});
  const Cell high = cell_at({box.x1 + cell_mm_, box.y1 + cell_mm_});
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const Point p = centre({x, y});
      bool is_near = true;
      for (std::size_t k = 0; k < 3 && is_near; ++k) {
        const Vec along = t[(k + 1) % 3] - t[k];
        const double reach = kHalfDiagonal * cell_mm_ * norm(along);
        is_near = cross(along, p - t[k]) >= -reach;
      }
      if (is_near) cover({x, y});
    }
  }
}

/// A point at the left of the stroke, on the body, and whether a ray from it to the right crosses
/// the stroke an odd number of times. The stroke ends in the middles of cells here, like the path.
struct LeftPoint {
  Point at;
  bool is_odd = false;
};

bool crosses_ray(Point from, Point a, Point b) {
  if ((a.y > from.y) == (b.y > from.y)) return false;
  return a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x) > from.x;
}

LeftPoint left_of(const std::vector<Point>& stroke, const Grid& grid) {
  const std::size_t i = stroke.size() / 2;
  const Point a = stroke[i - 1], b = stroke[i];
  LeftPoint left{a + 0.4987 * (b - a) + 1e-3 * grid.cell_mm() * perp(normalized(b - a)), false};
  const auto count = [&left](Point from, Point to) {
    if (crosses_ray(left.at, from, to)) left.is_odd = !left.is_odd;
  };
  for (std::size_t k = 1; k < stroke.size(); ++k) count(stroke[k - 1], stroke[k]);
  count(stroke.back(), grid.centre(grid.cell_at(stroke.back())));
  count(grid.centre(grid.cell_at(stroke.front())), stroke.front());
  return left;
}

/// Finds the shortest path of free cells (with four neighbours) from the end of the stroke to its
/// start so that the closed curve encloses the point at the left. The state of the search is a cell
/// and whether the path crossed the ray an odd number of times.
std::vector<Point> path_around(const Grid& grid, const std::vector<Point>& stroke) {
  const LeftPoint left = left_of(stroke, grid);
  const Cell from = grid.cell_at(stroke.back()), to = grid.cell_at(stroke.front());
  const auto cells =
      static_cast<std::size_t>(grid.width()) * static_cast<std::size_t>(grid.height());
  constexpr std::uint32_t kUnseen = 0xFFFFFFFF;
  std::vector<std::uint32_t> previous(2 * cells, kUnseen);
  const auto state_of = [&](Cell c, bool odd) {
    return static_cast<std::uint32_t>(2 * grid.index(c) + (odd ? 1 : 0));
  };
  const auto cell_of = [&](std::uint32_t state) {
    const auto width = static_cast<std::uint32_t>(grid.width());
    return Cell{static_cast<int>(state / 2 % width), static_cast<int>(state / 2 / width)};
  };
  const std::uint32_t start = state_of(from, false), goal = state_of(to, !left.is_odd);
  std::vector<std::uint32_t> queue{start};
  previous[start] = start;
  for (std::size_t next = 0; next < queue.size() && previous[goal] == kUnseen; ++next) {
    const Cell at = cell_of(queue[next]);
    for (const Cell step : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
      const Cell cell{at.x + step.x, at.y + step.y};
      if (!grid.contains(cell) || grid.is_covered(cell)) continue;
      const bool crosses = crosses_ray(left.at, grid.centre(at), grid.centre(cell));
      const std::uint32_t state = state_of(cell, (queue[next] % 2 != 0) != crosses);
      if (previous[state] != kUnseen) continue;
      previous[state] = queue[next];
      queue.push_back(state);
    }
  }
  std::vector<Point> path;
  if (previous[goal] == kUnseen || goal == start) return path;
  for (std::uint32_t state = previous[goal]; state != start; state = previous[state]) {
    path.push_back(grid.centre(cell_of(state)));
  }
  std::reverse(path.begin(), path.end());
  return path;
}

bool is_free_line(const Grid& grid, Point a, Point b) {
  const int steps = static_cast<int>(4.0 * distance(a, b) / grid.cell_mm()) + 1;
  for (int k = 0; k <= steps; ++k) {
    if (grid.is_covered(grid.cell_at(lerp(a, b, static_cast<double>(k) / steps)))) return false;
  }
  return true;
}

/// Leaves out points of a path between two points that can be joined by a line beside the body.
std::vector<Point> straightened(const Grid& grid, const std::vector<Point>& path) {
  constexpr std::size_t kMaxSkip = 64;
  std::vector<Point> out;
  std::size_t at = 0;
  while (at + 1 < path.size()) {
    std::size_t next = std::min(at + kMaxSkip, path.size() - 1);
    while (next > at + 1 && !is_free_line(grid, path[at], path[next])) --next;
    if (next + 1 < path.size()) out.push_back(path[next]);
    at = next;
  }
  return out;
}

/// Covers the cells that the stroke passes, except for those of its ends.
void cover_stroke(Grid& grid, const std::vector<Point>& stroke) {
  const Cell first = grid.cell_at(stroke.front()), last = grid.cell_at(stroke.back());
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    const int steps =
        static_cast<int>(20.0 * distance(stroke[i - 1], stroke[i]) / grid.cell_mm()) + 1;
    for (int k = 0; k <= steps; ++k) {
      grid.cover(grid.cell_at(lerp(stroke[i - 1], stroke[i], static_cast<double>(k) / steps)));
    }
  }
  grid.uncover(first);
  grid.uncover(last);
}

/// The part of the stroke from the last point before the body to the first one after it, with
/// points at equal distances from its start: the same stroke gets the same points on every body.
/// Requires that some point of `fine`, the stroke in small steps, is on the body, and the ends are
/// not.
std::vector<Point> part_on_body(const Grid& grid, const std::vector<Point>& stroke,
                                const std::vector<Point>& fine, double step_mm) {
  std::size_t first = 0, last = fine.size() - 1;
  while (!grid.is_covered(grid.cell_at(fine[first + 1]))) ++first;
  while (!grid.is_covered(grid.cell_at(fine[last - 1]))) --last;
  const std::vector<Point> points = resampled(stroke, step_mm);
  const double share =
      static_cast<double>(points.size() - 1) / static_cast<double>(fine.size() - 1);
  const auto begin = static_cast<std::ptrdiff_t>(static_cast<double>(first) * share);
  const auto end = static_cast<std::ptrdiff_t>(std::ceil(static_cast<double>(last) * share));
  return {points.begin() + begin,
          points.begin() + std::min(end + 1, static_cast<std::ptrdiff_t>(points.size()))};
}

Grid grid_of(const SolidBody& body, const ViewFrame& frame, const std::vector<Point>& stroke) {
  Rect area;
  for (const Point p : stroke) area.extend(p);
  for (const Vec3& p : body.points) area.extend(frame.to_picture(p));
  Grid grid(area);
  for (const auto& [a, b, c] : body.triangles) {
    grid.cover_triangle({frame.to_picture(body.points[a]), frame.to_picture(body.points[b]),
                         frame.to_picture(body.points[c])});
  }
  return grid;
}

}  // namespace cut_regions

Result<std::optional<CutRegion>> find_cut_region(const SolidBody& body, const ViewFrame& frame,
                                                 const std::vector<Point>& stroke, double step_mm) {
  using namespace cut_regions;
  Grid grid = grid_of(body, frame, stroke);
  const double length_mm = path_length(stroke);
  if (length_mm > kMaxCutPoints * std::min(step_mm, grid.cell_mm())) {
    return invalid_data("the stroke is too long");
  }
  const std::vector<Point> fine = resampled(stroke, 0.5 * grid.cell_mm());
  const auto is_on_body = [&grid](Point p) { return grid.is_covered(grid.cell_at(p)); };
  if (std::none_of(fine.begin(), fine.end(), is_on_body)) return std::optional<CutRegion>();
  if (is_on_body(fine.front())) return invalid_data("the stroke begins on the body");
  if (is_on_body(fine.back())) return invalid_data("the stroke ends on the body");
  CutRegion region;
  region.ring = part_on_body(grid, stroke, fine, step_mm);
  region.stroke_points = region.ring.size();
  if (region.ring.size() < 2) return std::optional<CutRegion>();
  if (self_crossing(region.ring, PathEnds::kOpen)) return invalid_data("the stroke crosses itself");
  cover_stroke(grid, region.ring);
  std::vector<Point> path = path_around(grid, region.ring);
  if (path.empty()) return invalid_data("the stroke does not cut off a part of the body");
  path.insert(path.begin(), region.ring.back());
  path.push_back(region.ring.front());
  path = straightened(grid, path);
  region.ring.insert(region.ring.end(), path.begin(), path.end());
  if (self_crossing(region.ring, PathEnds::kClosed) || ring_area(region.ring) <= 0.0) {
    return invalid_data("the stroke turns too sharply beside the body");
  }
  return region;
}

}  // namespace felt
