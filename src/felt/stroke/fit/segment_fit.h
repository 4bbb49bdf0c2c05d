#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "felt/geometry/cubic.h"
#include "felt/stroke/fit/sample_window.h"
#include "felt/stroke/stroke.h"

namespace felt {

class GuideCurve;

/// Minimum length of the segments that the fitters make: kMinSegmentMm (invariant I5 of
/// docs/design/strokes.md), plus a small margin for rounding.
inline constexpr double kShortestSegmentMm = 1.001 * kMinSegmentMm;

/// The properties that are already fixed at the start of a segment.
struct RunStart {
  enum class Kind {
    kFree,     ///< nothing is fixed: first segment of a stroke
    kPoint,    ///< B1 is fixed: after a corner
    kTangent,  ///< B1 and its tangent are fixed: after a smooth joint (G1)
  };
  Kind kind = Kind::kFree;
  Point point;
  Vec tangent;  ///< unit length
};

/// Fits one cubic to a run, that is, to consecutive samples.
///
/// B4 and, if the start is free, B1 need not lie on samples: joints are points on the ink, so the
/// noise of single samples is averaged away at joints as well. This halves the number of segments
/// at noise-level tolerances (docs/decisions/0004-joints-leave-the-samples.md).
///
/// The fit minimises
///   sum_i w_i |f(t_i) - P_i|^2_M + n kEnergy |f'''/6|^2 + n kRidge |B - B_chord|^2,
/// where w_i is the weight of a sample (SampleWindow), n is the sum of all weights, and B_chord are
/// the control points of the straight line from the start to the last sample. The norm M counts the
/// distance to the curve's tangent line at the foot point and a little of the distance along that
/// line (segment_fit_kernels.h). The last two terms are small; they determine the curve only where
/// the samples do not. The jerk f'''/6 = B4 - 3 B3 + 3 B2 - B1 is zero on parabolas and small on
/// arcs, so its term prevents curls without flattening round shapes. Each round solves for the
/// control points and moves every t_i one Newton step to its foot point; 2 to 4 rounds achieve as
/// much as 10 rounds of ordinary least squares.
///
/// A curve is accepted if it passes within (tolerance - slack) of every sample *in the order of the
/// samples*: t_i never decreases. (KeptSamples defines the slack.) In addition, between two
/// neighbouring samples the curve must stay near the straight line that joins them, within the
/// tolerance plus kGapBulge times the distance between the two, so that no loop or spike can hide
/// there.
///
/// Use one fitter per thread; any thread may use one. Does not allocate after construction, and the
/// work is bounded.
class SegmentFit {
 public:
  /// Maximum number of samples in one fit. A longer run is thinned (LongRun).
  static constexpr std::size_t kMaxRun = 256;
  /// Maximum number of least-squares rounds of one fit.
  static constexpr int kMaxRounds = 8;
  /// Maximum work of one fit, in samples x rounds.
  static constexpr long kMaxWork = static_cast<long>(kMaxRun) * (kMaxRounds + 1);
  static constexpr double kTangentWeight = 0.05;
  static constexpr double kEnergy = 2e-5;
  static constexpr double kRidge = 1e-4;
  /// Bounds of the handle at a smooth start, as fractions of the path length along the run's
  /// samples.
  static constexpr double kMinHandle = 0.03;
  static constexpr double kMaxHandle = 2.0;
  static constexpr double kGapBulge = 0.1;

  /// Position of the end of the curve.
  enum class End {
    kFree,    ///< near the last sample, as far as the tolerance allows
    kPinned,  ///< exactly on the last sample
  };

  /// Fits samples [first, first + count) of `window`. Returns true if the curve is accepted;
  /// `curve()` and `parameters()` then return the curve and its parameters. Requires 1 <= count <=
  /// kMaxRun and, if the start is free, count >= 2. `known` are the parameters that the first
  /// samples had on a shorter curve from the same start. If the samples are noisy, these parameters
  /// are a better first guess than path lengths.
  bool fit(const SampleWindow& window, const RunStart& start, std::size_t first, std::size_t count,
           End end = End::kFree, std::span<const double> known = {}) noexcept;

  /// Sets a curve without a fit: from `start`, along its tangent if that is fixed, to the last of
  /// the samples. Requires that all samples but the last lie within kMinSegmentMm of the start. The
  /// result is within the tolerance if the tolerance is at least kMinSegmentMm.
  void bridge(const SampleWindow& window, const RunStart& start, std::size_t first,
              std::size_t count) noexcept;

  /// Sets a guide: fit() then accepts only curves within the tolerance of the guide. If `guide` is
  /// null, removes the guide. Requires that the guide was made from the same kept samples as the
  /// windows that are passed to fit().
  void set_guide(const GuideCurve* guide) noexcept { guide_ = guide; }
  /// Returns true if the last curve fitted or bridged is within the tolerance of the guide.
  [[nodiscard]] bool follows_guide(const SampleWindow& window) const noexcept;

  [[nodiscard]] const Cubic& curve() const noexcept { return curve_; }
  /// Returns the parameter of each sample of the run, non-decreasing in [0, 1].
  [[nodiscard]] std::span<const double> parameters() const noexcept { return {t_.data(), count_}; }
  /// Returns the work since construction: samples x rounds.
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
  double length_mm_ = 0.0;  // path length along the run's samples
  Cubic curve_{};
  long work_ = 0;
  alignas(32) std::array<double, kRoom> t_{};
  alignas(32) std::array<double, kRoom> ratio_{};
};

}  // namespace felt
