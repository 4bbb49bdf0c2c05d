#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "felt/document/document.h"
#include "felt/geometry/rect.h"

namespace felt {

/// Which control points of which strokes are selected (paper, "Transformations": the lasso selects
/// control points, not pixels; specification 5e). A value; no part of the document and of undo, but
/// it follows every edit: strokes that go are no longer selected, strokes that are replaced keep
/// their marks while the number of their points stays, and otherwise only if all were selected.
///
/// The marks of a stroke are one byte for each of StrokeData::points, 1 = selected. The first and
/// the last point of a closed stroke are the same point: its marks agree. Completing marks so that
/// smooth joints stay smooth is point_marks.h's. A stroke without a selected point is not in here.
class Selection {
 public:
  using Marks = std::vector<std::uint8_t>;

  [[nodiscard]] bool empty() const noexcept { return strokes_.empty(); }
  /// Ascending ids.
  [[nodiscard]] const std::map<StrokeId, Marks>& strokes() const noexcept { return strokes_; }
  /// The marks of a stroke, or null.
  [[nodiscard]] const Marks* find(StrokeId id) const noexcept;
  /// True when every point of it is selected.
  [[nodiscard]] bool is_whole(StrokeId id) const noexcept;
  /// Selected control points, the shared point of a closed stroke once for each mention.
  [[nodiscard]] std::size_t point_count() const noexcept;

  /// Replaces the marks of a stroke; none set takes it out. Requires a mark for each point.
  void set(StrokeId id, Marks marks);
  /// All of a stroke of so many control points.
  void set_whole(StrokeId id, std::size_t points);
  void remove(StrokeId id);
  void clear() noexcept { strokes_.clear(); }

  /// Follows an edit that was applied (undo's and redo's too).
  void follow(const Edit& edit);
  /// The same, and strokes that come to stand in a hidden or locked layer are no longer selected:
  /// what is selected is what the next command will touch. `document` is what the edit made. Costs
  /// what the edit changes; one that changes a layer, what is selected.
  void follow(const Edit& edit, const Document& document);
  /// Takes out what cannot be selected in this document: strokes that are not there, stand in a
  /// hidden or locked layer, or have another number of points.
  void hold_to(const Document& document);
  /// Around the selected on-curve points and handles, as they are drawn: empty without any.
  /// Requires the document that it belongs to.
  [[nodiscard]] Rect bounds(const Document& document) const;

  friend bool operator==(const Selection&, const Selection&) = default;

 private:
  std::map<StrokeId, Marks> strokes_;
};

/// Every stroke of visible, unlocked layers, whole.
Selection select_all(const Document& document);

}  // namespace felt
