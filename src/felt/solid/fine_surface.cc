#include "felt/solid/fine_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "felt/geometry/triangle_tree.h"

namespace felt {
namespace surface_division {

constexpr int kMaxPasses = 10, kMaxFlipPasses = 2;
/// The normals at the ends of an inner edge may differ by this factor more than those of the facets
/// beside an edge of the border, which differ by twice the turn to the next point inside.
constexpr double kInnerTurn = 2.0;
/// If there are too many triangles, the normals may turn farther by this factor.
constexpr double kCoarserTurn = 1.2;
/// Edges whose projection to the plane is shorter than this share of the shortest edge stay.
constexpr double kMinFlatShare = 0.1;
using Corners = std::array<std::uint32_t, 3>;

/// A point of the surface: u, and its slope, which is the mean of those of the triangles around the
/// points of the coarse mesh.
struct Node {
  Point at;
  double u = 0.0;
  Vec slope{};
};

/// A triangle with the coarse triangle in which it is.
struct Part {
  Corners corners{};
  std::uint32_t whole = 0;
};

/// The polynomials of the coarse mesh.
class Polynomials {
 public:
  Polynomials(const PlaneMesh& mesh, const SquaredHeights& squares)
      : mesh_(mesh), squares_(squares) {}

  /// Returns the polynomial of a triangle at a point: the value and the slope.
  [[nodiscard]] Node at(std::size_t triangle, Point p) const;

 private:
  const PlaneMesh& mesh_;
  const SquaredHeights& squares_;
};

Node Polynomials::at(std::size_t triangle, Point p) const {
  const Corners& t = mesh_.triangles[triangle];
  const std::array<Point, 3> c{mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]};
  const double twice_area = cross(c[1] - c[0], c[2] - c[0]);
  std::array<double, 3> share{};
  std::array<Vec, 3> rise{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point a = c[(k + 1) % 3], b = c[(k + 2) % 3];
    share[k] = cross(b - a, p - a) / twice_area;
    rise[k] = (1.0 / twice_area) * perp(b - a);
  }
  Node node{p};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double corner = squares_.at_points[t[k]], middle = squares_.at_middles[triangle][k];
    node.u += corner * share[k] * (2.0 * share[k] - 1.0) + 4.0 * middle * share[k] * share[next];
    node.slope += corner * (4.0 * share[k] - 1.0) * rise[k] +
                  4.0 * middle * (share[k] * rise[next] + share[next] * rise[k]);
  }
  return node;
}

/// Divides the triangles of one mesh.
class Division {
 public:
  Division(const PlaneMesh& mesh, const std::vector<std::uint8_t>& on_border,
           const SquaredHeights& squares, const SurfaceSpec& spec);

  /// Returns the surface, or nullopt if it would have too many triangles.
  std::optional<FineSurface> run();

 private:
  /// An edge of a triangle, and the point that divides it.
  struct Cut {
    std::uint32_t low = 0, high = 0, triangle = 0, corner = 0;
  };

  [[nodiscard]] double height(std::uint32_t i) const {
    return std::sqrt(std::max(nodes_[i].u, 0.0));
  }
  [[nodiscard]] Vec3 normal(std::uint32_t i) const;
  [[nodiscard]] bool is_too_long(std::uint32_t a, std::uint32_t b) const;
  void add_between(const Cut& edge);
  bool divide_once();
  enum class FlipChoice : std::uint8_t { kWithinWhole, kAll };
  bool flip_once(FlipChoice choice);
  [[nodiscard]] std::vector<Cut> sides() const;
  [[nodiscard]] bool flips(const Part& part, std::size_t corner, std::uint32_t across) const;
  [[nodiscard]] Vec3 at(std::uint32_t i) const {
    return {nodes_[i].at.x, nodes_[i].at.y, height(i)};
  }
  void divide(const Part& part, const std::array<std::int64_t, 3>& middle);
  [[nodiscard]] double length(std::uint32_t a, std::uint32_t b) const;

  Polynomials polynomials_;
  SurfaceSpec spec_;
  double min_cosine_, min_inner_cosine_;
  std::vector<Node> nodes_;
  std::vector<std::uint8_t> on_border_;
  std::vector<Part> parts_, divided_;
};

Division::Division(const PlaneMesh& mesh, const std::vector<std::uint8_t>& on_border,
                   const SquaredHeights& squares, const SurfaceSpec& spec)
    : polynomials_(mesh, squares),
      spec_(spec),
      min_cosine_(std::cos(spec.max_turn_rad)),
      min_inner_cosine_(std::cos(std::min(kInnerTurn * spec.max_turn_rad, std::numbers::pi))),
      on_border_(on_border) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    nodes_.push_back({mesh.points[i], squares.at_points[i]});
  }
  std::vector<double> weights(nodes_.size(), 0.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const double area = cross(nodes_[b].at - nodes_[a].at, nodes_[c].at - nodes_[a].at);
    for (const std::uint32_t k : mesh.triangles[i]) {
      nodes_[k].slope += area * polynomials_.at(i, nodes_[k].at).slope;
      weights[k] += area;
    }
    parts_.push_back({mesh.triangles[i], static_cast<std::uint32_t>(i)});
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (weights[i] > 0.0) nodes_[i].slope = (1.0 / weights[i]) * nodes_[i].slope;
  }
}

/// Returns the normal of z = sqrt(u).
Vec3 Division::normal(std::uint32_t i) const {
  const Vec slope = nodes_[i].slope;
  const Vec3 n{-slope.x, -slope.y, 2.0 * height(i)};
  const double length = norm(n);
  return length > 0.0 ? (1.0 / length) * n : Vec3{0.0, 0.0, 1.0};
}

double Division::length(std::uint32_t a, std::uint32_t b) const {
  return std::hypot(distance(nodes_[a].at, nodes_[b].at), height(a) - height(b));
}

bool Division::is_too_long(std::uint32_t a, std::uint32_t b) const {
  if (on_border_[a] && on_border_[b]) return false;
  // Both sides of the body have the edges at the border, so the surface turns twice as far there.
  const double cosine = on_border_[a] || on_border_[b] ? min_cosine_ : min_inner_cosine_;
  if (dot(normal(a), normal(b)) >= cosine || length(a, b) <= 2.0 * spec_.min_edge_mm) return false;
  return distance(nodes_[a].at, nodes_[b].at) > kMinFlatShare * spec_.min_edge_mm;
}

/// Adds the parts of a divided triangle. `middle` has the points that divide its edges, or -1.
void Division::divide(const Part& part, const std::array<std::int64_t, 3>& middle) {
  const auto count = std::count_if(middle.begin(), middle.end(), [](auto m) { return m >= 0; });
  std::size_t turn = 0;  // so that edge 0 is divided, and edge 2 is not, unless all are
  while (count > 0 && count < 3 && (middle[turn] < 0 || middle[(turn + 2) % 3] >= 0)) ++turn;
  const auto corner = [&](std::size_t k) { return part.corners[(turn + k) % 3]; };
  const auto point = [&](std::size_t k) {
    return static_cast<std::uint32_t>(middle[(turn + k) % 3]);
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    divided_.push_back({{a, b, c}, part.whole});
  };
  switch (count) {
    case 0:
      divided_.push_back(part);
      return;
    case 1:
      add(corner(0), point(0), corner(2));
      add(point(0), corner(1), corner(2));
      return;
    case 2:
      add(point(0), corner(1), point(1));
      // The shorter diagonal of the rest.
      if (length(corner(0), point(1)) <= length(point(0), corner(2))) {
        add(corner(0), point(0), point(1));
        add(corner(0), point(1), corner(2));
      } else {
        add(corner(0), point(0), corner(2));
        add(point(0), point(1), corner(2));
      }
      return;
    default:
      add(corner(0), point(0), point(2));
      add(point(0), corner(1), point(1));
      add(point(2), point(1), corner(2));
      add(point(0), point(1), point(2));
  }
}

/// Returns both sides of all edges, next to each other.
std::vector<Division::Cut> Division::sides() const {
  std::vector<std::size_t> starts(nodes_.size() + 1, 0);  // of the sides with each lower end
  const auto for_each_side = [this](auto&& visit) {
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = parts_[i].corners[k], b = parts_[i].corners[(k + 1) % 3];
        visit(Cut{std::min(a, b), std::max(a, b), i, k});
      }
    }
  };
  for_each_side([&](const Cut& cut) { ++starts[cut.low + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<Cut> all(3 * parts_.size());
  std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
  for_each_side([&](const Cut& cut) { all[next[cut.low]++] = cut; });
  for (std::size_t low = 0; low < nodes_.size(); ++low) {
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(starts[low]),
              all.begin() + static_cast<std::ptrdiff_t>(starts[low + 1]),
              [](const Cut& a, const Cut& b) {
                return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
              });
  }
  return all;
}

/// Returns true if the two triangles at the edge from `corner` of a part to the next corner become
/// less narrow if they get their other diagonal, as in a Delaunay triangulation: if the angles
/// opposite to the edge have a sum above 180 degrees. `across` is the corner beyond the edge.
bool Division::flips(const Part& part, std::size_t corner, std::uint32_t across) const {
  const std::uint32_t a = part.corners[corner], b = part.corners[(corner + 1) % 3];
  const std::uint32_t c = part.corners[(corner + 2) % 3], d = across;
  if (on_border_[c] && on_border_[d]) return false;
  const auto turn = [this](std::uint32_t u, std::uint32_t v, std::uint32_t w) {
    return cross(nodes_[v].at - nodes_[u].at, nodes_[w].at - nodes_[u].at);
  };
  constexpr double kMinTurnShare = 0.02;
  const double min_turn = kMinTurnShare * (turn(a, b, c) + turn(b, a, d));
  if (turn(c, a, d) <= min_turn || turn(d, b, c) <= min_turn) return false;
  const auto cotangent = [this, a, b](std::uint32_t tip) {
    const Vec3 u = at(a) - at(tip), v = at(b) - at(tip);
    return dot(u, v) / std::max(norm(cross(u, v)), 1e-300);
  };
  return cotangent(c) + cotangent(d) < -1e-3;
}

/// Gives pairs of triangles their other diagonal (flips()). Returns false if there is none.
bool Division::flip_once(FlipChoice choice) {
  const std::vector<Cut> all = sides();
  std::vector<std::uint8_t> is_changed(parts_.size(), 0);
  bool any = false;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Cut &one = all[i - 1], &two = all[i];
    if (one.low != two.low || one.high != two.high) continue;
    Part &first = parts_[one.triangle], &second = parts_[two.triangle];
    if (is_changed[one.triangle] || is_changed[two.triangle]) continue;
    if (choice == FlipChoice::kWithinWhole && first.whole != second.whole) continue;
    const std::uint32_t across = second.corners[(two.corner + 2) % 3];
    if (!flips(first, one.corner, across)) continue;
    const std::uint32_t a = first.corners[one.corner], b = first.corners[(one.corner + 1) % 3];
    const std::uint32_t c = first.corners[(one.corner + 2) % 3];
    first.corners = {c, a, across};
    second.corners = {across, b, c};
    is_changed[one.triangle] = is_changed[two.triangle] = 1;
    any = true;
  }
  return any;
}

/// Adds the point that divides an edge: where the height is about the mean of those of the ends,
/// because the normal turns evenly with it.
void Division::add_between(const Cut& edge) {
  const double low = height(edge.low), high = height(edge.high);
  const double t = low + high > 0.0 ? (3.0 * low + high) / (4.0 * (low + high)) : 0.5;
  const Point at = lerp(nodes_[edge.low].at, nodes_[edge.high].at, t);
  nodes_.push_back(polynomials_.at(parts_[edge.triangle].whole, at));
  on_border_.push_back(0);
}

/// Divides all edges that are too long. Returns false if there is none.
bool Division::divide_once() {
  std::vector<std::array<std::int64_t, 3>> middles(parts_.size(), {-1, -1, -1});
  bool any = false, is_cut = false;
  Cut last{1, 0, 0, 0};
  for (const Cut& cut : sides()) {
    if (cut.low != last.low || cut.high != last.high) {
      last = cut;
      is_cut = is_too_long(cut.low, cut.high);
      if (is_cut) add_between(cut);
    }
    if (is_cut) middles[cut.triangle][cut.corner] = static_cast<std::int64_t>(nodes_.size()) - 1;
    any = any || is_cut;
  }
  if (!any) return false;
  divided_.clear();
  for (std::size_t i = 0; i < parts_.size(); ++i) divide(parts_[i], middles[i]);
  parts_.swap(divided_);
  return true;
}

std::optional<FineSurface> Division::run() {
  for (int pass = 0; pass < kMaxPasses && divide_once(); ++pass) {
    if (parts_.size() > spec_.max_triangles) return std::nullopt;
    flip_once(FlipChoice::kWithinWhole);
  }
  for (int pass = 0; pass < kMaxFlipPasses && flip_once(FlipChoice::kAll); ++pass) {
  }
  FineSurface surface;
  std::vector<double> shortest(nodes_.size(), std::numeric_limits<double>::infinity());
  for (const Part& part : parts_) {
    surface.mesh.triangles.push_back(part.corners);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = part.corners[k], b = part.corners[(k + 1) % 3];
      const double edge_mm = distance(nodes_[a].at, nodes_[b].at);
      shortest[a] = std::min(shortest[a], edge_mm);
      shortest[b] = std::min(shortest[b], edge_mm);
    }
  }
  constexpr double kMinShare = 0.01;
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    surface.mesh.points.push_back(nodes_[i].at);
    surface.heights.push_back(on_border_[i] ? 0.0 : std::max(height(i), kMinShare * shortest[i]));
  }
  surface.on_border = std::move(on_border_);
  return surface;
}

}  // namespace surface_division

FineSurface fine_surface(const PlaneMesh& mesh, const std::vector<std::uint8_t>& on_border,
                         const SquaredHeights& squares, const SurfaceSpec& spec) {
  using namespace surface_division;
  SurfaceSpec tried = spec;
  while (tried.max_turn_rad < std::numbers::pi) {
    std::optional<FineSurface> surface = Division(mesh, on_border, squares, tried).run();
    if (surface) return *std::move(surface);
    tried.max_turn_rad *= kCoarserTurn;
  }
  // Divides nothing but, if rounding says so, edges between opposite normals.
  tried.max_turn_rad = std::numbers::pi;
  tried.max_triangles = std::numeric_limits<std::size_t>::max();
  return Division(mesh, on_border, squares, tried).run().value();
}

}  // namespace felt
