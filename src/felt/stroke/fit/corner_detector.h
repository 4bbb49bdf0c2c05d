#pragma once

#include <cstddef>

#include "felt/stroke/fit/kept_samples.h"

namespace felt {

/// Finds the corners of ink while its samples arrive.
///
/// A sample is a corner if the ink's direction changes by more than kCornerDeg between two straight
/// arms that meet at the sample. One arm reaches back and one forward. Each ends at the first point
/// of the ink that is kCornerArm tolerances away (h in the figure), but spans at least two samples.
/// So the arms are longer than both the tolerance and the distance between samples. If the pen
/// slows down or rests in the corner, most of the path length there is noise of the sensor; the
/// arms are long enough to reach beyond this noise. Three conditions keep noise and tight curves
/// out:
///   - the part of the turn that curved or noisy arms can cause is subtracted first: 2 da / a + 2
///     db / b, where da and db are the largest distances of the arms' samples from the arms'
///     chords, and a and b are the lengths of these chords. This removes half the turn of a circle,
///     and nothing of a corner;
///   - with arms of half the length, at least kCornerPersistence of the turn must remain: a corner
///     keeps all of its turn, a circle half;
///   - of several turns within the length of one arm, only the largest counts.
/// A sample has no arm if the path of the ink to the arm's end is longer than kCornerDetour times
/// the arm. No corner is reported if the path to an end of the stroke is shorter than kCornerMargin
/// tolerances, because hooks occur there.
///
///            P                 turn = angle(P - A, B - P)
///      h   /   \   h
///        A       B
///
/// A corner is decided when the ink has continued for kCornerMargin + kCornerArm tolerances, about
/// 1.7 mm at the default tolerance, or later if the pen rests. The corners do not depend on how the
/// samples are divided into calls (R5, R7). The work is bounded: only kept samples are examined,
/// and an arm has at most kCornerDetour * kCornerArm tolerances / CurveFitter::spacing_mm() kept
/// samples.
class CornerDetector {
 public:
  static constexpr double kCornerDeg = 60.0;
  static constexpr double kCornerArm = 4.0;
  static constexpr double kCornerMargin = 7.0;
  static constexpr double kCornerPersistence = 0.8;
  static constexpr double kCornerDetour = 8.0;

  /// Starts a stroke.
  void clear() noexcept;
  /// Processes some of the samples added to `kept` and marks the corners among them. The work is
  /// bounded.
  void update(KeptSamples& kept) noexcept;
  /// Decides the remaining samples. Call when the stroke has ended.
  void finish(KeptSamples& kept) noexcept;
  /// Returns the index before which all samples are decided.
  [[nodiscard]] std::size_t decided() const noexcept { return decided_; }

 private:
  void measure(KeptSamples& kept, std::size_t max_count) noexcept;
  void decide(KeptSamples& kept) noexcept;

  std::size_t measured_ = 0;  // number of samples with a measured turn
  std::size_t decided_ = 0;
};

}  // namespace felt
