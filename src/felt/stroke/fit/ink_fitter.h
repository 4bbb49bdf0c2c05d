#pragma once

#include <memory>
#include <span>

#include "felt/base/chunked_vector.h"
#include "felt/base/result.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/fit/sample_faults.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Turns pen samples into a stroke of variable width while it is being drawn.
///
/// Use, for each stroke:
///   1. `begin()`;
///   2. `push()` for each sample: bounded work, no allocation after warm-up; `segment_count()`,
///      `segment()` and `joint()` return the stable prefix, which never changes; `live_tail()`
///      returns the rest;
///   3. `end()` at pen-up, which completes the online curve;
///   4. optionally `refine()`, which finds a curve with fewer segments within the same tolerance;
///   5. `curve()`, `stroke()`: the result.
/// The object can be reused for the next stroke and keeps its buffers. The result depends on the
/// samples only, not on how calls are grouped in time (R7). Not thread-safe: use it from one thread
/// at a time.
class InkFitter {
 public:
  explicit InkFitter(const InkFitOptions& options);
  ~InkFitter();
  InkFitter(InkFitter&&) noexcept;
  InkFitter& operator=(InkFitter&&) noexcept;

  /// Discards the last stroke and starts a new one.
  void begin();
  /// Continues the stroke of `other` here, as if its samples had been pushed to this fitter. Copies
  /// the samples and fits nothing, so that end() can complete a copy while `other` goes on.
  /// Requires that both fitters have the same options.
  void copy_stroke(const InkFitter& other);
  /// Adds the next sample. Ignores and counts it if a coordinate is not finite or exceeds
  /// kMaxCoordinateMm.
  void push(const InkSample& sample);
  /// Completes the online curve. Call at pen-up.
  void end();
  /// Replaces the online curve with a curve of fewer segments within the same tolerance, if it
  /// finds one. Requires that end() was called. Takes linear time in the number of samples. Does
  /// nothing unless the scheme is kFeltline.
  void refine();

  /// Returns the number of segments: of the stable prefix while drawing, of the whole curve after
  /// end().
  [[nodiscard]] int segment_count() const;
  /// Returns segment i, 0 <= i < segment_count().
  [[nodiscard]] Cubic segment(int i) const;
  /// Returns the kind of the joint before segment i, 0 < i < segment_count().
  [[nodiscard]] JointKind joint(int i) const;
  /// Returns the parameters u of the samples that the stable prefix covers, in order. The remaining
  /// samples() have no final parameter yet. The result is empty unless the scheme is kFeltline.
  /// Valid until refine().
  [[nodiscard]] const ChunkedVector<SamplePlace>& places() const;
  /// Returns provisional segments from the stable prefix to the newest sample, for display only.
  /// Valid until the next call.
  [[nodiscard]] std::span<const Cubic> live_tail();

  /// Returns the samples that became ink since begin(): the accepted samples, after the filter.
  [[nodiscard]] const ChunkedVector<InkSample>& samples() const;
  /// Returns the number of samples ignored since begin().
  [[nodiscard]] std::size_t ignored_count() const;
  /// Returns what is wrong with the pressures and times of the accepted samples. stroke() limits
  /// pressures to 0..1, and ignores the times if SampleFaults::has_no_clock is true.
  [[nodiscard]] SampleFaults faults() const;
  /// Returns the whole curve. Requires that end() was called.
  [[nodiscard]] const FittedCurve& curve() const;
  /// Returns the finished stroke with its width profile. Requires that end() was called. Fails if
  /// no sample was accepted.
  [[nodiscard]] Result<Stroke> stroke() const;
  /// Returns the finished stroke with widths and tones by `widths` instead of those of the options.
  [[nodiscard]] Result<Stroke> stroke(const WidthMapOptions& widths) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
