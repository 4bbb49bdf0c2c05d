#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "felt/haptics/material.h"

namespace felt::desktop {

/// How a sheet sounds when a pen rubs on it.
struct RubTimbre {
  double grain_mm = 0.1;       ///< from one unevenness to the next: the pitch at a speed
  double brightness_hz = 4e3;  ///< higher sounds are damped
  double loudness = 1.0;       ///< 0..1 beside the others
};
RubTimbre timbre_of(const SurfaceMaterial& material) noexcept;

/// What the pen does now.
struct Rubbing {
  double speed_mm_per_s = 0.0;  ///< along the sheet; 0 in the air
  double friction_n = 0.0;      ///< 0 in the air
  RubTimbre timbre;
};

/// The rubbing of a pen as sound: noise that lies on the sheet and is played by the pen's way, so
/// that a faster stroke sounds higher, as loud as friction is strong. Where the way between two
/// samples is longer than the noise is fine, coarser noise is read, so that nothing folds back into
/// the audible. Loudness and speed follow what is told within some milliseconds: no clicks. Silent
/// at rest and in the air, after the fading. The same calls give the same samples; any one thread,
/// no allocation after the constructor.
class FrictionSynth {
 public:
  static constexpr double kLoudest = 0.35;  ///< no sample is beyond

  explicit FrictionSynth(double rate_hz = 48000.0) noexcept;

  /// From the next sample on. Numbers that are not finite count as 0.
  void rub(const Rubbing& now) noexcept;
  /// The next samples, one channel, -kLoudest..kLoudest.
  void render(std::span<float> samples) noexcept;

 private:
  static constexpr std::size_t kLevels = 9;
  static constexpr std::size_t kSize = 4096;  // of the finest noise; each level has half as many

  void make_noise() noexcept;
  [[nodiscard]] double noise_at(std::size_t level) const noexcept;
  [[nodiscard]] double next() noexcept;

  double rate_hz_;
  Rubbing target_;
  std::array<float, 2 * kSize> noise_{};  // level by level
  double way_ = 0.0;                      // along the noise, in its finest steps
  double speed_ = 0.0, gain_ = 0.0;       // follow the target
  double low_ = 0.0, lower_ = 0.0;        // of the damping of high sounds
  double drift_ = 0.0;                    // what is too low to be heard
};

}  // namespace felt::desktop
