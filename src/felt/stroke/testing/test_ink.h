#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <ostream>
#include <random>
#include <vector>

#include "felt/geometry/point.h"

namespace felt::testing {

/// Kinds of ink, from ordinary handwriting to ink that no hand would draw.
enum class InkShape {
  kSmooth,      ///< gentle bends, a sample every 0.5 mm
  kDense,       ///< 1 kHz: a sample every 0.1 mm, with tremor, quantised to 0.03 mm
  kSparse,      ///< a mouse: gaps of 2 to 15 mm, quantised to 0.25 mm
  kZigzag,      ///< straight legs with sharp turns
  kSpiral,      ///< from a point to 20 mm and more
  kHairpin,     ///< forward and back on almost the same path
  kResting,     ///< dense, with rests in which the sensor trembles
  kDuplicates,  ///< every position reported up to 20 times
  kFractal,     ///< bends at every scale
  kSawtooth,    ///< teeth as high as a tolerance
  kJumps,       ///< steps from a hundredth of a millimetre to a metre
  kLine,        ///< back and forth along one straight line
  kBlob,        ///< a scribble within a fraction of a millimetre
  kGrid,        ///< a walk on whole pixels
};

inline constexpr std::array kAllShapes = {
    InkShape::kSmooth,  InkShape::kDense,   InkShape::kSparse,   InkShape::kZigzag,
    InkShape::kSpiral,  InkShape::kHairpin, InkShape::kResting,  InkShape::kDuplicates,
    InkShape::kFractal, InkShape::kJumps,   InkShape::kSawtooth, InkShape::kLine,
    InkShape::kBlob,    InkShape::kGrid};

inline std::ostream& operator<<(std::ostream& out, InkShape shape) {
  constexpr std::array kNames = {"smooth",  "dense",   "sparse",     "zigzag",  "spiral",
                                 "hairpin", "resting", "duplicates", "fractal", "sawtooth",
                                 "jumps",   "line",    "blob",       "grid"};
  return out << kNames[static_cast<std::size_t>(shape)];
}

/// Makes random ink for tests of the fit. The same seed gives the same ink.
class TestInk {
 public:
  explicit TestInk(std::uint64_t seed) : random_(seed) {}

  /// Returns `count` samples (at least one) of ink of the given shape, in mm.
  std::vector<Point> draw(InkShape shape, int count) {
    std::vector<Point> ink;
    ink.reserve(static_cast<std::size_t>(count));
    start();
    for (int i = 0; i < count; ++i) ink.push_back(next(shape, i));
    return ink;
  }

  /// Returns 2 to `most` samples of ink of any shape.
  std::vector<Point> draw_any(int largest) {
    const auto last = static_cast<int>(kAllShapes.size()) - 1;
    return draw(kAllShapes[static_cast<std::size_t>(pick(0, last))], pick(2, largest));
  }

  /// Returns a tolerance between 0.05 and 3 mm; its logarithm is uniform.
  double tolerance() { return 0.05 * std::pow(60.0, uniform(0.0, 1.0)); }

  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }
  int pick(int a, int b) { return std::uniform_int_distribution<int>(a, b)(random_); }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }
  Vec noise(double sigma) {
    std::normal_distribution<double> normal(0.0, 1.0);
    const double x = normal(random_), y = normal(random_);
    return {sigma * x, sigma * y};
  }
  Vec direction(double length = 1.0) {
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    return length * Vec{std::cos(angle), std::sin(angle)};
  }

 private:
  void start() {
    origin_ = at_ = {uniform(20.0, 180.0), uniform(20.0, 260.0)};
    heading_ = uniform(0.0, 2.0 * std::numbers::pi);
    scale_ = std::pow(10.0, uniform(-1.5, 0.5));
    left_ = 0;
    for (Wave& wave : waves_) {
      wave = {uniform(0.0, 0.4), uniform(0.02, 0.3), uniform(0.0, 2.0 * std::numbers::pi)};
    }
    path_ = 0.0;
  }

  Point next(InkShape shape, int i) {
    switch (shape) {
      case InkShape::kSmooth:
        return wander(0.5);
      case InkShape::kDense:
        return quantised(wander(0.1) + noise(0.02), 0.03);
      case InkShape::kSparse:
        return quantised(wander(uniform(2.0, 15.0)), 0.25);
      case InkShape::kZigzag:
        return quantised(leg(0.3, 2.0, 0.3) + noise(0.01), 0.03);
      case InkShape::kSpiral:
        return origin_ + spiral(0.05 * i);
      case InkShape::kHairpin:
        return leg(0.2, std::numbers::pi - 0.05, 0.05) + noise(0.003);
      case InkShape::kResting:
        return quantised(rest(300) ? at_ + noise(0.03) : wander(0.1), 0.01);
      case InkShape::kDuplicates:
        return rest(20) ? at_ : wander(0.4);
      case InkShape::kFractal:
        return at_ = at_ + direction(0.3 * std::pow(uniform(0.01, 1.0), -0.7)) * scale_;
      case InkShape::kSawtooth:
        return origin_ + scale_ * Vec{0.3 * i, i % 2 == 0 ? 0.5 : -0.5};
      case InkShape::kJumps:
        return at_ = at_ + direction(std::pow(10.0, uniform(-2.0, 3.0)));
      case InkShape::kLine:
        return origin_ + uniform(-5.0, 5.0) * Vec{std::cos(heading_), std::sin(heading_)};
      case InkShape::kBlob:
        return origin_ + direction(0.3 * scale_ * uniform(0.0, 1.0));
      case InkShape::kGrid:
        return at_ = at_ + scale_ * Vec{double(pick(-1, 1)), double(pick(-1, 1))};
    }
    return at_;
  }

  // Takes one step forward; the curvature is a sum of waves over the path, at most 1.2 per mm.
  Point wander(double step_mm) {
    double bend = 0.0;
    for (const Wave& w : waves_) bend += w.height * std::sin(w.frequency * path_ + w.phase);
    path_ += step_mm;
    heading_ += bend * step_mm * (step_mm > 1.0 ? 0.3 : 1.0);
    return at_ = at_ + step_mm * Vec{std::cos(heading_), std::sin(heading_)};
  }

  // Takes one step along a straight leg of 10 to 60 samples; turns by turn +- spread between legs.
  Point leg(double step_mm, double turn, double spread) {
    if (left_-- == 0) {
      left_ = pick(10, 60);
      heading_ += (chance(0.5) ? 1.0 : -1.0) * uniform(turn - spread, turn + spread);
    }
    return at_ = at_ + step_mm * Vec{std::cos(heading_), std::sin(heading_)};
  }

  // Returns true while the pen rests, for up to `most` samples at a time.
  bool rest(int largest) {
    if (left_ == 0) left_ = chance(0.1) ? pick(1, largest) : -pick(1, 10);
    left_ += left_ > 0 ? -1 : 1;
    return left_ > 0;
  }

  [[nodiscard]] Vec spiral(double angle) const {
    return scale_ * angle * Vec{std::cos(angle), std::sin(angle)};
  }

  static Point quantised(Point p, double step_mm) {
    return {step_mm * std::round(p.x / step_mm), step_mm * std::round(p.y / step_mm)};
  }

  struct Wave {
    double height = 0.0, frequency = 0.0, phase = 0.0;
  };

  std::mt19937_64 random_;
  Point origin_, at_;
  double heading_ = 0.0, scale_ = 1.0, path_ = 0.0;
  int left_ = 0;
  std::array<Wave, 3> waves_;
};

}  // namespace felt::testing
