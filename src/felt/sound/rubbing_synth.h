#pragma once

#include <array>

#include "felt/geometry/point.h"
#include "felt/sound/filters.h"
#include "felt/sound/roughness.h"
#include "felt/sound/rubbing.h"

namespace felt {

/// The sound of one medium on one surface, sample by sample, from the position and push of the pen.
/// It adds up these parts:
///
///   hills      the slope of the relief along the path times the speed: this shakes the pen (R47)
///   roughness  noise as a function of position, with shorter waves than the relief (roughness.h).
///              Its loudness is the square root of the friction power, mu N v (van den Doel, Kry
///              and Pai 2001). It is louder uphill than downhill, so that the weave of a canvas is
///              heard in the hiss, too
///   squeak     a mode that friction feeds if friction falls with speed, as in stick-slip
///              (Avanzini, Serafin and Rocchesso 2005): a Hopf oscillator, which limits its own
///              amplitude, fed by the slope of a Stribeck curve
///   tap        a pulse of force when the pen comes down
///
/// All parts but the squeak go through the bodies (resonances of surface and medium) and, in
/// parallel, through a low-pass filter that depends on the brightness of both. The sum then goes
/// through a soft limiter and a gate. The gate reaches exactly 0 within kSilentAfterS after the pen
/// is lifted or stops. A sample is always between -1 and 1, and never NaN if the arguments of
/// next() are as required. A value type that does not allocate. Use it on one thread at a time.
class RubbingSynth {
 public:
  static constexpr double kRateHz = 48000.0;
  static constexpr double kSilentAfterS = 0.050;

  RubbingSynth() noexcept;

  /// Sets the pair, which is used from the next sample on. Call it during silence (is_silent()),
  /// because the change of parameters would be audible as a click.
  void set_pair(const RubbingPair& pair) noexcept;
  static constexpr double kUsualStrike = 40.0;  ///< mm/s; for strike() if the speed is unknown
  /// Starts the tap of a pen that came down at this speed, mm/s.
  void strike(double mm_per_s) noexcept;
  /// Returns the next sample of sound. A `push_n` of 0 means that the pen is lifted. Requires
  /// finite and bounded arguments, as RubbingPlayer passes them.
  double next(Point at, double push_n) noexcept;
  /// Returns true if the last sample was 0 and every sample will be 0 until the pen rubs again.
  [[nodiscard]] bool is_silent() const noexcept { return gate_ == 0.0 && gate_goal_ == 0.0; }

 private:
  static constexpr int kControlSamples = 16;  // between two calls of look()

  void follow(Point at, double push_n) noexcept;
  void look() noexcept;
  void be_silent() noexcept;
  [[nodiscard]] double excitation() noexcept;
  double squeak() noexcept;
  double tap() noexcept;

  RubbingPair pair_;
  double slope_scale_ = 0.0;  // 1 / RMS slope of the relief
  // The path.
  Point first_{}, at_{};  // two followers in series, which smooth the steps of the sensor
  Vec velocity_{};
  double speed_ = 0.0, push_ = 0.0;
  bool touches_ = false;
  // Loudness.
  double gate_ = 0.0, gate_goal_ = 0.0;
  double level_ = 1.0;
  // Sources.
  Roughness roughness_;
  double noise_ = 0.0;  // the last value of the roughness
  double squeak_a_ = 0.0, squeak_b_ = 0.0, squeak_cos_ = 1.0, squeak_sin_ = 0.0,
         squeak_feed_ = -1.0;
  int tap_left_ = 0, tap_window_ = 0;
  double tap_gain_ = 0.0;
  // Bodies.
  LowPass low_pass_;
  LowCut high_pass_, hiss_pass_;
  std::array<Resonator, 3> bodies_{};
  int until_look_ = 0;
};

}  // namespace felt
