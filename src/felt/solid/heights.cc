#include "felt/solid/heights.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

namespace felt {
namespace poisson {

constexpr double kSource = 4.0;
constexpr int kOnBorder = -1;

/// The nodes of quadratic elements: the points of the mesh, then the middles of the edges.
struct Nodes {
  std::vector<std::array<std::size_t, 3>> middles;  // by triangle and corner, as at_middles
  std::vector<int> unknown;                         // kOnBorder: u = 0
  int count = 0;
};

/// One side of an edge, from corner k of a triangle to the next one.
struct EdgeSide {
  std::uint32_t low = 0, high = 0;
  std::size_t triangle = 0, corner = 0;
};

Nodes nodes_of(const PlaneMesh& mesh, const std::vector<std::uint8_t>& on_border) {
  std::vector<EdgeSide> sides;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(mesh.triangles[i][k], mesh.triangles[i][(k + 1) % 3]);
      sides.push_back({low, high, i, k});
    }
  }
  const auto key = [](const EdgeSide& s) { return std::pair(s.low, s.high); };
  std::stable_sort(sides.begin(), sides.end(),
                   [&](const EdgeSide& a, const EdgeSide& b) { return key(a) < key(b); });
  Nodes nodes;
  nodes.middles.resize(mesh.triangles.size());
  for (const std::uint8_t fixed : on_border) {
    nodes.unknown.push_back(fixed ? kOnBorder : nodes.count++);
  }
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    for (; end < sides.size() && key(sides[end]) == key(sides[i]); ++end) {
      nodes.middles[sides[end].triangle][sides[end].corner] = nodes.unknown.size();
    }
    const bool fixed = end - i == 1 && on_border[sides[i].low] && on_border[sides[i].high];
    nodes.unknown.push_back(fixed ? kOnBorder : nodes.count++);
    i = end;
  }
  return nodes;
}

/// Adds a triangle. With g(i, j) the integral of the product of the slopes of the shares (the
/// barycentric coordinates) of corners i and j, the integrals of the products of the quadratic
/// functions at corners (i) and middles (ij) are: i, i: g(i, i); i, j: -g(i, j) / 3; i, ij:
/// 4/3 g(i, j); ij, ij: 8/3 (g(i, i) + g(j, j) + g(i, j)); ij, ik: 8/3 g(j, k); else 0. The load is
/// a third of the area on each middle.
void add_triangle(const std::array<int, 6>& at, const std::array<Point, 3>& p,
                  std::vector<Eigen::Triplet<double>>& entries, Eigen::VectorXd& load) {
  const double twice_area = cross(p[1] - p[0], p[2] - p[0]);
  std::array<std::array<double, 3>, 3> g{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double weight = 0.5 * dot(p[i] - p[k], p[j] - p[k]) / twice_area;
    g[i][j] = g[j][i] = -weight;
    g[i][i] += weight, g[j][j] += weight;
  }
  const auto add = [&](std::size_t a, std::size_t b, double value) {
    if (at[a] != kOnBorder && at[b] != kOnBorder) entries.emplace_back(at[a], at[b], value);
  };
  const auto add_both = [&](std::size_t a, std::size_t b, double value) {
    add(a, b, value);
    add(b, a, value);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;  // node 3 + i is in the middle of i and j
    add(i, i, g[i][i]);
    add_both(i, j, -g[i][j] / 3.0);
    add_both(i, 3 + i, 4.0 / 3.0 * g[i][j]);
    add_both(j, 3 + i, 4.0 / 3.0 * g[i][j]);
    add(3 + i, 3 + i, 8.0 / 3.0 * (g[i][i] + g[j][j] + g[i][j]));
    add_both(3 + i, 3 + j, 8.0 / 3.0 * g[i][k]);
    if (at[3 + i] != kOnBorder) load[at[3 + i]] += kSource * twice_area / 6.0;
  }
}

}  // namespace poisson

Result<SquaredHeights> squared_heights(const PlaneMesh& mesh,
                                       const std::vector<std::uint8_t>& on_border) {
  using namespace poisson;
  if (std::none_of(on_border.begin(), on_border.end(), [](std::uint8_t on) { return on != 0; })) {
    return fail(ErrorCode::kInvalidArgument, "no point is on the border");
  }
  const Nodes nodes = nodes_of(mesh, on_border);
  SquaredHeights u{std::vector<double>(mesh.points.size(), 0.0),
                   std::vector<std::array<double, 3>>(mesh.triangles.size())};
  if (nodes.count == 0) return u;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(nodes.count);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const auto& [ab, bc, ca] = nodes.middles[i];
    add_triangle({nodes.unknown[a], nodes.unknown[b], nodes.unknown[c], nodes.unknown[ab],
                  nodes.unknown[bc], nodes.unknown[ca]},
                 {mesh.points[a], mesh.points[b], mesh.points[c]}, entries, load);
  }
  Eigen::SparseMatrix<double> matrix(nodes.count, nodes.count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) {
    return fail(ErrorCode::kInvalidData, "the heights of the body cannot be computed");
  }
  const Eigen::VectorXd solved = factors.solve(load);
  if (!solved.allFinite()) {
    return fail(ErrorCode::kInvalidData, "the heights of the body cannot be computed");
  }
  const auto value = [&](std::size_t node) {
    return nodes.unknown[node] == kOnBorder ? 0.0 : solved[nodes.unknown[node]];
  };
  for (std::size_t i = 0; i < u.at_points.size(); ++i) u.at_points[i] = value(i);
  for (std::size_t i = 0; i < u.at_middles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) u.at_middles[i][k] = value(nodes.middles[i][k]);
  }
  return u;
}

}  // namespace felt
