#pragma once

#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "felt/document/cell_grid.h"
#include "felt/document/document.h"
#include "felt/document/segment_forest.h"
#include "felt/document/unindexed_strokes.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Names one end of a stroke of a document.
struct TipId {
  StrokeId stroke;
  StrokeTip tip = StrokeTip::kStart;

  friend auto operator<=>(const TipId&, const TipId&) noexcept = default;
};

/// The result of a search for ends.
struct TipHit {
  TipId id;
  Point point;
  double distance_mm = 0.0;
};

/// The strokes that a search finds.
enum class StrokeReach : std::uint8_t {
  kEditable,  ///< those on visible, unlocked layers
  kVisible,   ///< those on visible layers
};

/// The result of a search for the nearest point on strokes.
struct StrokeHit {
  StrokeId stroke;
  double u = 0.0;  ///< segment index + t
  Point point;
  double distance_mm = 0.0;
};

/// A spatial index of a document's strokes, for tools. It finds the ends of open strokes, for
/// snapping, and the segments of all editable strokes. Strokes are editable if their layer is
/// visible and unlocked. Two searches also find strokes on locked layers (StrokeReach).
///
/// The segments of each layer are in a forest of trees (SegmentForest). A query takes logarithmic
/// time in the number of segments of each editable layer. An edit takes about a microsecond per
/// segment. The time to hide, lock or show a layer does not depend on its strokes. Ends are in a
/// uniform grid. A query for ends visits the non-empty cells that its circle covers, and the ends
/// in these cells. Results do not depend on the order in which strokes were added.
///
/// When a document of more than kIndexedAtOnce strokes is opened, no stroke is sorted into the
/// trees and the grid. A stroke is sorted only when a query or an edit comes near it
/// (UnindexedStrokes), which takes about 2 us per segment. Not thread-safe, even for queries,
/// because queries sort strokes.
class StrokeIndex {
 public:
  /// Strokes broader than this, in mm, are kept in a separate list. Such strokes are few.
  static constexpr double kBroadMm = 50.0;
  static constexpr std::size_t kIndexedAtOnce = 20'000;

  /// Creates the index of an empty document. Cells are about as large as the usual search radius
  /// (M of docs/design/forces.md#snap-well).
  explicit StrokeIndex(double cell_mm = 8.0) : cell_mm_(cell_mm) {}
  explicit StrokeIndex(const Document& document, double cell_mm = 8.0,
                       std::size_t indexed_at_once = kIndexedAtOnce);

  /// Updates the index for an edit that was applied; `document` is the document after the edit.
  /// Call it for every edit, in order.
  void update(const Edit& edit, const Document& document);

  /// Returns the point on a stroke nearest to `place`, or nullopt if no such point is within
  /// radius_mm (R19, R20). If several visited points have the same distance, returns the one with
  /// the lowest stroke id and u.
  [[nodiscard]] std::optional<StrokeHit> nearest(Point place, double radius_mm,
                                                 StrokeReach reach = StrokeReach::kEditable) const;
  /// Calls visit(StrokeId, int segment) for every segment of a stroke if the segment's box (of the
  /// curve, without its width) intersects the area. The order is unspecified.
  template <class Visit>
  void for_each_segment_in(const Rect& area, Visit visit,
                           StrokeReach reach = StrokeReach::kEditable) const {
    index_strokes_in(area);
    for (const auto& [id, layer] : layers_) {
      if (layer.is_in(reach)) layer.segments.for_each_in(area, visit);
    }
  }
  /// Calls visit(StrokeId, int segment) once for every segment of an editable stroke if its ink
  /// could intersect the area, and for some other segments near the area. The order is unspecified.
  /// Strokes broader than kBroadMm do not widen the search for other strokes, because each broad
  /// stroke is tested separately.
  template <class Visit>
  void for_each_ink_in(const Rect& area, Visit visit) const {
    const Rect reach = area.inflated(usual_half_mm_);
    index_strokes_in(reach);
    for (const auto& [id, layer] : layers_) {
      if (!layer.editable) continue;
      const auto& broad = layer.broad;
      layer.segments.for_each_in(reach, [&](StrokeId stroke, int segment) {
        if (broad.empty() || !broad.contains(stroke)) visit(stroke, segment);
      });
      for (const auto& [stroke, line] : broad) line.for_each_in(area, stroke, visit);
    }
  }
  /// Returns the ids of the editable strokes with a segment in the area, ascending.
  [[nodiscard]] std::vector<StrokeId> strokes_in(const Rect& area) const;

  /// Returns the end nearest to `place` on visible layers, or nullopt if no end is within
  /// radius_mm. Ignores the ends in `except`. If several ends have the same distance, returns the
  /// one with the lowest id. Requires that `document` is the indexed document.
  [[nodiscard]] std::optional<TipHit> nearest_tip(const Document& document, Point place,
                                                  double radius_mm,
                                                  std::span<const TipId> except = {}) const;
  /// Calls visit(TipId, Point) for every end in the area, in all layers. The order is unspecified.
  template <class Visit>
  void for_each_tip_in(const Rect& area, Visit visit) const {
    index_strokes_in(area);
    for_each_cell_in(cells_, area, cell_mm_, [&](auto cell) {
      for (const Entry& e : cell->second) {
        if (area.contains(e.point)) visit(e.id, e.point);
      }
      return std::next(cell);
    });
  }
  /// Returns half of the largest width, in mm, of all strokes that were ever indexed.
  [[nodiscard]] double widest_half_mm() const noexcept { return widest_half_mm_; }
  /// Returns the largest distance of a handle from the box around the two ends of its segment, over
  /// all strokes that were ever indexed. Every handle is in the box that for_each_segment_in()
  /// tests, or at most this far outside it.
  [[nodiscard]] double farthest_handle_mm() const noexcept { return farthest_handle_mm_; }
  /// Returns the number of ends of open strokes.
  [[nodiscard]] std::size_t tip_count() const noexcept { return tips_; }
  /// Returns the number of strokes that are not sorted yet because no query or edit was near them.
  [[nodiscard]] std::size_t unindexed_count() const noexcept { return unindexed_.size(); }

 private:
  struct Entry {
    TipId id;
    Point point;
  };

  double measure(const Stroke& stroke);
  void add_tips(StrokeId id, const Stroke& stroke) const;
  void index_strokes_in(const Rect& area) const;
  void index(std::span<const UnindexedStrokes::Entry> entries) const;
  void remove_tips(const Edit& edit);

  [[nodiscard]] std::optional<StrokeHit> nearest_within(Point place, double radius_mm,
                                                        StrokeReach reach) const;
  void update_segments(const Edit& edit, const Document& document);

  struct Broad {
    StrokePtr stroke;
    Rect box;  ///< around the curve
    double half_mm = 0.0;

    template <class Visit>
    void for_each_in(const Rect& area, StrokeId id, Visit& visit) const {
      const Rect around = area.inflated(half_mm);
      if (!box.intersects(around)) return;
      for (int i = 0; i < stroke->segment_count(); ++i) {
        if (bounds(stroke->segment(i)).intersects(around)) visit(id, i);
      }
    }
  };
  struct LayerSegments {
    bool editable = true;  ///< visible and not locked
    bool visible = true;
    SegmentForest segments;
    std::map<StrokeId, Broad> broad;  ///< the strokes broader than kBroadMm

    [[nodiscard]] bool is_in(StrokeReach reach) const noexcept {
      return reach == StrokeReach::kVisible ? visible : editable;
    }
    void show(bool is_visible, bool is_locked) noexcept {
      visible = is_visible;
      editable = is_visible && !is_locked;
    }
    void update(std::span<const SegmentForest::Change> changes);
  };

  double cell_mm_;
  // Queries move strokes from `unindexed_` to `layers_` and `cells_`.
  mutable std::map<LayerId, LayerSegments> layers_;
  mutable CellGrid<Entry> cells_;
  mutable UnindexedStrokes unindexed_;
  std::size_t tips_ = 0;
  double widest_half_mm_ = 0.0;
  double usual_half_mm_ = 0.0;  // half of the largest width of the strokes that are not broad
  double farthest_handle_mm_ = 0.0;
};

}  // namespace felt
