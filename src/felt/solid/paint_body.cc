#include "felt/solid/paint_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace felt {
namespace body_painting {

constexpr double kEdgeInWidths = 1.0 / 3.0;
constexpr int kMaxPasses = 12;
constexpr double kMinFacing = 0.1;  // cosine between the normals of the surface and the line

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Divides triangles.
class Refinement {
 public:
  explicit Refinement(SolidBody& body) : body_(body) {}

  /// Divides the marked edges of a triangle in the middle.
  void divide(const SolidBody::Triangle& t);
  void mark(std::uint32_t a, std::uint32_t b) { middles_.emplace(edge_of(a, b), kNone); }
  [[nodiscard]] bool has_marks() const { return !middles_.empty(); }
  void run();

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  [[nodiscard]] std::optional<std::uint32_t> middle(std::uint32_t a, std::uint32_t b);

  SolidBody& body_;
  std::map<Edge, std::uint32_t> middles_;
  std::vector<SolidBody::Triangle> divided_;
};

std::optional<std::uint32_t> Refinement::middle(std::uint32_t a, std::uint32_t b) {
  const auto at = middles_.find(edge_of(a, b));
  if (at == middles_.end()) return std::nullopt;
  if (at->second == kNone) {
    at->second = static_cast<std::uint32_t>(body_.points.size());
    body_.points.push_back(0.5 * (body_.points[a] + body_.points[b]));
  }
  return at->second;
}

void Refinement::divide(const SolidBody::Triangle& t) {
  std::array<std::optional<std::uint32_t>, 3> m;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    m[k] = middle(t[k], t[(k + 1) % 3]);
    count += m[k] ? 1 : 0;
  }
  if (count == 0) return divided_.push_back(t);
  if (count == 3) {
    for (std::size_t k = 0; k < 3; ++k) divided_.push_back({t[k], *m[k], *m[(k + 2) % 3]});
    return divided_.push_back({*m[0], *m[1], *m[2]});
  }
  // Rotated so that edge 0 is divided, and edge 2 is not.
  std::size_t k = 0;
  while (!m[k] || m[(k + 2) % 3]) ++k;
  const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = *m[k];
  if (count == 1) {
    divided_.push_back({a, ab, c});
    return divided_.push_back({ab, b, c});
  }
  const std::uint32_t bc = *m[(k + 1) % 3];
  divided_.push_back({ab, b, bc});
  divided_.push_back({a, ab, bc});
  divided_.push_back({a, bc, c});
}

void Refinement::run() {
  for (const SolidBody::Triangle& t : body_.triangles) divide(t);
  body_.triangles = std::move(divided_);
}

/// Divides the long edges of the triangles that the border of a line passes. Returns true if there
/// were some.
bool refine_once(SolidBody& body, const LineSearch& search, double radius, double max_edge) {
  Refinement refinement(body);
  for (const SolidBody::Triangle& t : body.triangles) {
    std::array<double, 3> length{};
    for (std::size_t k = 0; k < 3; ++k) {
      length[k] = norm(body.points[t[(k + 1) % 3]] - body.points[t[k]]);
    }
    const double longest = *std::max_element(length.begin(), length.end());
    if (longest <= max_edge) continue;
    const Vec3 middle = (1.0 / 3.0) * (body.points[t[0]] + body.points[t[1]] + body.points[t[2]]);
    const double distance = search.nearest(middle, radius + longest).distance_mm;
    if (distance > radius + longest || distance + longest < radius) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      // The longest edge always, and the others if they are long: no triangle becomes thinner.
      if (length[k] > std::max(max_edge, 0.55 * longest)) refinement.mark(t[k], t[(k + 1) % 3]);
    }
  }
  if (!refinement.has_marks()) return false;
  refinement.run();
  return true;
}

Rgba mixed(Rgba under, Rgba over, double share) {
  const double over_a = share * over.a / 255.0, under_a = (1.0 - over_a) * under.a / 255.0;
  const double alpha = over_a + under_a;
  if (!(alpha > 0.0)) return {0, 0, 0, 0};
  const auto part = [&](std::uint8_t u, std::uint8_t o) {
    return static_cast<std::uint8_t>(std::lround((over_a * o + under_a * u) / alpha));
  };
  return {part(under.r, over.r), part(under.g, over.g), part(under.b, over.b),
          static_cast<std::uint8_t>(std::lround(255.0 * alpha))};
}

}  // namespace body_painting

void paint_body(SolidBody& body, std::span<const PaintedLine> lines) {
  using namespace body_painting;
  for (const PaintedLine& line : lines) {
    if (line.parts.empty()) continue;
    const LineSearch search(line.parts);
    const double max_edge = kEdgeInWidths * line.width_mm;
    for (int pass = 0; pass < kMaxPasses && body.triangles.size() < kMaxPaintedTriangles; ++pass) {
      if (!refine_once(body, search, 0.5 * line.width_mm, max_edge)) break;
    }
  }
  const std::vector<Vec3> normals = point_normals(body);
  body.paint.assign(body.points.size(), Rgba{0, 0, 0, 0});
  for (const PaintedLine& line : lines) {
    if (line.parts.empty()) continue;
    const LineSearch search(line.parts);
    const double radius = 0.5 * line.width_mm, soft = kEdgeInWidths * radius;
    for (std::size_t i = 0; i < body.points.size(); ++i) {
      const LineSearch::Near near = search.nearest(body.points[i], radius + soft);
      const double share = std::clamp((radius - near.distance_mm) / soft + 0.5, 0.0, 1.0);
      if (share == 0.0 || dot(near.normal, normals[i]) < kMinFacing) continue;
      body.paint[i] = mixed(body.paint[i], line.color, share);
    }
  }
}

}  // namespace felt
