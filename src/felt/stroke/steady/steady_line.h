#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/chunked_vector.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/fit/sample_faults.h"
#include "felt/stroke/steady/shake.h"
#include "felt/stroke/steady/shake_filter.h"

namespace felt {

/// Removes the shaking of a hand from a line while the line is drawn, and better once it is
/// complete. Only positions change: pressure, time and tilt stay.
///
///      settled samples, final  |  held: revised with each sample  | tip()
///      ------------------------|------------ 60 ms ---------------|  no lag
///
/// Use, for each line: begin(); push() for each sample, which returns the samples that have
/// settled; held() for display; at pen-up smoothed(), which revises the whole line by all samples.
/// raw() has the samples unchanged.
///
/// A bank of kModels pairs of ShakeFilter runs along and across the axis: three frequencies,
/// because a hand drifts from its mean, times three intensities of jerk, because people draw slow
/// curves and sharp corners. Each sample is the mean of their estimates, weighted by the likelihood
/// of the last kMemoryS (multiple-model estimation: Magill, IEEE Trans. Automatic Control
/// 10(4):434, 1965, DOI 10.1109/TAC.1965.1098191). If much less shaking is found than the hand
/// usually has, less is removed, and nothing below kNoShare of it: the line of a steady hand stays
/// as it is.
///
/// Times are those of the samples; a step counts as at least 0.1 ms and at most kMaxStepS, and
/// samples without times as 7.5 ms apart. The work per sample is bounded: at most kMaxHeld samples
/// are held. Memory grows by about 75 bytes for each sample, and is reused for the next line.
/// Deterministic. Not thread-safe.
class SteadyLine {
 public:
  static constexpr double kTailS = 0.060;
  /// Samples settle in groups, so that a fast pen does not pay for one revision per sample.
  static constexpr double kGroupS = 0.008;
  static constexpr std::size_t kMaxHeld = 128;
  static constexpr double kMaxStepS = 0.1;
  static constexpr double kMemoryS = 0.25;
  /// Shares of the calibrated shaking between which removal grows from nothing to all.
  static constexpr double kNoShare = 0.25, kFullShare = 0.5;
  /// Shaking across the axis as a share of the shaking along it, and the distance between the
  /// frequencies of the bank. Chosen like the parameters of ShakeFilter.
  static constexpr double kAcross = 0.5, kDriftHz = 0.6;
  static constexpr std::size_t kModels = 9;
  /// No sample moves farther than this number of amplitudes, whatever the pen does.
  static constexpr double kMaxMove = 2.0;

  explicit SteadyLine(const Shake& shake);

  /// Discards the last line and starts a new one.
  void begin() noexcept;
  /// Adds the next sample and returns the samples that have settled, valid until the next call. A
  /// sample is ignored if a coordinate is not finite or exceeds kMaxCoordinateMm.
  std::span<const InkSample> push(const InkSample& sample);
  /// Returns the samples that have not settled yet, the newest last, as they are estimated now.
  /// Valid until the next call.
  std::span<const InkSample> held();
  /// Returns the estimate of the newest sample; it has no lag. Requires a sample.
  [[nodiscard]] Point tip() const noexcept { return tip_; }
  [[nodiscard]] const ChunkedVector<InkSample>& raw() const noexcept { return raw_; }
  /// Returns all samples, revised by all others (find_line_shaking()). Removes less if the intended
  /// motion is too quick to be told from the shaking. Takes linear time.
  [[nodiscard]] std::vector<InkSample> smoothed() const;

 private:
  /// The filters of one model: along and across the axis.
  using Pair = std::array<ShakeFilter, 2>;
  using Weights = std::array<double, kModels>;
  /// A held sample: the records of all filters.
  struct Held {
    std::array<std::array<ShakeFilter::Record, 2>, kModels> records;
  };

  [[nodiscard]] Vec to_axes(Vec v) const noexcept;
  [[nodiscard]] Point on_page(Vec along_axes) const noexcept;
  /// Returns the position of the pen without a share of its shaking.
  [[nodiscard]] Point without_shaking(Point pen, Vec estimate, double share) const noexcept;
  [[nodiscard]] double step_s(const InkSample& sample) const noexcept;
  [[nodiscard]] double share_of(double squared_mm2) const noexcept;
  void revise(std::size_t count);
  void update_tip(const Held& held, double dt_s);
  [[nodiscard]] Held& held_at(std::size_t i) noexcept { return ring_[i % kMaxHeld]; }

  double amplitude_mm_;
  Vec axis_;  // unit vector along the axis
  double hz_;
  std::array<Pair, kModels> filters_;
  ChunkedVector<InkSample> raw_;
  ChunkedVector<double> steps_s_;  // before each sample
  std::vector<Held> ring_;         // of the samples from settled_ on
  std::size_t settled_ = 0;
  double held_s_ = 0.0;       // time from the oldest held sample to the newest
  Weights recent_{};          // log-likelihood of the last kMemoryS
  double removed_mm2_ = 0.0;  // mean square of the shaking removed lately
  double share_ = 1.0;        // of the estimated shaking that is removed
  Point tip_;
  std::vector<InkSample> out_, shown_;
};

/// Replaces the samples of a whole stroke by SteadyLine::smoothed(), without their times if these
/// cannot be those of a pen (drop_bad_times()). Returns what a fit of the new samples cannot find
/// any more, for combined_faults(): whether the stroke had no clock, and that its times are needed.
SampleFaults steady_samples(SteadyLine& line, std::vector<InkSample>& samples);

}  // namespace felt
