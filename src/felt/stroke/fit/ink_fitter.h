#pragma once

#include <memory>
#include <span>
#include <string>

#include "felt/base/chunked_vector.h"
#include "felt/base/result.h"
#include "felt/stroke/fit/curve_fitter.h"
#include "felt/stroke/fit/ink_sample.h"
#include "felt/stroke/fit/pen_filter.h"
#include "felt/stroke/fit/width_fitter.h"
#include "felt/stroke/fit/width_map.h"
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
  PenFilterOptions filter;
  WidthMapOptions width_map = kPenWidths;
  WidthFitOptions width;
  std::string material = StrokeData{}.material;  ///< of the stroke
};

/// Pen samples in, a variable-width stroke out, while it is being drawn.
///
/// Life-cycle of one stroke:
///   1. `begin()`;
///   2. `push()` for each sample: bounded work, no allocation after warm-up; `segment_count()`,
///      `segment()` and `joint()` are the stable prefix, which never changes, `live_tail()` the
///      short rest;
///   3. `end()` at pen-up: the online curve is complete;
///   4. optionally `refine()`: fewer segments within the same tolerance;
///   5. `curve()`, `stroke()`: the result.
/// The object is reused for the next stroke and keeps its buffers. The result depends on the
/// samples only, not on how they are grouped in time (R7). Thread: one.
class InkFitter {
 public:
  explicit InkFitter(const InkFitOptions& options);
  ~InkFitter();
  InkFitter(InkFitter&&) noexcept;
  InkFitter& operator=(InkFitter&&) noexcept;

  /// Forgets the last stroke and starts one.
  void begin();
  /// Takes the next sample. One whose coordinates are not finite or exceed kMaxCoordinateMm is
  /// ignored and counted.
  void push(const InkSample& sample);
  /// Pen-up: completes the online curve.
  void end();
  /// Replaces the online curve by one with fewer segments within the same tolerance, if there is
  /// one. After end(); time linear in the samples. kFeltline only; else it does nothing.
  void refine();

  /// Segments of the stable prefix while drawing, of the whole curve after end().
  [[nodiscard]] int segment_count() const;
  /// Segment i of them.
  [[nodiscard]] Cubic segment(int i) const;
  /// Kind of the joint before segment i, 0 < i < segment_count().
  [[nodiscard]] JointKind joint(int i) const;
  /// Where on the stable prefix the samples lie that it covers, in order; the rest of samples() is
  /// still open. kFeltline only, else empty. Before refine().
  [[nodiscard]] const ChunkedVector<SamplePlace>& places() const;
  /// Provisional segments from the stable prefix to the newest sample, for display only; valid
  /// until the next call.
  [[nodiscard]] std::span<const Cubic> live_tail();

  /// The samples that became ink since begin(): those taken, after the filter.
  [[nodiscard]] const ChunkedVector<InkSample>& samples() const;
  /// Number of samples ignored since begin().
  [[nodiscard]] std::size_t ignored_count() const;
  /// The whole curve. After end().
  [[nodiscard]] const FittedCurve& curve() const;
  /// The finished stroke with its width profile. After end(). Error: no sample was taken.
  [[nodiscard]] Result<Stroke> stroke() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
