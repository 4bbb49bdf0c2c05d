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
/// points, and marks on the selected ink. It is updated incrementally: each sample reads a part of
/// the selection, so a selection of 10^5 strokes costs no more per sample than one of fifteen. A
/// selection of up to kPointsPerLook points is up to date after every look().
///
///   view.look(scene.document, scene.selection);   // each sample
///   view.draw(overlay);
///
/// Strokes on hidden or locked layers are ignored, because tools must not change them. Edit thread
/// only.
class SelectionView {
 public:
  /// Control points read by one look(): 30 us at most, even for strokes that are scattered in
  /// memory.
  static constexpr std::size_t kPointsPerLook = 500;
  /// Maximum number of marked segments. In a larger selection the first ones are marked, and a
  /// frame is drawn around all of it.
  static constexpr std::size_t kMaxSpans = 2'000;
  static constexpr double kBesideMm = 3.0;

  /// Reads the next part of the selection, continuing where the last call ended.
  void look(const Document& document, const Selection& selection);
  /// Reads the whole selection. Linear in its size.
  void look_at_all(const Document& document, const Selection& selection);
  /// Discards the pass in progress, because its data is out of date; the next look() starts a new
  /// one.
  void start_over() noexcept { looked_at_ = {}; }

  [[nodiscard]] bool empty() const noexcept { return seen_.strokes == 0; }
  /// Returns the box around the selected control points; empty if there are none.
  [[nodiscard]] const Rect& box() const noexcept { return seen_.box; }
  /// Returns box() extended by the marked segments and by the part of their half width beyond
  /// kBesideMm.
  [[nodiscard]] const Rect& ink_box() const noexcept { return seen_.ink_box; }
  /// Returns a hash of the ids, marks and box: it changes whenever other points are selected or
  /// they move.
  [[nodiscard]] std::uint64_t fingerprint() const noexcept { return seen_.fingerprint; }
  /// Returns the hash without the box: equal for the same marks on the same strokes, wherever they
  /// lie.
  [[nodiscard]] std::uint64_t marks_fingerprint() const noexcept { return seen_.marks; }
  [[nodiscard]] std::size_t stroke_count() const noexcept { return seen_.strokes; }
  /// Returns the number of strokes that are only partly selected.
  [[nodiscard]] std::size_t partial_count() const noexcept { return seen_.partial; }

  /// Adds marks for the selected ink (kSelected) and for the parts of strokes that would be bent
  /// (kSpan).
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
    std::vector<Overlay::Span> spans;
  };

  /// Reads up to `points` control points. Returns true if that completes the pass.
  bool go_on(const Document& document, const Selection& selection, std::size_t points);
  void add(StrokeId id, const Stroke& stroke, const Selection::Marks& marks);

  Sight seen_;          // result of the last complete pass
  Sight round_;         // pass in progress
  StrokeId looked_at_;  // last stroke read in this pass, 0 at its start
};

/// Returns true if tools may change the stroke: its layer is visible and not locked. Requires a
/// stroke of the document.
bool is_editable(const Document& document, StrokeId id);

}  // namespace felt
