#include "felt/solid/testing/surface.h"

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace felt::testing {
namespace surface_exam {

using Edge = std::pair<std::size_t, std::size_t>;
using Corner = Surface::Corner;

std::array<double, 3> minus(const Corner& a, const Corner& b) {
  std::array<double, 3> d{};
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = static_cast<double>(a[k]) - static_cast<double>(b[k]);
  }
  return d;
}

std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const std::array<double, 3>& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

struct Groups {
  std::vector<std::size_t> parent;
  explicit Groups(std::size_t n) : parent(n) {
    std::iota(parent.begin(), parent.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent[root(a)] = root(b); }
  std::size_t count() {
    std::size_t roots = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) roots += root(i) == i ? 1 : 0;
    return roots;
  }
};

/// Returns a fault of the coordinates of a triangle, or an empty text.
std::string triangle_fault(const Corner& a, const Corner& b, const Corner& c) {
  for (const Corner& p : {a, b, c}) {
    for (const float v : p) {
      if (!std::isfinite(v)) return "a coordinate is not finite";
    }
  }
  const double longest = std::max({length(minus(b, a)), length(minus(c, b)), length(minus(a, c))});
  const double height = length(cross(minus(b, a), minus(c, a))) / longest;
  return height > 1e-6 * longest ? "" : "a triangle is degenerate";
}

/// Returns the number of fans of triangles around each point: 1 where the surface is one sheet.
std::vector<std::size_t> fans(const Surface& surface, const std::map<Edge, std::size_t>& owner) {
  Groups corners(3 * surface.triangles.size());
  const auto slot = [&](std::size_t triangle, std::size_t point) {
    std::size_t k = 0;
    while (surface.triangles[triangle][k] != point) ++k;
    return 3 * triangle + k;
  };
  for (const auto& [edge, triangle] : owner) {
    const auto twin = owner.find({edge.second, edge.first});
    if (twin == owner.end()) continue;
    corners.join(slot(triangle, edge.first), slot(twin->second, edge.first));
    corners.join(slot(triangle, edge.second), slot(twin->second, edge.second));
  }
  std::vector<std::size_t> count(surface.points.size(), 0);
  for (std::size_t i = 0; i < corners.parent.size(); ++i) {
    if (corners.root(i) == i) ++count[surface.triangles[i / 3][i % 3]];
  }
  return count;
}

}  // namespace surface_exam

Surface surface_of(const SolidBody& body) {
  Surface surface;
  for (const Vec3& p : body.points) {
    surface.points.push_back(
        {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  for (const auto& [a, b, c] : body.triangles) surface.triangles.push_back({a, b, c});
  return surface;
}

Surface welded(const Surface& surface) {
  Surface result;
  std::map<Surface::Corner, std::size_t> numbers;
  const auto number = [&](std::size_t i) {
    const auto [at, is_new] = numbers.emplace(surface.points[i], result.points.size());
    if (is_new) result.points.push_back(surface.points[i]);
    return at->second;
  };
  for (const auto& [a, b, c] : surface.triangles) {
    const std::size_t x = number(a), y = number(b), z = number(c);
    result.triangles.push_back({x, y, z});
  }
  return result;
}

SurfaceReport examine(const Surface& surface) {
  using namespace surface_exam;
  SurfaceReport report;
  std::map<Edge, std::size_t> owner;
  Groups points(surface.points.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& t = surface.triangles[i];
    const Corner &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    if (const std::string fault = triangle_fault(a, b, c); !fault.empty()) report.fault = fault;
    const Corner zero{};
    const auto normal = cross(minus(b, zero), minus(c, zero));
    const auto at = minus(a, zero);
    report.volume_mm3 += (at[0] * normal[0] + at[1] * normal[1] + at[2] * normal[2]) / 6.0;
    for (std::size_t k = 0; k < 3; ++k) {
      points.join(t[k], t[(k + 1) % 3]);
      if (!owner.emplace(Edge{t[k], t[(k + 1) % 3]}, i).second) {
        report.fault = "an edge has two triangles in one direction";
      }
    }
  }
  for (const auto& [edge, triangle] : owner) {
    if (!owner.contains({edge.second, edge.first})) report.fault = "an edge has one triangle";
  }
  for (const std::size_t count : fans(surface, owner)) {
    if (count != 1) report.fault = "a point has " + std::to_string(count) + " fans of triangles";
  }
  report.components = points.count();
  report.euler = static_cast<int>(surface.points.size()) - static_cast<int>(owner.size() / 2) +
                 static_cast<int>(surface.triangles.size());
  return report;
}

}  // namespace felt::testing
