#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "felt/sound/rub_voice.h"
#include "felt/sound/rubbing.h"

namespace felt {

/// What a pen's way sounds like, one channel at 48 kHz: takes the samples of a session as they
/// come, and reads the way between them at the rate of sound.
///
/// In virtual time, for a file:     In time, for a loudspeaker:
///   sound.push(sample);              while (ring.pop(sample)) sound.push(sample);
///   n = sound.ready();               sound.keep_up(0.020);
///   sound.render(block.first(n));    sound.render(block);
///
/// The same calls give the same samples, on every machine. A value of some 30 KB; no allocation,
/// lock or wait; any one thread.
class RubbingSound {
 public:
  static constexpr double kRateHz = RubVoice::kRateHz;
  /// Samples of the way that can wait; the oldest is forgotten for one more.
  static constexpr std::size_t kMostWaiting = 1024;
  /// A way with a longer gap, or faster than any hand, is taken for two, with the pen in the air
  /// between them.
  static constexpr std::int64_t kLongestGapNs = 50'000'000;
  static constexpr double kFastestMmPerS = 5000.0;

  /// From what is rendered next on; what sounds fades before, within 12 ms.
  void set_pair(const RubbingPair& pair) noexcept;

  /// The next sample of the way. One that is not later than the last is left out; what is not
  /// finite, or farther away than 1e6 mm, is a pen in the air.
  void push(const RubbingSample& sample) noexcept;

  /// How many samples of sound the way pushed so far is good for.
  [[nodiscard]] std::size_t ready() const noexcept;

  /// Keeps so far behind the newest sample, in s: where the way ran out, waits until there is that
  /// much of it again; where too much waits, leaves out of it while nothing sounds, or all beyond
  /// kMostBehindS. Call before each render() in real time.
  void keep_up(double behind_s) noexcept;
  static constexpr double kMostBehindS = 0.250;

  /// The next samples, -1 < s < 1. Where the way has run out, the pen is heard to be lifted.
  void render(std::span<float> out) noexcept;

  /// Nothing sounds.
  [[nodiscard]] bool is_silent() const noexcept { return voice_.is_silent(); }

 private:
  [[nodiscard]] const RubbingSample& waiting(std::size_t i) const noexcept {
    return way_[(first_ + i) % kMostWaiting];
  }
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  void start_at(std::int64_t time_ns) noexcept;
  /// The pen where `now_ns` is; false where the way has run out.
  bool find(std::int64_t now_ns) noexcept;
  float next() noexcept;

  RubVoice voice_;
  RubbingPair pair_, next_pair_;
  std::array<RubbingSample, kMostWaiting> way_{};
  std::size_t first_ = 0, count_ = 0;  // of the ones that wait; the first is behind or at the head
  std::int64_t start_ns_ = 0;          // of the head, and how many samples ago that was
  std::int64_t played_ = 0;
  bool has_started_ = false, waits_ = false;
  std::int64_t struck_ns_ = -1;  // the touch that was heard last
  // Where the pen is.
  Point at_{};
  double push_n_ = 0.0;
};

}  // namespace felt
