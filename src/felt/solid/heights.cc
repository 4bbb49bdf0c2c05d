#include "felt/solid/heights.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace felt {
namespace poisson {

constexpr double kSource = 4.0;
constexpr int kOnBorder = -1;

/// The system of equations for the inner points.
struct System {
  std::vector<int> unknown;  // by point; kOnBorder: u = 0
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load;
};

/// Adds a triangle: half of the cotangent of each angle to the opposite edge, and a third of the
/// load to each corner.
void add_triangle(System& system, const std::array<int, 3>& at, const std::array<Point, 3>& p) {
  const double twice_area = cross(p[1] - p[0], p[2] - p[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (at[k] != kOnBorder) system.load[at[k]] += kSource * twice_area / 6.0;
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double weight = 0.5 * dot(p[i] - p[k], p[j] - p[k]) / twice_area;
    if (at[i] != kOnBorder) system.entries.emplace_back(at[i], at[i], weight);
    if (at[j] != kOnBorder) system.entries.emplace_back(at[j], at[j], weight);
    if (at[i] == kOnBorder || at[j] == kOnBorder) continue;
    system.entries.emplace_back(at[i], at[j], -weight);
    system.entries.emplace_back(at[j], at[i], -weight);
  }
}

System system_of(const PlaneMesh& mesh, const std::vector<std::uint8_t>& on_border) {
  System system;
  int count = 0;
  for (const std::uint8_t fixed : on_border) {
    system.unknown.push_back(fixed ? kOnBorder : count++);
  }
  system.load = Eigen::VectorXd::Zero(count);
  for (const auto& t : mesh.triangles) {
    add_triangle(system, {system.unknown[t[0]], system.unknown[t[1]], system.unknown[t[2]]},
                 {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  }
  return system;
}

std::vector<double> shortest_edges(const PlaneMesh& mesh) {
  std::vector<double> shortest(mesh.points.size(), std::numeric_limits<double>::infinity());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const double length = distance(mesh.points[a], mesh.points[b]);
      shortest[a] = std::min(shortest[a], length);
      shortest[b] = std::min(shortest[b], length);
    }
  }
  return shortest;
}

}  // namespace poisson

Result<std::vector<double>> inflated_heights(const PlaneMesh& mesh,
                                             const std::vector<std::uint8_t>& on_border) {
  using namespace poisson;
  System system = system_of(mesh, on_border);
  const auto count = system.load.size();
  std::vector<double> heights(mesh.points.size(), 0.0);
  if (count == 0) return heights;
  if (static_cast<std::size_t>(count) == mesh.points.size()) {
    return fail(ErrorCode::kInvalidArgument, "no point is on the border");
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(system.entries.begin(), system.entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) {
    return fail(ErrorCode::kInvalidData, "the heights of the body cannot be computed");
  }
  const Eigen::VectorXd u = factors.solve(system.load);
  constexpr double kMinShare = 0.01;
  const std::vector<double> shortest = shortest_edges(mesh);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (system.unknown[i] == kOnBorder) continue;
    const double squared = u[system.unknown[i]];
    const double height = squared > 0.0 ? std::sqrt(squared) : 0.0;  // NaN: 0
    heights[i] = std::max(height, kMinShare * shortest[i]);
  }
  return heights;
}

}  // namespace felt
