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

/// Marks what a lasso would take so far, while it is drawn. With each sample it looks at a little:
/// one patch of the sheet for strokes it does not know yet, and some of those it knows, turn by
/// turn. So the marks of fifty strokes are 20 ms old at most, those of a thousand half a second,
/// and a sample costs the same in any document (tens of microseconds). What is taken in the end is
/// not decided here, but by taken_by().
class LassoPreview {
 public:
  /// Strokes that are marked at most.
  static constexpr std::size_t kMostStrokes = 2'000;

  void begin();
  /// `outline` as it is now, closed by itself; `bounds` around it.
  void look(std::span<const Point> outline, const Rect& bounds, LassoTake take,
            const Document& document, const StrokeIndex& index);
  void draw(Overlay& overlay) const;
  /// Strokes that are marked now.
  [[nodiscard]] std::size_t count() const noexcept;

 private:
  struct Candidate {
    StrokeId id;
    std::vector<Overlay::Span> spans;  // what is taken of it
  };
  struct Patch {
    std::int64_t column = 0, row = 0;
  };

  void cover(const Rect& bounds);
  void find_strokes(const StrokeIndex& index);
  void test_strokes(LassoTake take, const Document& document);

  std::deque<Patch> patches_;  // to be looked at
  Patch low_, high_;           // the patches covered are [low, high)
  bool gave_up_ = false;       // too large to be marked while it is drawn
  std::set<StrokeId> known_;
  std::vector<Candidate> candidates_;
  std::size_t next_ = 0;  // of candidates_
  std::optional<LassoArea> area_;
  std::size_t looks_ = 0;
};

}  // namespace felt
