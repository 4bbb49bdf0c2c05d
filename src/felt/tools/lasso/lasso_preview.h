#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/stroke_index.h"
#include "felt/tools/lasso/lasso_take.h"
#include "felt/tools/overlay.h"

namespace felt {

/// While the user draws a lasso, marks the ink that the lasso would select if it ended now. With
/// each sample, look() does a part of the work: it searches a few patches of the page for new
/// strokes and tests some of the strokes already found, in turn. So with fifty strokes the marks
/// are at most 20 ms old, with a thousand at most half a second. A sample takes tens of
/// microseconds, whatever the size of the document. The final selection does not depend on these
/// marks; taken_by() computes it.
class LassoPreview {
 public:
  /// Maximum number of tested strokes, and also of marked segments.
  static constexpr std::size_t kMaxStrokes = 2'000;

  void begin();
  /// Continues the search with the current outline, which this function closes. `bounds` is the box
  /// around the outline.
  void look(std::span<const Point> outline, const Rect& bounds, LassoTake take,
            const Document& document, const StrokeIndex& index);
  void draw(Overlay& overlay) const;
  /// Returns the number of strokes that are currently marked.
  [[nodiscard]] std::size_t count() const noexcept;

 private:
  struct Candidate {
    StrokeId id;
    std::vector<Overlay::Span> spans;  // the selected segments
  };
  struct Patch {
    std::int64_t column = 0, row = 0;
  };

  void cover(const Rect& bounds);
  void find_strokes(const StrokeIndex& index);
  void test_strokes(LassoTake take, const Document& document);

  std::deque<Patch> patches_;  // still to be searched
  Patch low_, high_;           // the patches covered are [low, high)
  bool gave_up_ = false;       // the area is too large for a preview
  std::set<StrokeId> known_;
  std::vector<Candidate> candidates_;
  std::size_t next_ = 0;  // index of the next candidate to test
  std::optional<LassoArea> area_;
  std::size_t looks_ = 0;
};

}  // namespace felt
