#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/base/random.h"
#include "felt/devices/simulated/tones.h"
#include "felt/geometry/point.h"

namespace felt {

/// A pen sample that a tablet would report. It has the same fields as InkSample, but none of them
/// is optional. InkSample is not used, because devices do not depend on the ink layer.
struct HandSample {
  Point position;            ///< mm, page frame
  double pressure = 0.0;     ///< greater than 0, at most 1
  std::int64_t time_ns = 0;  ///< since the start of the hand's first stroke

  friend constexpr bool operator==(const HandSample&, const HandSample&) noexcept = default;
};

/// The plan of one stroke: points that the pen passes through. A point given twice in a row is a
/// corner; a single point is a dot.
struct Gesture {
  std::vector<Point> via;
  double pressure = 0.5;  ///< pressure in the middle of the stroke
  double tempo = 1.0;     ///< 1 is unhurried: 40 mm/s in small letters, 150 mm/s in long sweeps
  /// Pressure at the ends as a fraction of `pressure`: with 0.1 the line tapers like a brush
  /// stroke, with 0.5 like a pencil line.
  double end_pressure = 0.4;
};

/// The properties of a hand and its tablet.
struct HandOptions {
  std::int64_t interval_ns = 7'500'000;  ///< between samples: 133 Hz
  double resolution_mm = 0.03;           ///< positions are multiples of this; 0: not quantised
  double pressure_step = 1.0 / 1024.0;   ///< pressures are multiples of this; 0: not quantised
  double tremor_mm = 0.03;               ///< RMS of physiological tremor, 8-12 Hz, per axis
  double wander_mm = 0.12;               ///< RMS of slow wandering around the aim, below 2.5 Hz
  std::uint64_t seed = 1;
};

/// A simulated hand that writes and draws. It generates pen samples that look like those of a
/// person, for tests, benchmarks and demonstrations. The same options and gestures give the same
/// samples, except that the machine's libm may differ in the last digits before quantisation.
///
/// The position at which the hand aims moves along a smooth path through the points of the gesture,
/// at the pace that `hand_path.h` computes. This motion is smoothed with a symmetric window of 40
/// ms, which models the muscles: fast strokes become smoother, slow strokes hardly change.
/// Wandering and tremor are added. Pressure rises and falls at the ends, is higher in slow parts
/// and in strokes towards the body, and varies slightly.
class WritingHand {
 public:
  explicit WritingHand(const HandOptions& options = {});

  /// Draws one stroke. The times continue after those of the last stroke, with a pause in which the
  /// hand moves to the start of this stroke.
  std::vector<HandSample> draw(const Gesture& gesture);

 private:
  void rest_until_start_of(Point start);

  HandOptions options_;
  Random random_;
  Tones tremor_, wander_, waver_;
  double now_s_ = 0.0;
  std::optional<Point> last_;
};

}  // namespace felt
