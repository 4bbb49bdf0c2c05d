#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "felt/document/stroke_divisions.h"
#include "felt/document/stroke_index.h"
#include "felt/tools/eraser/crossing_span.h"
#include "felt/tools/eraser/eraser_options.h"
#include "felt/tools/eraser/ink_clearance.h"
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
/// Work of a sample: the segments near its capsule, a few cuts, and the crossings of a budget. What
/// does not fit waits for the next samples, until finish() at most. What is to be shown holds all
/// that was erased so far, so it is made as often as eyes can tell, and less often when it is long.
class Erasing {
 public:
  /// How near to a line the pen's way must come to cross it: as good as through it, and less than a
  /// resting hand trembles.
  static constexpr double kPointMm = 0.1;
  /// Work on crossings of one sample (StrokeCrossings::on_segment).
  static constexpr int kCrossingBudget = 120;
  /// Strokes that are cut per millisecond of the pen, and at most by one sample.
  static constexpr int kCutsPerMs = 6;
  static constexpr int kMaxCuts = 64;
  /// A line that was cut is cut again after this pause at the earliest. The pause grows with the
  /// places that a cut goes through (25,000 on a hatching of 5 m: a quarter of a second), so that
  /// all cuts of a gesture together cost time in proportion to how long the gesture lasts.
  static constexpr std::int64_t kCutPauseNs = 4'000'000;
  static constexpr std::int64_t kCutPauseNsPerPlace = 10'000;
  /// Lines that one sample looks at to find those whose pause is over.
  static constexpr int kMaxWaiting = 256;
  /// Time between two previews: 120 Hz, and for many strokes what copying them is worth.
  static constexpr std::int64_t kShowNs = 8'000'000;
  static constexpr std::int64_t kShowNsPerStroke = 10'000;
  static constexpr std::int64_t kShowNsAtMost = 40'000'000;

  Erasing(const EraserSettings& settings, EraserMode mode) noexcept
      : settings_(settings), mode_(mode) {}

  /// The pen touches here. Like move() true when what is left is to be shown anew.
  bool begin(Point pen, std::int64_t time_ns, const Scene& scene);
  /// It has come here since.
  bool move(Point pen, std::int64_t time_ns, const Scene& scene);
  /// No sample follows: does what is left to do.
  void finish(const Scene& scene);

  [[nodiscard]] bool empty() const noexcept { return divisions_.empty(); }
  /// All that was erased so far.
  [[nodiscard]] Edit edit(const Scene& scene) const {
    return divisions_.build(scene.document, "Erase");
  }
  /// Places that all cuts went through so far, for tests.
  [[nodiscard]] std::size_t cut_places() const noexcept { return cut_places_; }

 private:
  struct Line {
    explicit Line(StrokePtr s) : stroke(s), remains(std::move(s)) {}
    /// For what the eraser covers of its ink.
    Line(StrokePtr s, double radius_mm)
        : stroke(s),
          remains(s, Remains::Crumbs::kOfInk),
          ink(std::in_place, std::move(s), radius_mm) {}

    StrokePtr stroke;
    ParameterSet erased;
    Remains remains;
    std::optional<InkClearance> ink;
    std::optional<StrokeCrossings> crossings;
    bool waits = false;                  // to be cut
    std::optional<std::int64_t> cut_ns;  // when it was cut last
    std::size_t cut_places = 0;          // of that cut

    [[nodiscard]] bool is_due(std::int64_t time_ns) const noexcept;
  };
  struct Pending {
    StrokeId stroke;
    ParameterSet::Interval touched;
    SpanSearch search;
  };

  void sweep(Point from, Point to, const Scene& scene);
  void meet(StrokeId id, int segment, const Capsule& capsule, const Scene& scene);
  void meet_touched(StrokeId id, int segment, const Capsule& capsule, const Scene& scene);
  void erase(StrokeId id, ParameterSet::Interval part, const Scene& scene);
  void search(int budget, const Scene& scene);
  Line& line_of(StrokeId id, const Scene& scene);
  const StrokePtr& looked_at(StrokeId id, const Scene& scene);
  void mark(StrokeId id, Line& line);
  void cut(int most, std::int64_t time_ns, const Scene& scene);
  void cut_next(std::int64_t time_ns, const Scene& scene);
  bool shows(std::int64_t time_ns);

  EraserSettings settings_;
  EraserMode mode_;
  Point pen_;
  std::map<StrokeId, Line> lines_;
  std::deque<Pending> pending_;
  StrokeDivisions divisions_;
  std::deque<StrokeId> to_cut_;
  std::size_t cut_places_ = 0;
  bool changed_ = false;       // since what was shown last
  std::int64_t shown_ns_ = 0;  // when that was
  std::int64_t time_ns_ = 0;   // of the last sample
  StrokePtr looked_at_;        // the last stroke that was met, and
  StrokeId looked_at_id_;      // its name
  ParameterSet covered_;       // reused
};

/// What an eraser there would take in kCrossing: the line nearest to the pen and the place on it.
std::optional<StrokeHit> aimed_at(Point pen, const EraserSettings& settings, const Scene& scene);

}  // namespace felt
