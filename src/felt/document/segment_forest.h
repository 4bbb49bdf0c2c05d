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

/// The segments of strokes that come, go and change all the time: nearest one, those in a
/// rectangle.
///
/// One SegmentBvh over everything cannot take new segments without sorting all of them again, half
/// a second for 10^6. So there are many small ones, the *leaves*, of at most kLeafSegments, and one
/// over their boxes (an R-tree of two storeys). What changes concerns a leaf or a few:
///
///  * a segment that stays within the box of its leaf is refitted in place;
///  * one that leaves it, or is new, goes to the leaf around its middle that has to grow least;
///  * a full leaf is cut in two, a degraded one sorted again: both sort kLeafSegments at most.
///
/// So there is no rare big rebuild: the worst that an edit can meet is a cut in two for each of its
/// segments and one sort of the leaves' boxes. Segments of very different size never share a leaf,
/// or a line across the sheet would make a small leaf a big one.
///
/// Queries are const, and any number of threads may ask at once; they do not allocate. A value.
class SegmentForest {
 public:
  static constexpr std::size_t kLeafSegments = 512;

  /// What becomes of a stroke; null for one that goes.
  struct Change {
    StrokeId id;
    std::shared_ptr<const Stroke> after;
  };

  struct Hit {
    StrokeId stroke;
    int segment = 0;
    Nearest nearest;
  };

  /// Work of one query, for tests of how it grows.
  struct Work {
    int leaves = 0;
    int nodes = 0;   ///< of the leaves
    int pieces = 0;  ///< of curves (nearest.h)
  };

  /// Brings these strokes in, changes and removes them. Linear in their segments times the
  /// logarithm of all; many new ones at once are sorted in, together with what is there.
  void update(std::span<const Change> changes);

  /// The segment nearest to `place`, within radius_mm. Of several at the same distance the lowest
  /// stroke and segment, as far as they were met. Its work is bounded as SegmentBvh's is. `work`,
  /// if asked for, is what it took.
  [[nodiscard]] std::optional<Hit> nearest(Point place, double radius_mm,
                                           Work* work = nullptr) const;
  /// Calls visit(StrokeId, int segment) for every segment whose box (of the curve, without its
  /// width) meets the area, in no particular order.
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
  /// Leaves that hold anything.
  [[nodiscard]] std::size_t leaf_count() const noexcept {
    return leaves_.size() - free_leaves_.size();
  }
  /// Segments that were sorted because a leaf was cut, sorted again or made, since the beginning:
  /// what edits cost beyond their own segments, for tests.
  [[nodiscard]] std::uint64_t sorted_count() const noexcept { return sorted_; }
  /// Leaves whose boxes were sorted likewise.
  [[nodiscard]] std::uint64_t sorted_leaf_count() const noexcept { return sorted_leaves_; }

 private:
  struct Leaf {
    SegmentBvh tree;  // holes have a curve of NaN
    Rect box;         // around all segments; only grows between two tidyings
    int size_class = 0;
    std::size_t live = 0;
    std::size_t changes = 0;           // since it was tidied
    std::vector<std::uint32_t> holes;  // handles that are free
  };
  /// Where a segment is.
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
  /// Replaces the content, with some holes to spare.
  void fill(std::uint32_t leaf, std::span<const BvhSegment> segments);
  void cut(std::uint32_t leaf);
  void tidy_if_due(std::uint32_t leaf);
  void show_box(std::uint32_t leaf);
  void sort_leaves();
  void build(std::vector<BvhSegment> segments);
  [[nodiscard]] std::vector<BvhSegment> live_segments(std::uint32_t leaf) const;

  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> free_leaves_;
  SegmentBvh leaf_boxes_;  // handle = leaf; the diagonal of its box stands for it
  std::map<StrokeId, std::vector<Place>> places_;  // by segment
  std::size_t segments_ = 0;
  std::size_t box_changes_ = 0;  // since the boxes were sorted
  std::uint64_t sorted_ = 0;
  std::uint64_t sorted_leaves_ = 0;
};

}  // namespace felt
