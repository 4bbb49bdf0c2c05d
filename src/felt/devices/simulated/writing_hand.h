#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/devices/simulated/random.h"
#include "felt/geometry/point.h"

namespace felt {

/// What the tablet reports of the hand at one time. The fields of an InkSample, all present; ink is
/// a layer that devices do not see.
struct HandSample {
  Point position;            ///< mm, sheet frame
  double pressure = 0.0;     ///< above 0 up to 1
  std::int64_t time_ns = 0;  ///< since the hand's first stroke began

  friend constexpr bool operator==(const HandSample&, const HandSample&) noexcept = default;
};

/// What a hand means to draw with one stroke: points that the pen passes through. A point that is
/// given twice in a row is a corner; a single point is a dot.
struct Gesture {
  std::vector<Point> via;
  double pressure = 0.5;  ///< level in the middle of the stroke
  double tempo = 1.0;     ///< 1 is unhurried: 40 mm/s in small letters, 150 mm/s in long sweeps
  /// Pressure at the ends as a part of the level: 0.1 tapers like a brush, 0.5 like a pencil.
  double end_pressure = 0.4;
};

/// How a hand and its tablet are.
struct HandOptions {
  std::int64_t interval_ns = 7'500'000;  ///< between samples: 133 Hz
  double resolution_mm = 0.03;           ///< positions are multiples of it; 0 = not quantised
  double pressure_step = 1.0 / 1024.0;   ///< likewise
  double tremor_mm = 0.03;               ///< rms of physiological tremor, 8-12 Hz, per axis
  double wander_mm = 0.12;               ///< rms of slow wandering off the aim, below 2.5 Hz
  std::uint64_t seed = 1;
};

/// A simulated hand that writes and draws: a source of pen samples that look like those of a
/// person, for tests, benchmarks and demonstrations. The same options and gestures give the same
/// samples, up to the last digits of the machine's libm before quantisation.
///
/// The aim runs along a smooth path through the gesture at the pace of `hand_path.h`; a symmetric
/// 40 ms window over time stands for the muscles, which round what is drawn fast and keep what is
/// drawn slowly; wandering and tremor are added; pressure rises and falls at the ends, is higher in
/// slow parts and in strokes towards the body, and wavers.
class WritingHand {
 public:
  explicit WritingHand(const HandOptions& options = {});

  /// Draws one stroke. Times run on from the last one, with a pause for moving the pen there.
  std::vector<HandSample> draw(const Gesture& gesture);

 private:
  /// One sine of the noise that is added to the position or the pressure.
  struct Tone {
    double hz, phase_x, phase_y, amplitude;
  };
  static constexpr std::size_t kTones = 5;
  using Noise = std::array<Tone, kTones>;

  Noise make_noise(double low_hz, double high_hz, double rms);
  [[nodiscard]] static Vec value(const Noise& noise, double t_s) noexcept;
  void rest_until_start_of(Point start);

  HandOptions options_;
  Random random_;
  Noise tremor_, wander_, waver_;
  double now_s_ = 0.0;
  std::optional<Point> last_;
};

}  // namespace felt
