#pragma once

#include <cstddef>

#include "felt/stroke/fit/kept_samples.h"

namespace felt {

/// Finds where ink turns a corner, as the samples come.
///
/// What a corner is: at a sample, the ink's direction changes by more than kCornerDeg between two
/// straight arms, one reaching back and one forward to where the ink first is kCornerArm tolerances
/// away, or two samples. So the scale is above both the tolerance and the sampling, and a pen that
/// slows down or rests in the corner, where the tremor of the sensor makes more path than the hand,
/// is measured where it came from and went to. Three conditions keep noise and tight curves out:
///   - the part of the turn that bent or noisy arms can fake is taken off first: 2 da / a + 2 db /
///   b,
///     da and db the largest distances of the arms' samples from their chords of lengths a and b. A
///     circle loses half its turn by this, a corner nothing;
///   - halving the arms must leave at least kCornerPersistence of the turn: a corner keeps all of
///     it, a circle half;
///   - of several within one arm only the largest turn counts.
/// There is no arm where the ink takes more than kCornerDetour times its length to get that far.
/// No corner is reported within kCornerMargin tolerances of path of an end of the stroke, where
/// hooks live.
///
///            P                 turn = angle(P - A, B - P)
///      h   /   \   h
///        A       B
///
/// A corner is decided when the ink has gone on for kCornerMargin + kCornerArm tolerances, about
/// 1.7 mm at the default tolerance, or later where it dwells. Streaming and in one go give the same
/// corners (R5, R7). Work is bounded: merged samples are not looked at, so an arm has at most
/// kCornerDetour * kCornerArm tolerances / CurveFitter::spacing_mm() of them.
class CornerDetector {
 public:
  static constexpr double kCornerDeg = 60.0;
  static constexpr double kCornerArm = 4.0;
  static constexpr double kCornerMargin = 7.0;
  static constexpr double kCornerPersistence = 0.8;
  static constexpr double kCornerDetour = 8.0;

  /// Starts a stroke.
  void clear() noexcept;
  /// Looks at some of the samples added to `kept` and marks corners in it; bounded work.
  void update(KeptSamples& kept) noexcept;
  /// The stroke has ended: decides the rest.
  void finish(KeptSamples& kept) noexcept;
  /// Samples before this index are decided.
  [[nodiscard]] std::size_t decided() const noexcept { return decided_; }

 private:
  void measure(KeptSamples& kept, std::size_t most) noexcept;
  void decide(KeptSamples& kept) noexcept;

  std::size_t measured_ = 0;  // samples before it have their turn
  std::size_t decided_ = 0;
};

}  // namespace felt
