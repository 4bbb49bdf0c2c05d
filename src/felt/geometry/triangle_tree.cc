#include "felt/geometry/triangle_tree.h"

#include <algorithm>
#include <cstddef>

namespace felt {
namespace {

constexpr std::uint32_t kLeafFaces = 4;
// Barycentric coordinates beyond the edges that still count. Rounding at coordinates of 1 m is
// below 1e-12 of an edge of 1 mm.
constexpr double kEdgeSlack = 1e-9;
// Boxes are widened by this, mm, for the same reason.
constexpr double kBoxSlack_mm = 1e-6;
// A start this far behind a front, mm, still counts as in front: rounding (1e-13 mm at coordinates
// of 1 m) puts a point that rests in a valley behind one of its planes. Smaller than the boxes'
// slack.
constexpr double kBehind_mm = 1e-7;

Vec3 lower(const Vec3& a, const Vec3& b) noexcept {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3 upper(const Vec3& a, const Vec3& b) noexcept {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
bool overlap(const Vec3& low, const Vec3& high, const Vec3& low2, const Vec3& high2) noexcept {
  return low.x <= high2.x && low2.x <= high.x && low.y <= high2.y && low2.y <= high.y &&
         low.z <= high2.z && low2.z <= high.z;
}
double along(const Vec3& v, int axis) noexcept {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Triangle3> triangles) {
  faces_.reserve(triangles.size());
  for (const Triangle3& t : triangles) {
    const Vec3 normal = cross(t.b - t.a, t.c - t.a);
    const double length = norm(normal);
    if (!is_finite(normal) || length <= 0.0) continue;
    faces_.push_back({t.a, t.b - t.a, t.c - t.a, (1.0 / length) * normal});
  }
  if (!faces_.empty()) build(0, static_cast<std::uint32_t>(faces_.size()));
}

// Halves the faces at the median of the longest axis: the depth is at most 32.
void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
  const std::size_t at = nodes_.size();
  Node node{faces_[first].a, faces_[first].a, first, count};
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Face& face = faces_[i];
    for (const Vec3& corner : {face.a, face.a + face.ab, face.a + face.ac}) {
      node.low = lower(node.low, corner);
      node.high = upper(node.high, corner);
    }
  }
  const Vec3 slack{kBoxSlack_mm, kBoxSlack_mm, kBoxSlack_mm};
  const Vec3 extent = node.high - node.low;
  node.low -= slack;
  node.high += slack;
  nodes_.push_back(node);
  if (count <= kLeafFaces) return;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto middle = [axis](const Face& f) { return along(3.0 * f.a + f.ab + f.ac, axis); };
  const auto begin = faces_.begin() + static_cast<std::ptrdiff_t>(first);
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half),
                   begin + static_cast<std::ptrdiff_t>(count),
                   [&](const Face& a, const Face& b) { return middle(a) < middle(b); });
  build(first, half);
  nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[at].count = 0;
  build(first + half, count - half);
}

// Moeller and Trumbore 1997, DOI 10.1080/10867651.1997.10487468, fronts only. A start on the plane,
// or behind it by rounding, is a crossing at 0 if the triangle is below the start.
std::optional<double> TriangleTree::crossing(const Face& face, const Vec3& from,
                                             const Vec3& move) noexcept {
  const double closing = -dot(move, face.normal);
  if (!(closing > 0.0)) return std::nullopt;  // parallel, or from behind
  const Vec3 s = from - face.a;
  const double height = dot(s, face.normal);
  if (height < -kBehind_mm || height > closing) return std::nullopt;
  const Vec3 ray = height > 0.0 ? move : -1.0 * face.normal;
  const Vec3 p = cross(ray, face.ac);
  const double det = dot(face.ab, p);
  if (!(det > 0.0)) return std::nullopt;
  const double u = dot(s, p) / det;
  if (u < -kEdgeSlack || u > 1.0 + kEdgeSlack) return std::nullopt;
  const double v = dot(ray, cross(s, face.ab)) / det;
  if (v < -kEdgeSlack || u + v > 1.0 + kEdgeSlack) return std::nullopt;
  return std::max(0.0, height) / closing;
}

std::optional<SweepHit> TriangleTree::sweep(const Vec3& from, const Vec3& to) const noexcept {
  const Vec3 move = to - from;
  if (!is_finite(from) || !is_finite(to)) return SweepHit{};
  if (nodes_.empty() || norm_squared(move) <= 0.0) return std::nullopt;
  const Vec3 low = lower(from, to);
  const Vec3 high = upper(from, to);
  std::optional<SweepHit> first;
  std::array<std::uint32_t, 64> stack{};  // twice the depth
  std::size_t waiting = 1;
  for (int visited = 0; waiting > 0; ++visited) {
    if (visited == kSweepNodes) return SweepHit{0.0, (-1.0 / norm(move)) * move};
    const std::uint32_t at = stack[--waiting];
    const Node& node = nodes_[at];
    if (!overlap(node.low, node.high, low, high)) continue;
    if (node.count == 0) {
      stack[waiting++] = node.first;
      stack[waiting++] = at + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::optional<double> t = crossing(faces_[i], from, move);
      if (t && (!first || *t < first->t)) first = SweepHit{*t, faces_[i].normal};
    }
  }
  return first;
}

}  // namespace felt
