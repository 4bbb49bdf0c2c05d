#pragma once

#include <cstdint>

namespace felt {

/// What a DistanceTone says.
struct ToneInput {
  float distance_mm = 1e9F;  ///< from the pen to the nearest line; 0 on its ink
  bool is_on = false;
  std::uint32_t clicks = 0;  ///< each change makes one click

  friend bool operator==(const ToneInput&, const ToneInput&) = default;
};

/// A tone that says how far the pen is from the nearest line, like the warner of a parking car:
///
///   on a line           a low steady tone
///   within kFarMm       pulses, 2 to 12 per second, from 220 to 880 Hz, both higher when nearer
///   farther             silence
///
/// Both the rate and the pitch change, because a rate is understood without training and a pitch
/// resolves small steps (chosen; docs/sound.md#the-tone-of-read). Mono, 48 kHz. The same calls give
/// the same sound. A value type that does not allocate; use it on one thread.
class DistanceTone {
 public:
  static constexpr double kRateHz = 48000.0;
  static constexpr double kFarMm = 30.0;
  static constexpr double kOnLineMm = 0.3;
  static constexpr double kLoudness = 0.22;  ///< largest sample of the tone

  void set(const ToneInput& input) noexcept;
  /// Returns the next sample, -1 < s < 1.
  double next() noexcept;
  [[nodiscard]] bool is_silent() const noexcept {
    return level_ < 1e-4 && !input_.is_on && click_left_ == 0;
  }

 private:
  ToneInput input_;
  double hz_ = 0.0, pulses_hz_ = 0.0;               // of the distance; 0 pulses: steady
  double phase_ = 0.0, pulse_ = 0.0, level_ = 0.0;  // 0..1
  int click_left_ = 0;
};

}  // namespace felt
