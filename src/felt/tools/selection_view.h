#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/base/hash.h"
#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/geometry/rect.h"
#include "felt/tools/overlay.h"

namespace felt {

/// The selection as the lasso and the transform tool show it: a box around the selected control
/// points, and marks on the selected ink. The view is updated incrementally: each sample reads a
/// part of the selection, so a sample takes no longer with a selection of 100,000 strokes than with
/// a selection of fifteen. If the selection has at most kPointsPerLook points, the view is up to
/// date after every look().
///
///   view.look(scene.document, scene.selection);   // each sample
///   view.draw(overlay);
///
/// Strokes on hidden or locked layers are ignored, because tools must not change them. Use it on
/// the edit thread only.
class SelectionView {
 public:
  /// Control points read by one look(): 30 us at most, even for strokes that are scattered in
  /// memory.
  static constexpr std::size_t kPointsPerLook = 500;
  /// Maximum number of marked segments. In a larger selection every second, fourth, eighth, ...
  /// stroke is marked, so that marks are everywhere (of a few very long strokes, the first
  /// segments), and a frame is drawn around the whole selection.
  static constexpr std::size_t kMaxSpans = 2'000;
  static constexpr double kBesideMm = 3.0;

  /// Reads the next part of the selection, continuing where the last call ended.
  void look(const Document& document, const Selection& selection);
  /// Reads the whole selection, in time linear in its size.
  void look_at_all(const Document& document, const Selection& selection);
  /// Discards the pass in progress, so that the next look() starts a new one. Call this when the
  /// strokes that the pass has read have changed.
  void start_over() noexcept { looked_at_ = {}; }

  [[nodiscard]] bool empty() const noexcept { return seen_.strokes == 0; }
  /// Returns the box around the selected control points; empty if no point is selected.
  [[nodiscard]] const Rect& box() const noexcept { return seen_.box; }
  /// Returns box() extended to contain the marked segments, with a margin of half the width of the
  /// ink minus kBesideMm, if this difference is positive.
  [[nodiscard]] const Rect& ink_box() const noexcept { return seen_.ink_box; }
  /// Returns a hash of the ids, marks and box. It changes if other points are selected or the
  /// selected points move.
  [[nodiscard]] std::uint64_t fingerprint() const noexcept { return seen_.fingerprint; }
  /// Returns a hash of the ids and marks only. It stays the same if the same points of the same
  /// strokes are selected, even if these points have moved.
  [[nodiscard]] std::uint64_t marks_fingerprint() const noexcept { return seen_.marks; }
  [[nodiscard]] std::size_t stroke_count() const noexcept { return seen_.strokes; }
  /// Returns the number of strokes that are only partly selected.
  [[nodiscard]] std::size_t partial_count() const noexcept { return seen_.partial; }

  /// Adds marks for the segments that are selected with both joints (kSelected), and for the
  /// segments that are selected only in part, which a transform would bend (kSpan).
  void draw(Overlay& overlay) const;

 private:
  struct Sight {
    Rect box;
    Rect ink_box;
    Fnv1a hash;
    std::uint64_t marks = 0;
    std::uint64_t fingerprint = 0;
    std::size_t strokes = 0;
    std::size_t partial = 0;
    std::size_t stride = 1;  // one stroke of so many is marked
    std::vector<Overlay::Span> spans;
    std::vector<std::size_t> span_ends;  // the number of spans after each marked stroke
  };

  /// Reads up to `points` control points. Returns true if the pass is then complete.
  bool go_on(const Document& document, const Selection& selection, std::size_t points);
  void add(StrokeId id, const Stroke& stroke, const Selection::Marks& marks);
  /// Marks the segments of a stroke, if it is one of those that are marked.
  void mark(const Stroke& stroke, const Selection::Marks& marks);
  /// Unmarks every second of the marked strokes.
  void thin_out();

  Sight seen_;          // result of the last complete pass
  Sight round_;         // pass in progress
  StrokeId looked_at_;  // last stroke read in this pass, 0 at its start
};

/// Returns true if tools may change the stroke: its layer is visible and not locked. Requires a
/// stroke of the document.
bool is_editable(const Document& document, StrokeId id);

}  // namespace felt
