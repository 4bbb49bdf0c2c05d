#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/geometry/nearest.h"
#include "felt/geometry/rect.h"

namespace felt {

/// What a segment in the tree belongs to, in the caller's numbers; the tree only carries it, and
/// prefers the lower one at equal distances.
struct SegmentRef {
  std::uint64_t stroke = 0;
  std::uint32_t segment = 0;

  friend constexpr auto operator<=>(const SegmentRef&, const SegmentRef&) noexcept = default;
};

/// One segment given to the tree.
struct BvhSegment {
  Cubic curve;
  SegmentRef ref;
};

/// Limit on the work of one nearest query. The default keeps any query, adversarial ones included,
/// near 100 us of CPU: a node costs about 20 ns (100 ns when it has to come from memory), a piece
/// of a curve (nearest.h) about 80 ns.
struct BvhWorkCap {
  int nodes = 384;
  int pieces = 640;
};

/// A bounding-volume hierarchy over cubic segments: nearest segment, segments in a rectangle.
///
/// Shape: every node has up to 8 children and holds their 8 boxes as four rows of 8 floats, rounded
/// outwards, so that one pass of vector arithmetic tests them all. There are no pointers: levels
/// are arrays packed to the left, and the children of node j of a level are the nodes 8j .. 8j + 7
/// of the level below. The lowest level holds the tight boxes of the segments, which lie in an
/// array in the same order. 10^6 segments: 7 levels, 107 bytes a segment with the curve itself.
///
/// Life of a tree:
///  1. `build` sorts the segments (allocates). Their *handles* are 0, 1, ... in the order given.
///  2. `nearest`, `for_each_in`: const, no allocation, any number of threads at once.
///  3. `refit` or `erase` when a segment changed: no allocation, under 1 us; not during a query.
///     A copy of the tree is an independent snapshot.
///  4. When `rebuild_advised`, `rebuild` sorts again (allocates); handles stay.
///
/// Segments with a coordinate that is not finite are kept but never found. Coordinates beyond
/// 1e18 mm are found, but without pruning among them.
class SegmentBvh {
 public:
  /// Names no segment.
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// A question: what is nearest to `point`?
  struct Query {
    Point point;
    /// Nothing farther is reported; NaN finds nothing.
    double radius_mm = std::numeric_limits<double>::infinity();
    /// Handle of a segment likely to be near, such as the last hit; it only saves time.
    std::uint32_t seed = kNone;
    BvhWorkCap cap{};
  };

  /// The answer, the best known when the work cap was reached.
  struct Hit {
    std::uint32_t handle = kNone;  ///< the segment; kNone when nothing was found in the radius
    SegmentRef ref;                ///< what it belongs to
    Nearest nearest;               ///< the point on it; meaningless when nothing was found
    /// True when no segment in the tree is nearer (up to 1e-14 of the sizes involved); false when
    /// the cap ended the search first.
    bool proven = true;
    BvhWorkCap used{0, 0};  ///< work done

    /// True when something was found.
    [[nodiscard]] explicit operator bool() const noexcept { return handle != kNone; }
  };

  /// An empty tree: finds nothing.
  SegmentBvh() = default;

  /// Replaces the content. Requires at most 2^31 segments.
  void build(std::span<const BvhSegment> segments);
  /// Sorts the present segments anew.
  void rebuild();

  /// The segment nearest to the query's point. Of segments at exactly the same distance the lowest
  /// reference, then the lowest handle, as far as the search met them.
  [[nodiscard]] Hit nearest(const Query& query) const noexcept;

  /// Calls visit(handle) for every segment whose tight box shares a point with `area`, in no
  /// particular order; boxes are rounded outwards to float.
  template <class Visit>
  void for_each_in(const Rect& area, Visit visit) const {
    walk(
        area, [](void* to, std::uint32_t handle) { (*static_cast<Visit*>(to))(handle); }, &visit);
  }

  /// Changes the curve of a segment; boxes above follow. Requires handle < size().
  void refit(std::uint32_t handle, const Cubic& curve) noexcept;
  /// The handle stands for another segment from now on: how a freed handle is used again, likewise.
  void replace(std::uint32_t handle, const BvhSegment& segment) noexcept;
  /// Makes a segment unfindable until it is refitted: its curve becomes NaN. Requires
  /// handle < size().
  void erase(std::uint32_t handle) noexcept;

  /// Sum of the half perimeters of the inner boxes against that after the last build; queries slow
  /// down in proportion. 1 for a fresh tree.
  [[nodiscard]] double degradation() const noexcept;
  /// True once degradation() exceeds 1.3.
  [[nodiscard]] bool rebuild_advised() const noexcept { return degradation() > 1.3; }

  /// Number of segments, erased ones included.
  [[nodiscard]] std::size_t size() const noexcept { return curves_.size(); }
  /// The segment's present curve. Requires handle < size().
  [[nodiscard]] const Cubic& curve(std::uint32_t handle) const noexcept {
    return curves_[slots_[handle]];
  }
  [[nodiscard]] SegmentRef ref(std::uint32_t handle) const noexcept { return refs_[handle]; }

 private:
  static constexpr unsigned kFanOut = 8;
  static constexpr unsigned kMaxLevels = 11;  // 8^11 > 2^31

  // The boxes of 8 children. An absent child has an empty box: lows +infinity, highs -infinity.
  struct alignas(64) Node {
    std::array<float, kFanOut> x0, y0, x1, y1;
  };
  struct Box;
  struct NodeAt;
  struct Sorter;
  class NearestSearch;

  // A function pointer and its argument, so that there is neither std::function nor allocation.
  void walk(const Rect& area, void (*visit)(void*, std::uint32_t), void* argument) const;
  static unsigned children_in(const Box& box, const Node& n) noexcept;
  [[nodiscard]] const Node& node(NodeAt at) const noexcept;
  void lay_out(std::span<const BvhSegment> segments, std::span<const std::uint32_t> order);
  void fill_inner_levels() noexcept;
  void set_box(std::uint32_t slot, const Box& box) noexcept;

  std::vector<Node> nodes_;             // level by level, the lowest first
  std::vector<Cubic> curves_;           // by slot: the order of the lowest boxes
  std::vector<std::uint32_t> handles_;  // slot -> handle
  std::vector<std::uint32_t> slots_;    // handle -> slot
  std::vector<SegmentRef> refs_;        // by handle
  std::array<std::size_t, kMaxLevels> level_begin_{};
  unsigned levels_ = 0;
  double inner_half_perimeters_ = 0.0;
  double built_half_perimeters_ = 0.0;
};

}  // namespace felt
