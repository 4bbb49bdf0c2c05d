#include "felt/solid/sector.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace felt {
namespace sector_cut {

/// A point of a ring; `lines` has a bit for each of the two lines of axes on which it is.
struct CutPoint {
  Point p;
  unsigned lines = 0;
};
using CutRing = std::vector<CutPoint>;

/// Where a ring crosses the line of the cut.
struct Passage {
  double along_mm = 0.0;
  std::size_t chain = 0;
  bool enters = false;
};

CutPoint passage_point(const CutPoint& a, const CutPoint& b, Vec along, unsigned line) {
  const double ta = cross(along, a.p - Point{}), tb = cross(along, b.p - Point{});
  const Point p = lerp(a.p, b.p, ta / (ta - tb));
  const unsigned common = a.lines & b.lines;
  // An edge on the other line crosses this one at the centre.
  if (common != 0) return {{0.0, 0.0}, common | line};
  return {Point{} + dot(along, p - Point{}) * along, line};
}

/// Divides the rings into the chains left of the line. A chain begins and ends on the line. Rings
/// that are wholly on the left go to `whole`.
std::vector<CutRing> chains_of(const std::vector<CutRing>& rings, Vec along, unsigned line,
                               std::vector<CutRing>& whole) {
  std::vector<CutRing> chains;
  for (const CutRing& ring : rings) {
    const std::size_t n = ring.size();
    const auto left = [&](std::size_t i) { return cross(along, ring[i % n].p - Point{}) > 0.0; };
    std::size_t first = 0;
    while (first < n && !(!left(first) && left(first + 1))) ++first;
    if (first == n) {
      if (left(0)) whole.push_back(ring);
      continue;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = first + k;
      const bool from = left(i), to = left(i + 1);
      if (from != to) {
        if (to) chains.emplace_back();
        chains.back().push_back(passage_point(ring[i % n], ring[(i + 1) % n], along, line));
      }
      if (to) chains.back().push_back(ring[(i + 1) % n]);
    }
  }
  return chains;
}

/// Returns the part of the area left of the line through the centre. Chains are joined along the
/// line: from the end of one to the next start in the direction of the line, because the area is on
/// the left there. Fails if ends and starts do not alternate, or coincide.
std::optional<std::vector<CutRing>> left_part(const std::vector<CutRing>& rings, Vec along,
                                              unsigned line, double min_mm) {
  std::vector<CutRing> parts;
  const std::vector<CutRing> chains = chains_of(rings, along, line, parts);
  std::vector<Passage> passages;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    passages.push_back({dot(along, chains[i].front().p - Point{}), i, true});
    passages.push_back({dot(along, chains[i].back().p - Point{}), i, false});
  }
  std::sort(passages.begin(), passages.end(),
            [](const Passage& a, const Passage& b) { return a.along_mm < b.along_mm; });
  std::vector<std::size_t> next(chains.size());
  for (std::size_t i = 0; i < passages.size(); ++i) {
    if (passages[i].enters != (i % 2 == 1)) return std::nullopt;
    if (i == 0) continue;
    if (passages[i].along_mm - passages[i - 1].along_mm < min_mm) return std::nullopt;
    if (i % 2 == 1) next[passages[i - 1].chain] = passages[i].chain;
  }
  std::vector<bool> used(chains.size());
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (used[i]) continue;
    CutRing ring;
    for (std::size_t k = i; !used[k]; k = next[k]) {
      used[k] = true;
      ring.insert(ring.end(), chains[k].begin(), chains[k].end());
    }
    parts.push_back(std::move(ring));
  }
  return parts;
}

bool is_on_axis(const CutPoint& a, const CutPoint& b) {
  return (a.lines & b.lines) != 0;
}

/// Returns the points of a chain of the border from one axis to another, or of a whole ring.
std::vector<Point> reduced(std::vector<Point> line, const RingSpec& spec, bool is_ring) {
  if (!is_ring) {
    // No point near an end, because the end was computed, and not chosen like the others.
    const Point first = line.front(), last = line.back();
    const auto is_near = [&](Point p) {
      return std::min(distance(p, first), distance(p, last)) < 0.5 * spec.tip_mm;
    };
    line.erase(std::remove_if(line.begin() + 1, line.end() - 1, is_near), line.end() - 1);
  }
  return border_points(line, spec);
}

void add_edge(Sector& sector, std::size_t a, std::size_t b) {
  sector.edges.push_back({a, b});
}

/// Adds a ring without a point on an axis.
void add_ring(Sector& sector, const CutRing& ring, const RingSpec& spec) {
  std::vector<Point> line;
  for (const CutPoint& p : ring) line.push_back(p.p);
  // Starts at a corner of the convex hull: the rightmost point.
  const auto right =
      std::max_element(line.begin(), line.end(), [](Point a, Point b) { return a.x < b.x; });
  std::rotate(line.begin(), right, line.end());
  line.push_back(line.front());
  std::vector<Point> points = reduced(std::move(line), spec, true);
  points.pop_back();
  const std::size_t first = sector.points.size(), n = points.size();
  sector.points.insert(sector.points.end(), points.begin(), points.end());
  for (std::size_t i = 0; i < n; ++i) add_edge(sector, first + i, first + (i + 1) % n);
}

/// Adds a ring with edges on axes.
void add_cut_ring(Sector& sector, CutRing ring, const RingSpec& spec) {
  const std::size_t n = ring.size();
  std::size_t start = 0;
  while (!is_on_axis(ring[(start + n - 1) % n], ring[start])) ++start;
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
  const std::size_t first = sector.points.size();
  sector.points.push_back(ring.front().p);
  for (std::size_t i = 0; i + 1 < n;) {
    std::size_t end = i + 1;
    if (!is_on_axis(ring[i], ring[end])) {
      while (ring[end].lines == 0) ++end;
    }
    std::vector<Point> line;
    for (std::size_t k = i; k <= end; ++k) line.push_back(ring[k].p);
    if (!is_on_axis(ring[i], ring[i + 1])) line = reduced(std::move(line), spec, false);
    for (std::size_t k = 1; k < line.size(); ++k) {
      sector.points.push_back(line[k]);
      add_edge(sector, sector.points.size() - 2, sector.points.size() - 1);
    }
    i = end;
  }
  add_edge(sector, sector.points.size() - 1, first);
}

}  // namespace sector_cut

RayFlags rays_of(Point p, int axes, double tolerance_mm) noexcept {
  if (axes == 0) return {};
  const auto is_on = [&](double angle) {
    const Vec along{std::cos(angle), std::sin(angle)}, at = p - Point{};
    return std::fabs(cross(along, at)) <= tolerance_mm && dot(along, at) >= -tolerance_mm;
  };
  return {is_on(0.0), is_on(std::numbers::pi / axes)};
}

std::optional<Sector> cut_sector(std::span<const Ring> rings, int axes, const RingSpec& spec) {
  using namespace sector_cut;
  std::vector<CutRing> parts;
  for (const Ring& ring : rings) {
    CutRing part;
    for (const Point p : ring) part.push_back({p, 0});
    parts.push_back(std::move(part));
  }
  for (int cut = 0; cut < std::min(axes, 2); ++cut) {
    const double angle = cut == 0 ? 0.0 : std::numbers::pi / axes + std::numbers::pi;
    const Vec along{std::cos(angle), std::sin(angle)};
    auto left = left_part(parts, along, cut == 0 ? 1U : 2U, spec.tip_mm);
    if (!left) return std::nullopt;
    parts = *std::move(left);
  }
  Sector sector;
  sector.axes = axes;
  for (const CutRing& ring : parts) {
    const bool is_cut =
        std::any_of(ring.begin(), ring.end(), [](const CutPoint& p) { return p.lines != 0; });
    is_cut ? add_cut_ring(sector, ring, spec) : add_ring(sector, ring, spec);
  }
  return sector;
}

std::optional<Point> crossing_of(const Sector& sector) {
  std::vector<EdgeGrid::Edge> edges;
  for (const auto& [a, b] : sector.edges) edges.push_back({sector.points[a], sector.points[b]});
  const EdgeGrid grid(std::move(edges), 1e-9);
  const auto [first, second] = grid.crossing();
  if (first == second) return std::nullopt;
  return grid.edges()[first].a;
}

}  // namespace felt
