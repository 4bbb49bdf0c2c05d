#include "felt/fill/planar_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "felt/base/constants.h"
#include "felt/fill/curve_area.h"

namespace felt {
namespace {

/// The first curve of a half edge, in its direction, up to `until`.
struct Departure {
  Cubic curve;
  double until = 1.0;
  std::size_t half_edge = 0;
  double angle = 0.0;
};

double angle_of(Vec v) {
  return std::atan2(v.y, v.x);
}

/// Returns the largest distance of the curve from its start, at a few samples.
double reach_of_curve(const Departure& d) {
  double reach = 0.0;
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    reach = std::max(reach, distance(evaluate(d.curve, share * d.until), d.curve.p[0]));
  }
  return reach;
}

/// Returns the direction to the point where the curve first leaves the circle around its start.
double angle_at_circle(const Departure& d, double radius_mm) {
  constexpr int kSteps = 32;
  const auto away = [&](double t) { return distance(evaluate(d.curve, t), d.curve.p[0]); };
  double inside = 0.0, outside = d.until;
  for (int k = 1; k <= kSteps; ++k) {
    const double t = d.until * k / kSteps;
    if (away(t) >= radius_mm) {
      outside = t;
      break;
    }
    inside = t;
  }
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (inside + outside);
    (away(middle) >= radius_mm ? outside : inside) = middle;
  }
  return angle_of(evaluate(d.curve, outside) - d.curve.p[0]);
}

/// Sorts by direction. Compares the tangents if these differ clearly, and otherwise the points
/// where the curves leave a circle. The direction of a short handle may be nothing but rounding.
void sort_departures(std::vector<Departure>& all) {
  constexpr double kClear = 1e-3, kShortHandleMm = 1e-3;
  const auto by_angle = [](const Departure& a, const Departure& b) {
    return std::pair(a.angle, a.half_edge) < std::pair(b.angle, b.half_edge);
  };
  for (Departure& d : all) d.angle = angle_of(tangent(d.curve, 0.0));
  std::sort(all.begin(), all.end(), by_angle);
  bool clear = all.size() < 2 || all.front().angle + kTau - all.back().angle > kClear;
  for (std::size_t i = 0; i < all.size(); ++i) {
    clear = clear && (i == 0 || all[i].angle - all[i - 1].angle > kClear) &&
            distance(all[i].curve.p[0], all[i].curve.p[1]) > kShortHandleMm;
  }
  if (clear) return;
  double radius = std::numeric_limits<double>::infinity();
  for (const Departure& d : all) radius = std::min(radius, 0.5 * reach_of_curve(d));
  for (Departure& d : all) d.angle = angle_at_circle(d, radius);
  std::sort(all.begin(), all.end(), by_angle);
}

}  // namespace

PlanarMap::PlanarMap(MapEdges edges) : edges_(std::move(edges)), dropped_(edges_.edges.size()) {
  for (const MapEdge& edge : edges_.edges) {
    boxes_.emplace_back();
    for (const Cubic& c : edges_.cubics_of(edge)) boxes_.back().extend(control_bounds(c));
  }
  sort_half_edges();
  set_components();
  trace();
  counts_.edges = edges_.edges.size();
  counts_.nodes = static_cast<std::size_t>(std::count_if(
      leaving_.begin(), leaving_.end(), [](const auto& around) { return !around.empty(); }));
  counts_.components = static_cast<std::size_t>(
      std::count_if(loops_.begin(), loops_.end(), [](const MapLoop& loop) { return loop.outer; }));
  counts_.faces = loops_.size() - counts_.components + 1;
  if (drop_idle_edges() > 0) {
    set_components();
    trace();
  }
}

void PlanarMap::sort_half_edges() {
  std::vector<std::vector<Departure>> departures(edges_.nodes.size());
  for (std::size_t e = 0; e < edges_.edges.size(); ++e) {
    const auto cubics = edges_.cubics_of(edges_.edges[e]);
    const double until = cubics.size() == 1 ? 0.5 : 1.0;
    departures[tail(2 * e)].push_back({cubics.front(), until, 2 * e, 0.0});
    departures[tail(2 * e + 1)].push_back({reversed(cubics.back()), until, 2 * e + 1, 0.0});
  }
  leaving_.resize(departures.size());
  for (std::size_t node = 0; node < departures.size(); ++node) {
    sort_departures(departures[node]);
    for (const Departure& d : departures[node]) leaving_[node].push_back(d.half_edge);
  }
}

void PlanarMap::set_components() {
  std::vector<std::size_t>& parent = component_;
  parent.resize(edges_.nodes.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root_of = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t e = 0; e < edges_.edges.size(); ++e) {
    if (!dropped_[e]) parent[root_of(tail(2 * e))] = root_of(tail(2 * e + 1));
  }
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = root_of(i);
}

void PlanarMap::trace() {
  next_.assign(2 * edges_.edges.size(), 0);
  for (const auto& around : leaving_) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      // The walk arrives along the twin of around[i], and leaves along the one before it.
      next_[around[i] ^ 1] = around[(i + around.size() - 1) % around.size()];
    }
  }
  loops_.clear();
  loop_of_.assign(next_.size(), 0);
  std::vector<std::uint8_t> seen(next_.size(), 0);
  for (HalfEdge h = 0; h < next_.size(); ++h) {
    if (seen[h] || dropped_[h / 2]) continue;
    loops_.push_back(walk(h, seen));
    for (const HalfEdge part : loops_.back().half_edges) loop_of_[part] = loops_.size() - 1;
  }
  // The loop around a component has the negative area of all others together, so the lowest one.
  constexpr std::size_t kNoLoop = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> outer(edges_.nodes.size(), kNoLoop);
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    std::size_t& lowest = outer[loops_[i].component];
    if (lowest == kNoLoop || loops_[i].area_mm2 < loops_[lowest].area_mm2) lowest = i;
  }
  for (const std::size_t i : outer) {
    if (i != kNoLoop) loops_[i].outer = true;
  }
}

MapLoop PlanarMap::walk(HalfEdge first, std::vector<std::uint8_t>& seen) const {
  MapLoop loop;
  for (HalfEdge h = first; !seen[h]; h = next_[h]) {
    seen[h] = 1;
    loop.half_edges.push_back(h);
  }
  loop.component = component_[tail(first)];
  measure(loop);
  return loop;
}

void PlanarMap::measure(MapLoop& loop) const {
  const Point origin = edges_.nodes[tail(loop.half_edges.front())];
  for (const HalfEdge h : loop.half_edges) {
    double area = 0.0;
    for (const Cubic& c : edges_.cubics_of(edges_.edges[h / 2])) area += area_under(c, origin);
    loop.box.extend(boxes_[h / 2]);
    loop.area_mm2 += h % 2 == 0 ? area : -area;
  }
}

/// Drops edges with the same loop on both sides. Returns their number.
std::size_t PlanarMap::drop_idle_edges() {
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges_.edges.size(); ++e) {
    dropped_[e] = loop_of_[2 * e] == loop_of_[2 * e + 1] ? 1 : 0;
    count += dropped_[e];
  }
  for (auto& around : leaving_) {
    std::erase_if(around, [&](HalfEdge h) { return dropped_[h / 2] != 0; });
  }
  return count;
}

/// Returns for each loop whether a ray from p crosses it an odd number of times.
std::vector<std::uint8_t> PlanarMap::parities(Point p) const {
  std::vector<std::uint8_t> parity(loops_.size(), 0);
  for (std::size_t e = 0; e < edges_.edges.size(); ++e) {
    const Rect& box = boxes_[e];
    if (dropped_[e] || box.y1 < p.y || box.y0 > p.y || box.x1 < p.x) continue;
    int crossings = 0;
    for (const Cubic& c : edges_.cubics_of(edges_.edges[e])) crossings ^= ray_parity(c, p);
    if (crossings == 0) continue;
    parity[loop_of_[2 * e]] ^= 1;
    parity[loop_of_[2 * e + 1]] ^= 1;
  }
  return parity;
}

std::optional<std::size_t> PlanarMap::loop_around(Point p) const {
  const auto inside = parities(p);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    if (!inside[i] || loops_[i].outer) continue;
    if (!best || loops_[i].area_mm2 < loops_[*best].area_mm2) best = i;
  }
  return best;
}

std::vector<std::size_t> PlanarMap::holes_in(std::size_t loop) const {
  const MapLoop& face = loops_[loop];
  std::vector<std::size_t> holes;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    const MapLoop& hole = loops_[i];
    if (!hole.outer || hole.component == face.component) continue;
    const Point p = edges_.nodes[tail(hole.half_edges.front())];
    if (!face.box.contains(p)) continue;
    // The smallest loop of other components around the point is the face that contains the hole.
    const auto inside = parities(p);
    std::optional<std::size_t> around;
    for (std::size_t k = 0; k < loops_.size(); ++k) {
      if (!inside[k] || loops_[k].outer || loops_[k].component == hole.component) continue;
      if (!around || loops_[k].area_mm2 < loops_[*around].area_mm2) around = k;
    }
    if (around == loop) holes.push_back(i);
  }
  return holes;
}

}  // namespace felt
