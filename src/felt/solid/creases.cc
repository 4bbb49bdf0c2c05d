#include "felt/solid/creases.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "felt/geometry/triangle_tree.h"

namespace felt {
namespace crease_search {

/// The corners of all triangles, in groups that share a point.
class Corners {
 public:
  explicit Corners(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<Vec3> facet_normals(const SolidBody& body) {
  std::vector<Vec3> normals;
  normals.reserve(body.triangles.size());
  for (const auto& [a, b, c] : body.triangles) {
    const Vec3 n = cross(body.points[b] - body.points[a], body.points[c] - body.points[a]);
    const double length = norm(n);
    normals.push_back(length > 0.0 ? (1.0 / length) * n : Vec3{});
  }
  return normals;
}

/// Joins the corners at both ends of each edge at which the surface is smooth.
Corners smooth_corners(const SolidBody& body) {
  const std::vector<Vec3> normals = facet_normals(body);
  const double min_cosine = std::cos(kCreaseDeg * std::numbers::pi / 180.0);
  Corners corners(3 * body.triangles.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> starts;  // of directed edges
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    const SolidBody::Triangle& t = body.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = 3 * i + k, to = 3 * i + (k + 1) % 3;
      starts.emplace(std::pair(t[k], t[(k + 1) % 3]), from);
      const auto twin = starts.find({t[(k + 1) % 3], t[k]});
      if (twin == starts.end()) continue;
      const std::size_t other = twin->second / 3;
      if (dot(normals[i], normals[other]) < min_cosine) continue;
      corners.join(to, twin->second);
      corners.join(from, 3 * other + (twin->second % 3 + 1) % 3);
    }
  }
  return corners;
}

}  // namespace crease_search

SolidBody split_at_creases(const SolidBody& body) {
  SolidBody split = body;
  if (body.border_count > 0) return split;
  crease_search::Corners corners = crease_search::smooth_corners(body);
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> point_of_group(3 * body.triangles.size(), kNone);
  std::vector<bool> is_used(body.points.size(), false);
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t at = body.triangles[i][k];
      std::uint32_t& number = point_of_group[corners.root(3 * i + k)];
      if (number == kNone && !is_used[at]) {
        is_used[at] = true;
        number = at;
      } else if (number == kNone) {
        number = static_cast<std::uint32_t>(split.points.size());
        split.points.push_back(body.points[at]);
        if (!body.paint.empty()) split.paint.push_back(body.paint[at]);
      }
      split.triangles[i][k] = number;
    }
  }
  return split;
}

}  // namespace felt
