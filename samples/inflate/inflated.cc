#include "inflated.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "disc_mesh.h"
#include "felt/geometry/polyline.h"
#include "felt/stroke/outline/outline.h"

using felt::Point;

namespace {

/// Largest distance of the mesh's outline from the stroke.
constexpr double kToleranceMm = 0.02;
constexpr double kMaxEdgesRound = 1000.0;

struct Neighbour {
  std::size_t point;
  double weight;  // 1 / distance^2
};

std::vector<std::vector<Neighbour>> neighbours(const DiscMesh& disc) {
  std::vector<std::vector<Neighbour>> all(disc.points().size());
  for (const auto& triangle : disc.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      // An inner edge belongs to two triangles, with opposite directions, so each direction is
      // added once.
      const auto a = static_cast<std::size_t>(triangle[k]);
      const auto b = static_cast<std::size_t>(triangle[(k + 1) % 3]);
      const double d = distance(disc.points()[a], disc.points()[b]);
      all[a].push_back({b, 1.0 / std::max(d * d, 1e-12)});
    }
  }
  return all;
}

/// Solves laplace u = -3 by Gauss-Seidel with over-relaxation. At a point with k neighbours at
/// distances l_j, laplace u ~ 4/k sum (u_j - u)/l_j^2.
std::vector<double> squared_heights(const DiscMesh& disc) {
  constexpr double kSource = 3.0, kOver = 1.8;
  const auto around = neighbours(disc);
  std::vector<double> u(disc.points().size(), 0.0);
  for (int round = 0; round < 2000; ++round) {
    double change = 0.0, most = 0.0;
    for (std::size_t i = static_cast<std::size_t>(disc.outline_count()); i < u.size(); ++i) {
      double sum = 0.25 * kSource * static_cast<double>(around[i].size()), weights = 0.0;
      for (const Neighbour& n : around[i]) {
        sum += n.weight * u[n.point];
        weights += n.weight;
      }
      const double next = std::max(u[i] + kOver * (sum / weights - u[i]), 1e-9);
      change = std::max(change, std::abs(next - u[i]));
      most = std::max(most, next);
      u[i] = next;
    }
    if (change <= 1e-7 * most) break;
  }
  return u;
}

}  // namespace

felt::Result<Mesh> inflated(const felt::Stroke& stroke, int edges_across) {
  if (!stroke.closed()) {
    return felt::fail(felt::ErrorCode::kInvalidArgument, "only a closed stroke can be inflated");
  }
  std::vector<felt::Dab> dabs;
  felt::flatten(stroke, kToleranceMm, dabs);
  std::vector<Point> outline;
  for (const felt::Dab& dab : dabs) outline.push_back(dab.center);
  const double side_mm = std::sqrt(std::abs(felt::area(outline)));
  // Thin shapes have little area for their length, so the number of edges around is limited as
  // well.
  const double step_mm = std::max(side_mm / std::max(edges_across, 2),
                                  felt::polyline_length(outline) / kMaxEdgesRound);
  const felt::Result<DiscMesh> disc = DiscMesh::fill(outline, step_mm);
  if (!disc) return tl::unexpected(disc.error());

  const std::vector<double> u = squared_heights(*disc);
  Mesh mesh;
  mesh.outline_count = disc->outline_count();
  const auto rim = static_cast<std::size_t>(mesh.outline_count);
  const auto inner = static_cast<int>(u.size() - rim);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Point p = disc->points()[i];
    mesh.points.push_back({p.x, -p.y, i < rim ? 0.0 : std::sqrt(u[i])});
  }
  for (std::size_t i = rim; i < u.size(); ++i) {
    mesh.points.push_back({mesh.points[i].x, mesh.points[i].y, -mesh.points[i].z});
  }
  const auto below = [&](int i) { return i < mesh.outline_count ? i : i + inner; };
  for (const auto& [a, b, c] : disc->triangles()) {
    // Triangles go from +x to +y, which is clockwise seen from above once y points up.
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({below(a), below(b), below(c)});
  }
  return mesh;
}

std::string obj_text(const Mesh& mesh) {
  std::string text = "# a closed stroke, inflated; mm\n";
  char line[128];
  for (const felt::Vec3& p : mesh.points) {
    std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
    text += line;
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", a + 1, b + 1, c + 1);
    text += line;
  }
  return text;
}
