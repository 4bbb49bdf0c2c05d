#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "felt/geometry/cubic.h"
#include "felt/stroke/fit/sample_window.h"
#include "felt/stroke/stroke.h"

namespace felt {

class GuideCurve;

/// The fitters make segments at least this long: what I5 asks and a little for rounding.
inline constexpr double kShortestSegmentMm = 1.001 * kMinSegmentMm;

/// What is already decided about the start of a segment.
struct RunStart {
  enum class Kind {
    kFree,     ///< first segment of a stroke: nothing
    kPoint,    ///< B1: after a corner
    kTangent,  ///< B1 and its tangent: after a smooth joint (G1)
  };
  Kind kind = Kind::kFree;
  Point point;
  Vec tangent;  ///< unit length
};

/// Fits one cubic to a run of samples.
///
/// Both B4 and, on a free start, B1 may leave their samples: joints are places on the ink, not
/// samples, so their noise is averaged away like all other noise. This halves the number of
/// segments at noise-level tolerances (docs/decisions/0004-joints-leave-the-samples.md).
///
/// Minimised is  sum_i w_i |f(t_i) - P_i|^2_M + n kEnergy |f'''/6|^2 + n kRidge |B - B_chord|^2,
/// with w_i the weight of a sample (SampleWindow) and n the sum of all:
/// the distance to the curve's tangent line at the foot point, a little of the distance along it
/// (segment_fit_kernels.h), and two small terms that decide what the samples leave open. The jerk
/// f'''/6 = B4 - 3 B3 + 3 B2 - B1 is zero on parabolas and small on arcs, so it keeps curls out
/// without flattening round shapes. Each round solves for the control points and moves every t_i
/// one Newton step to its foot point; 2 to 4 rounds do what 10 of the ordinary least squares do.
///
/// Accepted is a curve that passes within (tolerance - slack) of every sample *in the order of the
/// samples*: t_i never decreases. Between neighbours it stays within tolerance + kGapBulge x gap
/// of the straight line that joins them, so there is no loop or spike that no sample sees.
///
/// Thread: any, one fitter per thread. No allocation after construction; bounded work.
class SegmentFit {
 public:
  /// Most samples of a window that one fit looks at. A longer run is thinned (LongRun).
  static constexpr std::size_t kMaxRun = 256;
  /// Least-squares rounds of one fit at most.
  static constexpr int kMaxRounds = 8;
  /// Most work of one fit, in samples x rounds.
  static constexpr long kMaxWork = static_cast<long>(kMaxRun) * (kMaxRounds + 1);
  static constexpr double kTangentWeight = 0.05;
  static constexpr double kEnergy = 2e-5;
  static constexpr double kRidge = 1e-4;
  /// Handle at a smooth start: between these parts of the chord length of the run.
  static constexpr double kMinHandle = 0.03;
  static constexpr double kMaxHandle = 2.0;
  static constexpr double kGapBulge = 0.1;

  /// Where the curve ends.
  enum class End {
    kFree,    ///< near the last sample, as far as the tolerance allows
    kPinned,  ///< exactly on it
  };

  /// Fits samples [first, first + count) of `window`. True when the curve is accepted; `curve()`
  /// and `parameters()` then hold it. Requires 1 <= count <= kMaxRun and, on a free start,
  /// count >= 2. `known` are the parameters of the first samples on a shorter curve from the same
  /// start; with noise, path lengths are a worse guess than these.
  bool fit(const SampleWindow& window, const RunStart& start, std::size_t first, std::size_t count,
           End end = End::kFree, std::span<const double> known = {}) noexcept;

  /// A curve that needs no fit: from `start` with its tangent to the last of the samples, which
  /// all but the last lie within kMinSegmentMm of the start. Always within the tolerance when that
  /// is at least kMinSegmentMm.
  void bridge(const SampleWindow& window, const RunStart& start, std::size_t first,
              std::size_t count) noexcept;

  /// From now on only curves within the tolerance of `guide` are accepted; nullptr for none. The
  /// guide must know the samples of the windows given to fit().
  void set_guide(const GuideCurve* guide) noexcept { guide_ = guide; }
  /// True when the last curve fitted or bridged is within the tolerance of the guide.
  [[nodiscard]] bool follows_guide(const SampleWindow& window) const noexcept;

  [[nodiscard]] const Cubic& curve() const noexcept { return curve_; }
  /// Parameter of each sample of the run, non-decreasing in [0, 1].
  [[nodiscard]] std::span<const double> parameters() const noexcept { return {t_.data(), count_}; }
  /// Work since construction: samples x rounds.
  [[nodiscard]] long work() const noexcept { return work_; }

 private:
  static constexpr std::size_t kRoom = kMaxRun + SampleWindow::kPadding;

  bool initialise(const SampleWindow& window, std::span<const double> known) noexcept;
  bool solve(const SampleWindow& window, double tangent_weight, End end) noexcept;
  double place(const SampleWindow& window) noexcept;
  [[nodiscard]] bool gaps_are_tame(const SampleWindow& window) const noexcept;

  const GuideCurve* guide_ = nullptr;
  RunStart start_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  double length_mm_ = 0.0;  // along the run's samples from its start
  Cubic curve_{};
  long work_ = 0;
  alignas(32) std::array<double, kRoom> t_{};
  alignas(32) std::array<double, kRoom> ratio_{};
};

}  // namespace felt
