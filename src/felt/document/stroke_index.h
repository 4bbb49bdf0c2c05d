#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "felt/document/document.h"
#include "felt/stroke/stroke_tip.h"

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

/// Where the strokes of a document are, for tools: so far the ends of open strokes, for snapping.
///
/// A uniform grid. An update costs the changed strokes only; a query the cells that its circle
/// covers and that are not empty, and the ends in them. Answers do not depend on the order in which
/// strokes came. One thread.
class StrokeIndex {
 public:
  /// Of an empty document. Cells are about as large as the usual radius (specification 5g, M).
  explicit StrokeIndex(double cell_mm = 8.0) noexcept : cell_mm_(cell_mm) {}
  explicit StrokeIndex(const Document& document, double cell_mm = 8.0);

  /// Follows an edit that was applied to the document. Must see all of them, in order.
  void update(const Edit& edit);

  /// The nearest end within radius_mm of a place on visible layers, or nothing. Ends in `except`
  /// do not count. Of several at the same distance the lowest id. `document` is the one indexed.
  [[nodiscard]] std::optional<TipHit> nearest_tip(const Document& document, Point place,
                                                  double radius_mm,
                                                  std::span<const TipId> except = {}) const;
  /// Number of ends known.
  [[nodiscard]] std::size_t tip_count() const noexcept { return tips_; }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;  // row, column
  struct Entry {
    TipId id;
    Point point;
  };

  [[nodiscard]] std::int64_t line_of(double mm) const noexcept;
  void add(StrokeId id, const Stroke& stroke);
  void remove(StrokeId id, const Stroke& stroke);

  double cell_mm_;
  std::map<Cell, std::vector<Entry>> cells_;
  std::size_t tips_ = 0;
};

}  // namespace felt
