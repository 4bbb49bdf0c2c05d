#pragma once

#include <array>

#include "felt/geometry/point.h"
#include "felt/sound/filters.h"
#include "felt/sound/roughness.h"
#include "felt/sound/rubbing.h"

namespace felt {

/// The sound of one pair, sample by sample, from where the pen is and how hard it is pushed.
///
///   hills      the relief's slope along the way times the speed: what shakes the pen (R47)
///   roughness  noise by position below the relief's waves (roughness.h), as loud as the root of
///              the power that friction takes, mu N v (van den Doel, Kry and Pai 2001), and louder
///              uphill than downhill, so that the weave of a canvas is heard in the hiss, too
///   bodies     resonances of sheet and medium, and a low pass as both are bright
///   squeak     a mode that friction feeds where it falls with speed, as a bristle that sticks and
///              slips does (Avanzini, Serafin and Rocchesso 2005): here a Hopf oscillator with the
///              slope of a Stribeck curve as what it gets, and bounded by itself
///   tap        a half sine of force where the pen comes down, through the same bodies
///
/// All of it is behind a soft limiter and a gate that is 0, exactly, soon after the pen is lifted
/// or stands: kSilentAfterS. |sample| < 1 always; NaN never, whatever is told. A value; no
/// allocation; any one thread.
class RubVoice {
 public:
  static constexpr double kRateHz = 48000.0;
  static constexpr double kSilentAfterS = 0.050;

  RubVoice() noexcept;

  /// From the next sample on. Figures jump: do it in silence (is_silent()), or hear a click.
  void set_pair(const RubbingPair& pair) noexcept;
  static constexpr double kUsualStrike = 40.0;  ///< mm/s, of a pen that does not say
  /// The pen came down so fast, mm/s.
  void strike(double mm_per_s) noexcept;
  /// The next sample. `push_n` 0: in the air. Finite, bounded: RubbingSound sees to that.
  double next(Point at, double push_n) noexcept;
  /// The last sample was 0, and so is every one until the pen rubs again.
  [[nodiscard]] bool is_silent() const noexcept { return gate_ == 0.0 && gate_goal_ == 0.0; }

 private:
  static constexpr int kControlSamples = 16;  // between two looks at what changes slowly

  void follow(Point at, double push_n) noexcept;
  void look() noexcept;
  void be_silent() noexcept;
  [[nodiscard]] double excitation() noexcept;
  double squeak() noexcept;
  double tap() noexcept;

  RubbingPair pair_;
  double slope_scale_ = 0.0;  // 1 / RMS slope of the relief
  // The way.
  Point first_{}, at_{};  // two followers in a row: sensors step, hands do not
  Vec velocity_{};
  double speed_ = 0.0, push_ = 0.0;
  bool touches_ = false;
  // Loudness.
  double gate_ = 0.0, gate_goal_ = 0.0;
  double level_ = 1.0;
  // Sources.
  Roughness roughness_;
  double noise_ = 0.0;  // what it said last
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
