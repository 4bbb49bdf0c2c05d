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

/// The caller's reference to a segment: its stroke, and its index in that stroke. The tree only
/// stores it, and uses it to choose between segments that are equally near (nearest()).
struct SegmentRef {
  std::uint64_t stroke = 0;
  std::uint32_t segment = 0;

  friend constexpr auto operator<=>(const SegmentRef&, const SegmentRef&) noexcept = default;
};

/// One segment to be stored in the tree.
struct BvhSegment {
  Cubic curve;
  SegmentRef ref;
};

/// Limit on the work of one nearest query. The default limits any query, even an adversarial one,
/// to about 100 us of CPU time: a node takes about 20 ns (100 ns if it is not in the cache), and a
/// piece of a curve (nearest.h) about 80 ns.
struct BvhWorkCap {
  int nodes = 384;
  int pieces = 640;
};

/// A bounding-volume hierarchy over cubic segments. Finds the nearest segment and the segments in a
/// rectangle.
///
/// Structure: every node has up to 8 children and stores their boxes as four rows of 8 floats,
/// rounded outwards, so that one pass of vector arithmetic tests all eight. Nodes have no pointers:
/// each level is an array without gaps, and the children of node j of a level are the nodes 8j ..
/// 8j + 7 of the level below. The lowest level has the tight boxes of the segments, which are
/// stored in an array in the same order. For 10^6 segments the tree has 7 levels and takes 107
/// bytes per segment, including the curve.
///
/// Life cycle:
///  1. `build` sorts the segments (allocates). Their *handles* are 0, 1, ... in the order given.
///  2. `nearest` and `for_each_in` are const, allocate nothing, and may run on several threads.
///  3. If a segment changes, call `refit` or `erase`, but not during a query. Both take under 1 us
///     and do not allocate. A copy of the tree is an independent snapshot.
///  4. If `rebuild_advised` returns true, call `rebuild`, which sorts again (allocates); handles
///    stay the same.
///
/// Segments with a coordinate that is not finite are stored but never found. Segments beyond 1e18
/// mm are found, but a query has to visit all of them.
class SegmentBvh {
 public:
  /// The handle that refers to no segment.
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// A query for the segment nearest to `point`.
  struct Query {
    Point point;
    /// Segments farther away than this are not reported. If the radius is NaN, nothing is found.
    double radius_mm = std::numeric_limits<double>::infinity();
    /// Handle of a segment that is probably near, such as the last hit. It only makes the search
    /// faster.
    std::uint32_t seed = kNone;
    BvhWorkCap cap{};
  };

  /// The result: the nearest segment, or the best found until the work cap was reached.
  struct Hit {
    std::uint32_t handle = kNone;  ///< the segment; kNone if nothing was found within the radius
    SegmentRef ref;                ///< the caller's reference of the segment
    Nearest nearest;               ///< the point on it; unspecified if nothing was found
    /// True if no segment in the tree is nearer (up to 1e-14 of the sizes involved); false if the
    /// work cap ended the search first.
    bool proven = true;
    BvhWorkCap used{0, 0};  ///< the work that was done

    /// Returns true if a segment was found.
    [[nodiscard]] explicit operator bool() const noexcept { return handle != kNone; }
  };

  /// Creates an empty tree, which finds nothing.
  SegmentBvh() = default;

  /// Replaces the content. Requires at most 2^31 segments.
  void build(std::span<const BvhSegment> segments);
  /// Sorts the current segments again; handles stay the same. Resets degradation().
  void rebuild();

  /// Returns the segment nearest to the query's point. If the search visited several segments at
  /// exactly this distance, returns the one with the lowest reference or, if references are equal,
  /// the lowest handle.
  [[nodiscard]] Hit nearest(const Query& query) const noexcept;

  /// Calls visit(handle) for every segment whose tight box (rounded outwards to float) intersects
  /// `area`, in no particular order.
  template <class Visit>
  void for_each_in(const Rect& area, Visit visit) const {
    walk(
        area, [](void* to, std::uint32_t handle) { (*static_cast<Visit*>(to))(handle); }, &visit);
  }

  /// Changes the curve of a segment and updates the boxes above it. Requires handle < size().
  void refit(std::uint32_t handle, const Cubic& curve) noexcept;
  /// Assigns another segment to a handle, for example to reuse the handle of an erased segment.
  /// Requires handle < size().
  void replace(std::uint32_t handle, const BvhSegment& segment) noexcept;
  /// Removes a segment from all results until `refit` or `replace`: its curve becomes NaN. Requires
  /// handle < size().
  void erase(std::uint32_t handle) noexcept;

  /// Returns the sum of the half perimeters of the inner boxes, divided by the same sum after the
  /// last build. It is 1 for a new tree; query times grow in proportion to it.
  [[nodiscard]] double degradation() const noexcept;
  /// Returns true if degradation() exceeds 1.3.
  [[nodiscard]] bool rebuild_advised() const noexcept { return degradation() > 1.3; }

  /// Returns the number of segments, including erased ones.
  [[nodiscard]] std::size_t size() const noexcept { return curves_.size(); }
  /// Returns the current curve of a segment. Requires handle < size().
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

  // Takes a function pointer and its argument instead of a std::function, which could allocate.
  void walk(const Rect& area, void (*visit)(void*, std::uint32_t), void* argument) const;
  static unsigned children_in(const Box& box, const Node& n) noexcept;
  [[nodiscard]] const Node& node(NodeAt at) const noexcept;
  void lay_out(std::span<const BvhSegment> segments, std::span<const std::uint32_t> order);
  void fill_inner_levels() noexcept;
  void set_box(std::uint32_t slot, const Box& box) noexcept;

  std::vector<Node> nodes_;             // level by level, the lowest first
  std::vector<Cubic> curves_;           // by slot, in the order of the lowest boxes
  std::vector<std::uint32_t> handles_;  // slot -> handle
  std::vector<std::uint32_t> slots_;    // handle -> slot
  std::vector<SegmentRef> refs_;        // by handle
  std::array<std::size_t, kMaxLevels> level_begin_{};
  unsigned levels_ = 0;
  double inner_half_perimeters_ = 0.0;
  double built_half_perimeters_ = 0.0;
};

}  // namespace felt
