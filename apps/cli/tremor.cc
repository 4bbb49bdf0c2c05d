#include "tremor.h"

#include <cmath>
#include <numbers>

#include "felt/devices/simulated/random.h"

namespace felt::cli {
namespace {

constexpr double kRmsMm = 0.03;
constexpr double kTurn = 2.0 * std::numbers::pi;

}  // namespace

Tremor::Tremor(std::uint64_t seed) {
  if (seed == 0) return;
  Random random(seed);
  for (Tone& tone : tones_) {
    tone = {random.between(8.0, 12.0), random.between(0.0, kTurn), random.between(0.0, kTurn)};
  }
  // Squares of tones of different frequencies add.
  amplitude_mm_ = kRmsMm * std::sqrt(2.0 / static_cast<double>(tones_.size()));
}

Vec Tremor::at(std::int64_t time_ns) const noexcept {
  if (amplitude_mm_ == 0.0) return {};
  const double t_s = 1e-9 * static_cast<double>(time_ns);
  Vec sum;
  for (const Tone& tone : tones_) {
    sum.x += std::sin(kTurn * tone.hz * t_s + tone.phase_x);
    sum.y += std::sin(kTurn * tone.hz * t_s + tone.phase_y);
  }
  return amplitude_mm_ * sum;
}

}  // namespace felt::cli
