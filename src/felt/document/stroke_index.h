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

/// One end of a stroke of a document, by name.
struct TipId {
  StrokeId stroke;
  StrokeTip tip = StrokeTip::kStart;

  friend auto operator<=>(const TipId&, const TipId&) noexcept = default;
};

/// An end that was found.
struct TipHit {
  TipId id;
  Point point;
  double distance_mm = 0.0;
};

/// A place on a stroke that was found.
struct StrokeHit {
  StrokeId stroke;
  double u = 0.0;  ///< segment index + t
  Point point;
  double distance_mm = 0.0;
};

/// Where the strokes of a document are, for tools: the ends of open strokes, for snapping, and the
/// segments of all strokes that may be edited, those of visible and unlocked layers.
///
/// Segments lie in a forest of trees a layer (SegmentForest): a query costs the logarithm of their
/// number in each layer that may be edited, an edit about a microsecond a segment. Hiding, locking
/// and showing a layer costs nothing.
/// Ends lie in a uniform grid: a query costs the cells that its circle covers and that are not
/// empty, and the ends in them. Answers do not depend on the order in which strokes came.
///
/// Opening a document of more than kIndexedAtOnce strokes sorts none of them: strokes are sorted
/// when a query or an edit comes near (UnindexedStrokes), about 2 us a segment. One thread; queries
/// change what is sorted.
class StrokeIndex {
 public:
  /// Strokes of a larger width are few: they are kept in a list beside the others.
  static constexpr double kBroadMm = 50.0;
  static constexpr std::size_t kIndexedAtOnce = 20'000;

  /// Of an empty document. Cells are about as large as the usual radius (specification 5g, M).
  explicit StrokeIndex(double cell_mm = 8.0) : cell_mm_(cell_mm) {}
  explicit StrokeIndex(const Document& document, double cell_mm = 8.0,
                       std::size_t indexed_at_once = kIndexedAtOnce);

  /// Follows an edit that was applied, `document` being what it made. Must see all of them, in
  /// order.
  void update(const Edit& edit, const Document& document);

  /// The place on a stroke that may be edited nearest to `place`, within radius_mm, or nothing
  /// (R19, R20). Of several at the same distance the lower stroke and u, as far as they were met.
  [[nodiscard]] std::optional<StrokeHit> nearest(Point place, double radius_mm) const;
  /// Calls visit(StrokeId, int segment) for every segment of a stroke that may be edited whose box
  /// (of the curve, without its width) meets the area; in no particular order.
  template <class Visit>
  void for_each_segment_in(const Rect& area, Visit visit) const {
    index_strokes_in(area);
    for (const auto& [id, layer] : layers_) {
      if (layer.editable) layer.segments.for_each_in(area, visit);
    }
  }
  /// Calls visit(StrokeId, int segment) once for every segment of a stroke that may be edited whose
  /// ink could meet the area, and for some around; in no particular order. Strokes broader than
  /// kBroadMm do not widen the search for all others: each of them is compared with the area.
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
  /// The strokes that may be edited with a segment there, ascending.
  [[nodiscard]] std::vector<StrokeId> strokes_in(const Rect& area) const;

  /// The nearest end within radius_mm of a place on visible layers, or nothing. Ends in `except`
  /// do not count. Of several at the same distance the lowest id. `document` is the one indexed.
  [[nodiscard]] std::optional<TipHit> nearest_tip(const Document& document, Point place,
                                                  double radius_mm,
                                                  std::span<const TipId> except = {}) const;
  /// Calls visit(TipId, Point) for every end in the area, of all layers, in no particular order.
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
  /// Half of the largest width of any stroke that was ever indexed.
  [[nodiscard]] double widest_half_mm() const noexcept { return widest_half_mm_; }
  /// How far a handle of any stroke that was ever indexed lies beyond the box around the two ends
  /// of its segment, hence beyond that of for_each_segment_in(), at most.
  [[nodiscard]] double farthest_handle_mm() const noexcept { return farthest_handle_mm_; }
  /// Number of ends known.
  [[nodiscard]] std::size_t tip_count() const noexcept { return tips_; }
  /// Number of strokes that no query or edit has come near yet.
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
  void remove(StrokeId id, const Stroke& stroke);

  [[nodiscard]] std::optional<StrokeHit> nearest_within_reach(Point place, double radius_mm) const;
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
    SegmentForest segments;
    std::map<StrokeId, Broad> broad;  ///< the strokes broader than kBroadMm

    void update(std::span<const SegmentForest::Change> changes);
  };

  double cell_mm_;
  // Queries move strokes from the last of these to the others.
  mutable std::map<LayerId, LayerSegments> layers_;
  mutable CellGrid<Entry> cells_;
  mutable UnindexedStrokes unindexed_;
  std::size_t tips_ = 0;
  double widest_half_mm_ = 0.0;
  double usual_half_mm_ = 0.0;  // the same of strokes that are not broad
  double farthest_handle_mm_ = 0.0;
};

}  // namespace felt
