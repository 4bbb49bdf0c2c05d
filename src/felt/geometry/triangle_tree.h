#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/geometry/vec3.h"

namespace felt {

/// A triangle in space, mm. It is seen from the side from which a, b, c turn counterclockwise in a
/// right-handed frame: its normal is (b - a) x (c - a).
struct Triangle3 {
  Vec3 a{};
  Vec3 b{};
  Vec3 c{};
};

/// Where a moving point meets the front of a triangle first.
struct SweepHit {
  double t = 0.0;  ///< 0..1 along the movement
  Vec3 normal{};   ///< unit normal of the triangle
};

/// An immutable bounding volume hierarchy over triangles. Building allocates; sweep() is real-time
/// safe and may be called from several threads.
class TriangleTree {
 public:
  /// Nodes that one sweep may visit. Beyond, it stops (see sweep()).
  static constexpr int kSweepNodes = 512;

  /// Leaves out triangles without area or with a coordinate that is not finite.
  explicit TriangleTree(std::span<const Triangle3> triangles);

  /// Returns the first triangle whose front the segment from `from` to `to` crosses. Edges belong
  /// to both triangles, so that nothing passes between them. If the sweep needs more than
  /// kSweepNodes, or an end is not finite, returns a hit at 0 against the movement: a caller that
  /// stops there is safe.
  [[nodiscard]] std::optional<SweepHit> sweep(const Vec3& from, const Vec3& to) const noexcept;

  /// Returns the number of triangles kept.
  [[nodiscard]] std::size_t size() const noexcept { return faces_.size(); }
  /// Returns the upper corner of the box around the triangles, within 1e-6 mm; zero if there are
  /// none.
  [[nodiscard]] Vec3 high() const noexcept { return nodes_.empty() ? Vec3{} : nodes_[0].high; }

 private:
  struct Face {
    Vec3 a{};
    Vec3 ab{};
    Vec3 ac{};
    Vec3 normal{};
  };
  struct Node {
    Vec3 low{};
    Vec3 high{};
    std::uint32_t first = 0;  // of the faces in a leaf; of the right child in others
    std::uint32_t count = 0;  // 0 in inner nodes
  };

  void build(std::uint32_t first, std::uint32_t count);
  static std::optional<double> crossing(const Face& face, const Vec3& from,
                                        const Vec3& move) noexcept;

  std::vector<Face> faces_;
  std::vector<Node> nodes_;
};

/// Returns the vector product.
constexpr Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace felt
