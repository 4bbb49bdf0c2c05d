#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/stroke/fit/curve_fitter.h"
#include "felt/stroke/fit/guide_curve.h"
#include "felt/stroke/fit/kept_samples.h"
#include "felt/stroke/fit/long_run.h"

namespace felt {

/// Fits a whole stroke again at pen-up, with fewer segments within the same tolerance.
///
/// While drawing, CurveFitter must place each joint before later samples arrive. At pen-up, all
/// samples are available, and a beam search tries several joints. Each round starts from the best
/// partial curves of m segments, at most kBeam. For each of them, the round finds the longest run
/// (consecutive samples that one more cubic fits), and cuts this run at the fractions kReaches, or
/// only at its end if a corner is there. Of these candidates with m + 1 segments, the round keeps
/// those that cover most ink. The first candidate that covers all ink is the result. Fits, corners
/// and guarantees are those of CurveFitter.
///
/// The time is linear in the number of samples, about kBeam times the time of the online fit. Any
/// thread may use a Refiner, but only one at a time. Buffers are kept between strokes.
class Refiner {
 public:
  static constexpr std::size_t kBeam = 8;
  static constexpr double kReaches[] = {0.88, 0.8, 0.7};
  /// Of the candidates that cover the same samples, at most this many are kept.
  static constexpr std::size_t kPerJoint = 2;

  explicit Refiner(const CurveFitOptions& options);

  /// Discards the last stroke and starts a new one.
  void begin();
  /// Adds the next sample. Requires finite coordinates of at most 1e9 mm.
  void push(Point p);
  /// Makes end() accept only curves within the tolerance of `online`, so that the visible line
  /// moves by at most the tolerance when the result replaces it. Requires that CurveFitter made
  /// `online` from the same samples. Call after the last push().
  void follow(const FittedCurve& online);
  /// Returns the curve with the fewest segments found. Returns an empty curve if the stroke is a
  /// dot or has no samples, or if no curve that stays close enough to `online` is found.
  FittedCurve end();

 private:
  /// One segment of a partial curve; `parent` is the segment before it.
  struct Node {
    std::size_t parent = 0;
    Cubic segment{};
    JointKind joint = JointKind::kCorner;  // kind of the joint at its start
    std::size_t first = 0, count = 0;      // samples that it covers
    std::size_t places = 0;                // index of their parameters in places_
  };
  /// A partial curve: its last segment, and how the next one starts.
  struct Partial {
    std::size_t node = 0;
    RunStart start;
    std::size_t first = 0;
  };
  /// The longest run from a partial curve.
  struct Run {
    Partial from;
    Cubic curve{};
    std::vector<double> t;
    bool ends_at_corner = false;
    bool is_last = false;
  };
  /// A position at which to cut a run.
  struct Cut {
    std::size_t run = 0;
    std::size_t joint = 0;  // index in the run
  };

  void find_next_corners();
  void find_run(const Partial& from, Run& run);
  void find_longest(const Partial& from, Run& run);
  bool place_samples(RunPlacer& placer, Run& run) const;
  void add_cuts(std::size_t run_index);
  void keep_best_cuts();
  [[nodiscard]] std::size_t next_first(const Cut& cut) const noexcept;
  Partial extend(const Cut& cut);
  [[nodiscard]] FittedCurve assemble(std::size_t node) const;

  KeptSamples kept_;
  GuideCurve guide_;
  LongRun search_;
  std::vector<std::size_t> run_limits_;  // for each sample: one past the next corner, or the end
  std::vector<Node> nodes_;
  std::vector<double> places_;
  std::vector<Partial> beam_;
  std::vector<Run> runs_;
  std::size_t run_count_ = 0;
  std::vector<Cut> cuts_;
};

}  // namespace felt
