#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "felt/document/edit.h"
#include "felt/geometry/bvh.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Finds the segments nearest to a point or inside a rectangle, in a set of strokes that changes
/// continually.
///
/// A single SegmentBvh cannot add segments without sorting all of them again, which takes half a
/// second for 10^6 segments. So this class has many small trees, the *leaves*, of at most
/// kLeafSegments each, and one tree over their boxes (an R-tree of two levels). A change affects
/// only one leaf or a few:
///
///  * a segment that stays within the box of its leaf is refitted in place;
///  * a new segment, or a segment that leaves the box of its leaf, is stored in a leaf near its
///    middle: the leaf whose box needs to grow least;
///  * a full leaf is split in two, and a degraded leaf is sorted again; either operation sorts at
///    most kLeafSegments segments.
///
/// So no edit rebuilds everything. In the worst case, an edit causes one split for each of its
/// segments and one sort of the leaves' boxes. Segments of very different size never share a leaf,
/// because a line across the page would enlarge the box of a leaf of short segments.
///
/// Queries are const, do not allocate, and may run on any number of threads at the same time.
class SegmentForest {
 public:
  static constexpr std::size_t kLeafSegments = 512;

  /// The change of a stroke; `after` is null if it is removed.
  struct Change {
    StrokeId id;
    std::shared_ptr<const Stroke> after;
  };

  struct Hit {
    StrokeId stroke;
    int segment = 0;
    Nearest nearest;
  };

  /// Work of one query. Tests use it to measure how the work grows with the document.
  struct Work {
    int leaves = 0;
    int nodes = 0;   ///< nodes of the leaves' trees
    int pieces = 0;  ///< pieces of curves (nearest.h)
  };

  /// Adds, changes and removes these strokes. The time is proportional to the number of their
  /// segments times the logarithm of the number of all segments. Many new segments in one call are
  /// sorted together with the existing ones.
  void update(std::span<const Change> changes);

  /// Returns the segment nearest to `place`, or nullopt if no segment is within radius_mm. If
  /// several visited segments have the same distance, returns the one with the lowest stroke id and
  /// segment. The work is bounded as in SegmentBvh. If `work` is not null, stores in it the work
  /// that was done.
  [[nodiscard]] std::optional<Hit> nearest(Point place, double radius_mm,
                                           Work* work = nullptr) const;
  /// Calls visit(StrokeId, int segment) for every segment if its box (of the curve, without its
  /// width) intersects the area. The order is unspecified.
  template <class Visit>
  void for_each_in(const Rect& area, Visit visit) const {
    leaf_boxes_.for_each_in(area, [&](std::uint32_t leaf) {
      const SegmentBvh& tree = leaves_[leaf].tree;
      tree.for_each_in(area, [&](std::uint32_t handle) {
        // Boxes in the tree are rounded outwards.
        if (!felt::bounds(tree.curve(handle)).intersects(area)) return;
        const SegmentRef ref = tree.ref(handle);
        visit(StrokeId{ref.stroke}, static_cast<int>(ref.segment));
      });
    });
  }

  [[nodiscard]] std::size_t stroke_count() const noexcept { return places_.size(); }
  [[nodiscard]] std::size_t segment_count() const noexcept { return segments_; }
  /// Returns the number of leaves that are not empty.
  [[nodiscard]] std::size_t leaf_count() const noexcept {
    return leaves_.size() - free_leaves_.size();
  }
  /// Returns the number of segments that were sorted since construction because a leaf was split,
  /// sorted again or built. This measures the work that edits cause on segments that they do not
  /// change. Used by tests.
  [[nodiscard]] std::uint64_t sorted_count() const noexcept { return sorted_; }
  /// Returns how many boxes of leaves were sorted since construction.
  [[nodiscard]] std::uint64_t sorted_leaf_count() const noexcept { return sorted_leaves_; }

 private:
  struct Leaf {
    SegmentBvh tree;  // holes have a curve of NaN
    Rect box;         // around all segments; only grows until the leaf is sorted again
    int size_class = 0;
    std::size_t live = 0;
    std::size_t changes = 0;           // number of changes since it was sorted
    std::vector<std::uint32_t> holes;  // free handles
  };
  /// Location of a segment: its leaf and handle.
  struct Place {
    std::uint32_t leaf = 0;
    std::uint32_t handle = 0;
  };
  struct Search;

  void change(StrokeId id, const Stroke& after);
  void remove(StrokeId id);
  Place insert(const BvhSegment& segment);
  void erase(Place place);
  [[nodiscard]] std::uint32_t leaf_for(const Rect& box);
  std::uint32_t new_leaf(int size_class);
  /// Replaces the content of a leaf, with some spare holes.
  void fill(std::uint32_t leaf, std::span<const BvhSegment> segments);
  void cut(std::uint32_t leaf);
  void tidy_if_due(std::uint32_t leaf);
  void show_box(std::uint32_t leaf);
  void sort_leaves();
  void build(std::vector<BvhSegment> segments);
  [[nodiscard]] std::vector<BvhSegment> live_segments(std::uint32_t leaf) const;

  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> free_leaves_;
  SegmentBvh leaf_boxes_;  // handle = index of the leaf; the diagonal of its box stands for it
  std::map<StrokeId, std::vector<Place>> places_;  // by segment
  std::size_t segments_ = 0;
  std::size_t box_changes_ = 0;  // number of box changes since the last sort
  std::uint64_t sorted_ = 0;
  std::uint64_t sorted_leaves_ = 0;
};

}  // namespace felt
