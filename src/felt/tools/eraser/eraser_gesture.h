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
#include "felt/tools/eraser/guard_ridge.h"
#include "felt/tools/eraser/ink_narrowing.h"
#include "felt/tools/eraser/remaining_pieces.h"
#include "felt/tools/eraser/swept.h"
#include "felt/tools/scene.h"

namespace felt {

/// One gesture of the eraser. It holds the strokes as they were at the touch, and the parts of them
/// that are erased so far.
///
/// kTouched and kStroke act on all ink that the eraser covers. kCrossing acts on one line at a
/// time, because otherwise a tail could not be erased without the line to which it is attached. At
/// the touch, it acts on the line nearest to the pen, if the eraser covers a part of that line
/// (aimed_at()); after the touch, it acts on each line that the path of the pen crosses.
///
/// For each sample, the segments near the path of the pen are processed, a few strokes are cut, and
/// a limited number of crossings is searched. The next samples, or finish(), do the remaining work.
/// A preview contains everything erased so far, so it takes time. Therefore previews are made only
/// as often as the eye can distinguish them, and less often if they are large.
class EraserGesture {
 public:
  /// Maximum distance at which the path of the pen counts as crossing a line. It is less than the
  /// tremor of a resting hand.
  static constexpr double kPointMm = 0.1;
  /// Budget for crossings per sample (StrokeCrossings::on_segment).
  static constexpr int kCrossingBudget = 120;
  /// Number of strokes cut per millisecond of pen time, and the maximum per sample.
  static constexpr int kCutsPerMs = 6;
  static constexpr int kMaxCuts = 64;
  /// Minimum pause before a line is cut again: kCutPauseNs, plus kCutPauseNsPerPlace for each point
  /// that the last cut processed. A hatching of 5 m has 25,000 points, so it is cut at most four
  /// times a second. Therefore the time for all cuts is at most proportional to the duration of the
  /// gesture.
  static constexpr std::int64_t kCutPauseNs = 4'000'000;
  static constexpr std::int64_t kCutPauseNsPerPlace = 10'000;
  /// Maximum number of waiting lines for which one sample checks whether their pause is over.
  static constexpr int kMaxWaiting = 256;
  /// Time between two previews: kShowNs (120 Hz), or kShowNsPerStroke for each stroke if that is
  /// longer, because a preview copies the strokes; at most kMaxShowNs.
  static constexpr std::int64_t kShowNs = 8'000'000;
  static constexpr std::int64_t kShowNsPerStroke = 10'000;
  static constexpr std::int64_t kMaxShowNs = 40'000'000;

  /// Erases no line while `guard` guards it; `guard` may be null, and must outlive this.
  EraserGesture(const EraserSettings& settings, EraserMode mode,
                const GuardRidge* guard = nullptr) noexcept
      : settings_(settings), mode_(mode), guard_(guard) {}

  /// Begins the gesture. Returns true if a new preview is due.
  bool begin(Point pen, std::int64_t time_ns, const Scene& scene);
  /// Moves the pen straight to this position. Returns true if a new preview is due.
  bool move(Point pen, std::int64_t time_ns, const Scene& scene);
  /// Erases the whole lines that the eraser covers now, and from now on all whole lines that it
  /// meets. Returns true if a new preview is due.
  bool press_through(std::int64_t time_ns, const Scene& scene);
  /// Ends the gesture: does all remaining work.
  void finish(const Scene& scene);

  [[nodiscard]] bool empty() const noexcept { return divisions_.empty(); }
  /// Returns everything erased so far as an edit.
  [[nodiscard]] Edit edit(const Scene& scene) const {
    return divisions_.build(scene.document, "Erase");
  }
  /// Returns the number of points that all cuts have processed so far, for tests.
  [[nodiscard]] std::size_t cut_places() const noexcept { return cut_places_; }

 private:
  struct Line {
    explicit Line(StrokePtr s) : stroke(s), remains(std::move(s)) {}
    /// Makes the state of a line in the mode kTouched with include_width: its ink is erased where
    /// the eraser covers it.
    Line(StrokePtr before, StrokePtr s, double radius_mm)
        : original(std::move(before)),
          stroke(s),
          remains(s, RemainingPieces::Crumbs::kOfInk),
          ink(std::in_place, std::move(s), radius_mm) {}

    StrokePtr original{};
    StrokePtr stroke;  // with `ink`, it is the original with the drawn widths as breakpoints
    ParameterSet erased;
    RemainingPieces remains;
    std::optional<InkNarrowing> ink;
    std::optional<StrokeCrossings> crossings;
    bool waits = false;                  // is in to_cut_
    std::optional<std::int64_t> cut_ns;  // time of the last cut
    std::size_t cut_places = 0;          // points processed by that cut

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
  void cut(int max_cuts, std::int64_t time_ns, const Scene& scene);
  void cut_next(std::int64_t time_ns, const Scene& scene);
  bool shows(std::int64_t time_ns);

  EraserSettings settings_;
  EraserMode mode_;
  const GuardRidge* guard_;
  Point pen_;
  std::map<StrokeId, Line> lines_;
  std::deque<Pending> pending_;
  StrokeDivisions divisions_;
  std::deque<StrokeId> to_cut_;
  std::size_t cut_places_ = 0;
  bool changed_ = false;       // true if more was erased since the last preview
  std::int64_t shown_ns_ = 0;  // time of the last preview
  std::int64_t time_ns_ = 0;   // time of the last sample
  StrokePtr looked_at_;        // the last stroke that the sweep met, and
  StrokeId looked_at_id_;      // its id
  ParameterSet covered_;       // buffer, reused for each segment
};

/// Returns the line of which a touch in the mode kCrossing would erase a part: the line nearest to
/// the pen, with its point nearest to the pen. Returns nullopt if the eraser does not reach the ink
/// of that line or, if include_width is off, does not reach its centre line.
std::optional<StrokeHit> aimed_at(Point pen, const EraserSettings& settings, const Scene& scene);

}  // namespace felt
