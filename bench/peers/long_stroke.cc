#include <random>

#include "bench/peers/ink_data.h"

namespace felt::bench {
namespace {

using fit_check::Point;

/// Generates the positions of a pen. Each phase has its own speed and curvature. All lengths are in
/// tolerances.
class LongStroke {
 public:
  explicit LongStroke(unsigned seed) : random_(seed) {}

  Point next() {
    if (left_ == 0) begin_phase();
    --left_;
    ++tick_;
    advance();
    const Point noisy{place_.x + 0.1 * normal(), place_.y + 0.1 * normal()};
    return {quantised(noisy.x), quantised(noisy.y)};
  }

 private:
  enum class Phase { kSlowLine, kSlowRound, kRest, kWriting, kZigzag, kJump, kCount };
  static constexpr double kQuantum = 0.15;
  static constexpr double kSurface = 2000.0;

  /// Returns the same numbers with every standard library, unlike the distributions of <random>.
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
  }
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform(0.0, 1.0);
    return sum;
  }
  static double quantised(double value) { return std::round(value / kQuantum) * kQuantum; }

  void begin_phase() {
    phase_ = static_cast<Phase>(random_() % static_cast<unsigned>(Phase::kCount));
    left_ = static_cast<int>(uniform(500.0, 6000.0));
    curvature_ = 0.0;
    speed_ = uniform(0.005, 0.05);
    switch (phase_) {
      case Phase::kSlowRound:
        curvature_ = uniform(-0.02, 0.02);
        break;
      case Phase::kRest:
        speed_ = 0.0;
        break;
      case Phase::kWriting:
        speed_ = uniform(0.2, 1.0);
        break;
      case Phase::kZigzag:
        speed_ = uniform(0.5, 3.0);
        break;
      case Phase::kJump:
        left_ = static_cast<int>(uniform(2.0, 8.0));
        speed_ = uniform(20.0, 200.0);
        break;
      default:
        break;
    }
  }

  void advance() {
    double step = speed_;
    if (phase_ == Phase::kWriting) {
      curvature_ = 0.12 * std::sin(0.031 * tick_) + 0.08 * std::sin(0.0173 * tick_ + 1.0);
      step *= 1.0 + 0.8 * std::sin(0.05 * tick_);
    }
    if (phase_ == Phase::kZigzag && left_ % 90 == 0) heading_ += 2.4;
    if (phase_ == Phase::kJump) heading_ += uniform(-2.0, 2.0);
    heading_ += curvature_ * step;
    if (std::fabs(place_.x) > kSurface || std::fabs(place_.y) > kSurface) {
      heading_ = std::atan2(-place_.y, -place_.x);  // toward the middle
    }
    place_ = place_ + step * Point{std::cos(heading_), std::sin(heading_)};
  }

  std::mt19937_64 random_;
  Phase phase_ = Phase::kRest;
  int left_ = 0;
  double tick_ = 0.0;
  Point place_;
  double heading_ = 0.3, curvature_ = 0.0, speed_ = 0.0;
};

}  // namespace

fit_check::Ink make_long_stroke(std::int64_t count, double tolerance, unsigned seed) {
  LongStroke stroke(seed);
  fit_check::Ink ink{"long-" + std::to_string(count), "generated", {}};
  ink.samples.reserve(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i) ink.samples.push_back(tolerance * stroke.next());
  return ink;
}

}  // namespace felt::bench
