#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "felt/document/document.h"
#include "felt/geometry/rect.h"

namespace felt {

/// The selected control points of strokes (paper, "Transformations": the lasso selects control
/// points, not pixels; docs/design/editing.md#lasso). A value type. The selection is not part of
/// the document, and undo does not restore it, but it is updated after every edit. Removed strokes
/// are no longer selected. A replaced stroke keeps its marks if the number of its points stays the
/// same; if it is closed now, its shared point is selected if one of the two points was. If that
/// number changes, the stroke stays selected only if all its points were selected; then all its new
/// points are selected.
///
/// The marks of a stroke are one byte for each of StrokeData::points: 1 if the point is selected,
/// otherwise 0. The first and the last point of a closed stroke are the same point and have the
/// same mark. close_marks() (point_marks.h) also marks the points that must move together with the
/// selected ones, so that smooth joints stay smooth when the selection is moved. A stroke without a
/// selected point is not in the selection.
class Selection {
 public:
  using Marks = std::vector<std::uint8_t>;

  [[nodiscard]] bool empty() const noexcept { return strokes_.empty(); }
  /// Returns the marks of all selected strokes, by ascending ids.
  [[nodiscard]] const std::map<StrokeId, Marks>& strokes() const noexcept { return strokes_; }
  /// Returns the marks of a stroke, or null if it is not selected.
  [[nodiscard]] const Marks* find(StrokeId id) const noexcept;
  /// Returns true if every point of the stroke is selected.
  [[nodiscard]] bool is_whole(StrokeId id) const noexcept;
  /// Returns the number of selected control points; the shared point of a closed stroke counts
  /// twice.
  [[nodiscard]] std::size_t point_count() const noexcept;

  /// Replaces the marks of a stroke; removes the stroke from the selection if no mark is set.
  /// Requires one mark for each point.
  void set(StrokeId id, Marks marks);
  /// Selects all points of a stroke that has `points` control points.
  void set_whole(StrokeId id, std::size_t points);
  void remove(StrokeId id);
  void clear() noexcept { strokes_.clear(); }

  /// Updates the selection for an edit that was applied, also by undo or redo.
  void follow(const Edit& edit);
  /// Does the same as follow(edit), and also deselects strokes that are now in a hidden or locked
  /// layer, because the next command must change exactly what is selected. `document` is the
  /// document after the edit. Takes linear time in the changes of the edit, and also in the
  /// selection if the edit changes a layer.
  void follow(const Edit& edit, const Document& document);
  /// Deselects strokes that cannot be selected in this document: those that do not exist, are in a
  /// hidden or locked layer, or do not have exactly one point for each mark.
  void hold_to(const Document& document);
  /// Returns the box around the selected on-curve points and handles; empty if the selection is
  /// empty. Requires that `document` is the document to which the selection belongs.
  [[nodiscard]] Rect bounds(const Document& document) const;

  friend bool operator==(const Selection&, const Selection&) = default;

 private:
  std::map<StrokeId, Marks> strokes_;
};

/// Returns a selection of all strokes of visible, unlocked layers with all their points.
Selection select_all(const Document& document);

}  // namespace felt
