#pragma once

#include <memory>
#include <span>

#include "felt/base/chunked_vector.h"
#include "felt/base/result.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/stroke.h"

namespace felt {

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
