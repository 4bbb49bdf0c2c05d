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

/// What is selected, as the lasso shows it and the transform tool takes hold of it: a box round the
/// selected control points, and the selected ink marked. Follows the selection and the document by
/// looking at some of it with each sample, so that a selection of 10^5 strokes costs a sample no
/// more than one of fifteen; one of up to kPointsPerLook points is up to date after every look.
///
///   view.look(scene.document, scene.selection);   // each sample
///   view.draw(overlay);
///
/// Strokes of layers that are hidden or locked do not count: tools leave them alone. Edit thread.
class SelectionView {
 public:
  /// Control points that one look looks at: 30 us at most, of strokes that are far apart in memory.
  static constexpr std::size_t kPointsPerLook = 500;
  /// Marked pieces at most; of a larger selection the first ones are marked, and a frame round all
  /// of it is drawn.
  static constexpr std::size_t kMostSpans = 2'000;
  static constexpr double kBesideMm = 3.0;

  /// Goes on where the last look ended.
  void look(const Document& document, const Selection& selection);
  /// Looks at all of it. Linear in the selection.
  void look_at_all(const Document& document, const Selection& selection);
  /// The next look begins again: what was seen of the round in work is out of date.
  void start_over() noexcept { looked_at_ = {}; }

  [[nodiscard]] bool empty() const noexcept { return seen_.strokes == 0; }
  /// Around the selected control points. Empty without any.
  [[nodiscard]] const Rect& box() const noexcept { return seen_.box; }
  /// Around those and all the ink that is marked, where more of it than kBesideMm lies outside.
  [[nodiscard]] const Rect& ink_box() const noexcept { return seen_.ink_box; }
  /// Another number whenever other points are selected, or lie elsewhere: of their ids, marks and
  /// box.
  [[nodiscard]] std::uint64_t fingerprint() const noexcept { return seen_.fingerprint; }
  /// The same without the box: the same marks on the same strokes, wherever they lie.
  [[nodiscard]] std::uint64_t marks_fingerprint() const noexcept { return seen_.marks; }
  [[nodiscard]] std::size_t stroke_count() const noexcept { return seen_.strokes; }
  /// Strokes of which a part is selected.
  [[nodiscard]] std::size_t partial_count() const noexcept { return seen_.partial; }

  /// Marks the selected ink (kSelected), and what of a stroke would be bent (kSpan).
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

  /// Looks at up to `points` points; true when that was the rest.
  bool go_on(const Document& document, const Selection& selection, std::size_t points);
  void add(StrokeId id, const Stroke& stroke, const Selection::Marks& marks);

  Sight seen_;          // of the last whole round
  Sight round_;         // in work
  StrokeId looked_at_;  // the last of this round, 0 at its start
};

/// Whether tools may change a stroke that is there: its layer is visible and not locked.
bool is_editable(const Document& document, StrokeId id);

}  // namespace felt
