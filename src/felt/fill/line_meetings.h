#pragma once

#include <map>
#include <span>
#include <vector>

#include "felt/document/segment_forest.h"
#include "felt/geometry/rect.h"

namespace felt {

/// A stroke that can bound fills, and its id. As an update, a null stroke removes the id.
struct FillLine {
  StrokeId id;
  StrokePtr stroke;
};

/// A point that two strokes, or two parts of one stroke, have in common.
struct Meeting {
  double u = 0.0;  ///< parameter on the stroke with the lower id; the lower one on a single stroke
  double v = 0.0;  ///< parameter on the other stroke
  Point point;
};

/// One stroke with everything that the map remembers about it.
struct MeetingLine {
  StrokePtr stroke;
  std::vector<Cubic> segments;
  std::vector<Rect> boxes;  ///< of the segments
  Rect box;                 ///< of the centre line
  double half_mm = 0.0;     ///< half of the largest width
  /// The meetings with itself and with each higher id that it meets.
  std::map<StrokeId, std::vector<Meeting>> meetings;
  std::vector<StrokeId> lower;  ///< the lower ids whose meetings have this stroke
};

/// Strokes, and all points where they meet. An update computes only the meetings of the strokes
/// that changed, with the strokes whose boxes come near theirs.
class LineMeetings {
 public:
  /// Adds, replaces and removes strokes; each id at most once. A stroke that is the same object as
  /// before costs nothing. Returns the boxes of the centre lines that changed, before and after,
  /// grown by half of the stroke's width.
  std::vector<Rect> update(std::span<const FillLine> changes);

  [[nodiscard]] const std::map<StrokeId, MeetingLine>& lines() const noexcept { return lines_; }
  /// Returns the line, or null if there is no such stroke.
  [[nodiscard]] const MeetingLine* find(StrokeId id) const;
  /// Returns the meetings of two strokes, or of a stroke with itself. `u` of a result belongs to
  /// `first`.
  [[nodiscard]] std::vector<Meeting> between(StrokeId first, StrokeId second) const;
  /// Returns the ids of the strokes with a segment whose box intersects the area, ascending.
  [[nodiscard]] std::vector<StrokeId> lines_in(const Rect& area) const;
  /// Returns half of the largest width of all strokes that were ever added, in mm.
  [[nodiscard]] double widest_half_mm() const noexcept { return widest_half_mm_; }

 private:
  void remove(StrokeId id);
  void meet(StrokeId id, std::span<const StrokeId> changed);

  std::map<StrokeId, MeetingLine> lines_;
  SegmentForest segments_;
  double widest_half_mm_ = 0.0;
  double largest_mm_ = 0.0;  // the largest sum of width and height of a segment's box
};

}  // namespace felt
