#pragma once

#include <memory>
#include <span>

#include "felt/base/result.h"
#include "felt/stroke/curve_fitter.h"
#include "felt/stroke/ink_sample.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Which curve fitting to use.
enum class FitScheme {
  kFeltline,   ///< ours: max error within the tolerance, G1 joints, corners kept
  kPaper2002,  ///< the scheme of the paper, eq. 2 with s shared samples (R6), for study
};

/// How ink is made from samples.
struct InkFitOptions {
  FitScheme scheme = FitScheme::kFeltline;
  CurveFitOptions curve;
  int shared_samples = 4;         ///< s of [Paper eq. 2]; kPaper2002 only
  bool filter_artefacts = false;  ///< pen-down / pen-up filter before the fit (PenFilter)
};

/// Pen samples in, a variable-width stroke out, while it is being drawn.
///
/// Life-cycle of one stroke:
///   1. `begin()`;
///   2. `push()` for each sample: bounded work, no allocation after warm-up;
///      `curve()` is the stable prefix that never changes, `live_tail()` the short rest;
///   3. `end()` at pen-up: the online curve is complete;
///   4. optionally `refine()`: fewer segments within the same tolerance;
///   5. `stroke()`: the finished stroke.
/// The object is reused for the next stroke and keeps its buffers. The result depends on the
/// samples only, not on how they are grouped in time (R7).
class InkFitter {
 public:
  explicit InkFitter(const InkFitOptions& options);
  ~InkFitter();
  InkFitter(InkFitter&&) noexcept;
  InkFitter& operator=(InkFitter&&) noexcept;

  /// Forgets the last stroke and starts one.
  void begin();
  /// Takes the next sample. One with a coordinate that is not finite is ignored and counted.
  void push(const InkSample& sample);
  /// Pen-up: completes the online curve.
  void end();
  /// Replaces the online curve by one with fewer segments within the same tolerance. After end().
  void refine();

  /// The stable prefix while drawing; the whole curve after end().
  [[nodiscard]] const FittedCurve& curve() const;
  /// Provisional segments from the stable prefix to the newest sample. For display only.
  [[nodiscard]] std::span<const Cubic> live_tail() const;
  /// The samples taken since begin(), after the filter.
  [[nodiscard]] std::span<const InkSample> samples() const;
  /// The finished stroke with its width profile. Error: no sample was taken.
  [[nodiscard]] Result<Stroke> stroke() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
