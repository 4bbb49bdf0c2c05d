#pragma once

#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "felt/document/stroke_divisions.h"
#include "felt/tools/eraser/crossing_span.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/eraser/remains.h"
#include "felt/tools/eraser/swept.h"
#include "felt/tools/scene.h"

namespace felt {

/// One gesture of the eraser: what it has erased so far of the strokes as they were at the touch.
///
/// kTouched and kStroke act on all that the eraser covers. kCrossing acts on one line at a time, or
/// a tail could not be taken without what it hangs on: at the touch on the line nearest to the
/// pen, within the radius, and then on each line that the pen's way crosses.
///
/// Work of a sample: the segments near its capsule, cutting the strokes of which something new is
/// covered, the crossings of the budget, and a copy of all that was touched so far.
class Erasing {
 public:
  /// Half of the width of ink that is looked for with adds_half_width: broader ink counts as this
  /// broad when the eraser does not come nearer to its middle.
  static constexpr double kWidestHalfMm = 6.0;
  /// How near to a line the pen's way must come to cross it: as good as through it, and less than a
  /// resting hand trembles.
  static constexpr double kPointMm = 0.1;
  /// Work on crossings of one sample (StrokeCrossings::on_segment).
  static constexpr int kCrossingBudget = 200;

  Erasing(const EraserSettings& settings, EraserMode mode) noexcept
      : settings_(settings), mode_(mode) {}

  /// The pen touches here. Like the others true when more is erased than before.
  bool begin(Point pen, const Scene& scene);
  /// It has come here since.
  bool move(Point pen, const Scene& scene);
  /// No sample follows: does what is left to do.
  bool finish(const Scene& scene);

  [[nodiscard]] bool empty() const noexcept { return divisions_.empty(); }
  /// All that was erased so far.
  [[nodiscard]] Edit edit(const Scene& scene) const {
    return divisions_.build(scene.document, "Erase");
  }

 private:
  struct Line {
    explicit Line(StrokePtr s) : stroke(s), remains(std::move(s)) {}

    StrokePtr stroke;
    ParameterSet erased;
    Remains remains;
    std::optional<StrokeCrossings> crossings;
  };
  struct Pending {
    StrokeId stroke;
    ParameterSet::Interval touched;
    SpanSearch search;
  };

  bool sweep(Point from, Point to, const Scene& scene);
  void meet(StrokeId id, int segment, const Capsule& capsule, const Scene& scene);
  void erase(StrokeId id, ParameterSet::Interval part, const Scene& scene);
  void search(int budget, const Scene& scene);
  Line& line_of(StrokeId id, const Scene& scene);
  bool cut_changed(const Scene& scene);

  EraserSettings settings_;
  EraserMode mode_;
  Point pen_;
  std::map<StrokeId, Line> lines_;
  std::deque<Pending> pending_;
  StrokeDivisions divisions_;
  std::vector<StrokeId> changed_;  // by this sample, perhaps more than once
  StrokePtr looked_at_;            // the last stroke that was met, and
  StrokeId looked_at_id_;          // its name
  ParameterSet covered_;           // reused
};

/// What an eraser there would take in kCrossing: the line nearest to the pen and the place on it.
std::optional<StrokeHit> aimed_at(Point pen, const EraserSettings& settings, const Scene& scene);

}  // namespace felt
