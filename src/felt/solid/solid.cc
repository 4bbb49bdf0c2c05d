#include "felt/solid/solid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "felt/geometry/triangle_tree.h"

namespace felt {
namespace solid_check {

using Stored = std::array<float, 3>;

Stored stored(const Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

Vec3 restored(const Vec3& p) {
  const Stored s = stored(p);
  return {static_cast<double>(s[0]), static_cast<double>(s[1]), static_cast<double>(s[2])};
}

tl::unexpected<Error> broken(const char* what, const Vec3& p, Point origin) {
  char text[160];
  std::snprintf(text, sizeof text, "%s at (%.2f, %.2f) mm", what, origin.x + p.x, origin.y - p.y);
  return fail(ErrorCode::kInvalidData, text);
}

/// Returns the index of a point that equals another one, or the number of points.
std::size_t repeated_point(const SolidBody& body) {
  std::vector<std::pair<Stored, std::size_t>> all;
  all.reserve(body.points.size());
  for (const Vec3& p : body.points) all.emplace_back(stored(p), all.size());
  std::sort(all.begin(), all.end());
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].first == all[i - 1].first) return all[i].second;
  }
  return all.size();
}

/// Returns true if the triangle is so thin that its normal is only rounding.
bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kMinSine = 1e-5;
  const double longest = std::max({norm_squared(b - a), norm_squared(c - b), norm_squared(a - c)});
  return !(norm(cross(b - a, c - a)) > kMinSine * longest);
}

/// Returns a point of an edge that does not belong to two triangles in opposite directions, or the
/// number of points.
std::size_t open_point(const SolidBody& body) {
  // Both ends in one number, which is sorted faster than a pair.
  const auto edge = [](std::uint32_t from, std::uint32_t to) {
    return static_cast<std::uint64_t>(from) << 32U | to;
  };
  std::vector<std::uint64_t> edges, twins;
  edges.reserve(3 * body.triangles.size());
  twins.reserve(3 * body.triangles.size());
  for (const SolidBody::Triangle& t : body.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back(edge(t[k], t[(k + 1) % 3]));
      twins.push_back(edge(t[(k + 1) % 3], t[k]));
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(twins.begin(), twins.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i] != twins[i] || (i > 0 && edges[i] == edges[i - 1])) return edges[i] >> 32U;
  }
  return body.points.size();
}

}  // namespace solid_check

double volume_mm3(const SolidBody& body) noexcept {
  double six = 0.0;
  for (const auto& [a, b, c] : body.triangles) {
    six += dot(body.points[a], cross(body.points[b], body.points[c]));
  }
  return six / 6.0;
}

std::size_t triangle_count(const Solid& solid) noexcept {
  std::size_t count = 0;
  for (const SolidBody& body : solid.bodies) count += body.triangles.size();
  return count;
}

std::vector<Triangle3> page_triangles(const Solid& solid, double lowered_mm) {
  std::vector<Triangle3> all;
  all.reserve(triangle_count(solid));
  for (const SolidBody& body : solid.bodies) {
    const auto on_page = [&](std::uint32_t i) {
      const Vec3& p = body.points[i];
      return Vec3{solid.origin.x + p.x, solid.origin.y - p.y, p.z - lowered_mm};
    };
    for (const SolidBody::Triangle& t : body.triangles) {
      all.push_back({on_page(t[0]), on_page(t[2]), on_page(t[1])});
    }
  }
  return all;
}

std::vector<Vec3> point_normals(const SolidBody& body) {
  std::vector<Vec3> normals(body.points.size());
  for (const SolidBody::Triangle& t : body.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      // The weights of Max, "Weights for computing vertex normals from facet normals", Journal of
      // Graphics Tools 4, 1999: exact on spheres, however uneven the triangles are.
      const Vec3& at = body.points[t[k]];
      const Vec3 u = body.points[t[(k + 1) % 3]] - at, v = body.points[t[(k + 2) % 3]] - at;
      const double squares = norm_squared(u) * norm_squared(v);
      if (squares > 0.0) normals[t[k]] += (1.0 / squares) * cross(u, v);
    }
  }
  for (Vec3& n : normals) {
    const double length = norm(n);
    n = length > 0.0 ? (1.0 / length) * n : Vec3{0.0, 0.0, 1.0};
  }
  return normals;
}

Result<void> check_body(const SolidBody& body, Point origin) {
  using namespace solid_check;
  for (const Vec3& p : body.points) {
    if (!is_finite(restored(p))) {
      return fail(ErrorCode::kInvalidData, "a coordinate of the body is not a number");
    }
  }
  if (body.triangles.empty()) return fail(ErrorCode::kInvalidData, "the body has no surface");
  if (const std::size_t i = repeated_point(body); i < body.points.size()) {
    return broken("the outline nearly touches itself", body.points[i], origin);
  }
  for (const auto& [a, b, c] : body.triangles) {
    if (is_degenerate(restored(body.points[a]), restored(body.points[b]),
                      restored(body.points[c]))) {
      return broken("the outline is too narrow", body.points[a], origin);
    }
  }
  if (const std::size_t i = open_point(body); i < body.points.size()) {
    return broken("the surface is not closed", body.points[i], origin);
  }
  return {};
}

}  // namespace felt
