#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "felt/sound/rubbing.h"
#include "felt/sound/rubbing_synth.h"

namespace felt {

/// The sound of the path of a pen, one channel at 48 kHz. It receives the samples of a session and
/// interpolates the path between them at the rate of the sound.
///
/// In virtual time, for a file:     In real time, for a loudspeaker:
///   sound.push(sample);              while (ring.pop(sample)) sound.push(sample);
///   n = sound.ready();               sound.keep_up(0.020);
///   sound.render(block.first(n));    sound.render(block);
///
/// The same calls give the same sound on every machine. A value type of about 30 KB that never
/// allocates, locks or waits. Use it on one thread at a time.
class RubbingPlayer {
 public:
  static constexpr double kRateHz = RubbingSynth::kRateHz;
  /// Maximum number of samples in the queue. If more are pushed, the oldest is dropped.
  static constexpr std::size_t kMaxWaiting = 1024;
  /// If the gap between two samples is longer than kLongestGapNs, or the path between them is
  /// faster than kFastestMmPerS, the pen counts as lifted in between.
  static constexpr std::int64_t kLongestGapNs = 50'000'000;
  static constexpr double kFastestMmPerS = 5000.0;

  /// Sets the pair of medium and surface for the sound that is rendered next. First, the sound of
  /// the previous pair fades out within 12 ms.
  void set_pair(const RubbingPair& pair) noexcept;

  /// Appends a sample of the path. Ignores it if it is not later than the last sample. A sample
  /// that is not finite, or farther away than 1e6 mm, counts as a lifted pen.
  void push(const RubbingSample& sample) noexcept;

  /// Returns the number of samples of sound up to the end of the path pushed so far.
  [[nodiscard]] std::size_t ready() const noexcept;

  /// Keeps the playback about `behind_s` seconds behind the newest sample. If the path has run out,
  /// pauses until `behind_s` of path is available again. If the delay has grown, skips a part of
  /// the path: during silence, if the delay is more than twice `behind_s`; at any time, if it is
  /// more than kMaxBehindS. Call it before each render() in real time.
  void keep_up(double behind_s) noexcept;
  static constexpr double kMaxBehindS = 0.250;

  /// Writes the next samples of sound, -1 < s < 1. If the path has run out, the sound is that of a
  /// lifted pen.
  void render(std::span<float> out) noexcept;

  /// Returns true during silence.
  [[nodiscard]] bool is_silent() const noexcept { return voice_.is_silent(); }

 private:
  [[nodiscard]] const RubbingSample& waiting(std::size_t i) const noexcept {
    return way_[(first_ + i) % kMaxWaiting];
  }
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  void start_at(std::int64_t time_ns) noexcept;
  /// Sets at_ and push_n_ to the position and push of the pen at `now_ns`. Returns false if the
  /// path has run out.
  bool find(std::int64_t now_ns) noexcept;
  float next() noexcept;

  RubbingSynth voice_;
  RubbingPair pair_, next_pair_;
  std::array<RubbingSample, kMaxWaiting> way_{};
  std::size_t first_ = 0, count_ = 0;  // the queue; its first sample is not after the playback time
  std::int64_t start_ns_ = 0;          // the playback time at which playback started
  std::int64_t played_ = 0;            // samples of sound played since start_ns_
  bool has_started_ = false, waits_ = false;
  std::int64_t struck_ns_ = -1;  // the time of the last touch played
  // The current position of the pen.
  Point at_{};
  double push_n_ = 0.0;
};

}  // namespace felt
