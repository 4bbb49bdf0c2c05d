#include "bench/steady/shaky_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace felt::bench {
namespace {

constexpr double kMinS = 1.5, kMaxS = 8.0;
constexpr std::size_t kMinSamples = 30;
constexpr double kIntendedHz = 12.0;
constexpr double kDriftS = 2.0, kDriftHz = 0.5, kDriftShare = 0.35;

struct TimedPoint {
  Point at;
  double s = 0.0;
};

/// A Butterworth low-pass of order 2, forward and backward.
void low_pass(std::vector<double>& v) {
  const double k = std::tan(std::numbers::pi * kIntendedHz / kRateHz);
  const double n = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  const double b = k * k * n, a1 = 2.0 * (k * k - 1.0) * n;
  const double a2 = (1.0 - std::numbers::sqrt2 * k + k * k) * n;
  for (int pass = 0; pass < 2; ++pass) {
    double x1 = v[0], x2 = v[0], y1 = v[0], y2 = v[0];
    for (double& x : v) {
      const double y = b * (x + 2.0 * x1 + x2) - a1 * y1 - a2 * y2;
      x2 = x1;
      x1 = x;
      y2 = y1;
      x = y1 = y;
    }
    std::reverse(v.begin(), v.end());
  }
}

/// Continues the line at both ends by its mirror image about the end, so that the filter has
/// settled when it reaches the line.
std::vector<double> filtered(const std::vector<double>& values) {
  constexpr std::size_t kPad = 40;
  const std::size_t last = values.size() - 1;
  std::vector<double> padded;
  for (std::size_t i = kPad; i > 0; --i)
    padded.push_back(2 * values[0] - values[std::min(i, last)]);
  padded.insert(padded.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= kPad; ++i) {
    padded.push_back(2 * values[last] - values[last - std::min(i, last)]);
  }
  low_pass(padded);
  return {padded.begin() + kPad, padded.end() - kPad};
}

InkSample sample_at(Point p, double s) {
  return {p, 0.5, std::llround(1e9 * s)};
}

Line intended(const std::vector<TimedPoint>& points) {
  std::vector<double> x, y;
  std::size_t i = 0;
  const double start = points.front().s;
  for (double s = start; s <= points.back().s; s += 1.0 / kRateHz) {
    while (i + 2 < points.size() && points[i + 1].s < s) ++i;
    const double step = points[i + 1].s - points[i].s;
    const double u = step > 0.0 ? std::clamp((s - points[i].s) / step, 0.0, 1.0) : 0.0;
    const Point p = lerp(points[i].at, points[i + 1].at, u);
    x.push_back(p.x);
    y.push_back(p.y);
  }
  x = filtered(x);
  y = filtered(y);
  Line line;
  for (std::size_t k = 0; k < x.size(); ++k) {
    line.push_back(sample_at({x[k], y[k]}, static_cast<double>(k) / kRateHz));
  }
  return line;
}

std::vector<TimedPoint> points_of(const std::string& text, double mm_per_unit) {
  std::vector<TimedPoint> points;
  const nlohmann::json stroke = nlohmann::json::parse(text);
  if (!stroke.contains("points")) return {};
  for (const auto& p : stroke["points"]) {
    if (p.size() < 4 || !p[3].is_number()) return {};
    points.push_back({{mm_per_unit * p[0].get<double>(), mm_per_unit * p[1].get<double>()},
                      1e-3 * p[3].get<double>()});
  }
  return points;
}

}  // namespace

std::vector<Line> read_intended(const std::vector<std::string>& paths, double mm_per_unit) {
  std::vector<Line> lines;
  for (const std::string& path : paths) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error(path + ": cannot open");
    for (std::string text; std::getline(in, text);) {
      const std::vector<TimedPoint> points = points_of(text, mm_per_unit);
      if (points.size() < kMinSamples) continue;
      const double s = points.back().s - points.front().s;
      if (s >= kMinS && s <= kMaxS) lines.push_back(intended(points));
    }
  }
  return lines;
}

Line spiral_line() {
  constexpr double kSeconds = 10.0, kTurns = 6.0, kRadiusMm = 45.0;
  Line line;
  for (double s = 0.0; s <= kSeconds; s += 1.0 / kRateHz) {
    const double u = s / kSeconds, a = kTau * kTurns * u;
    line.push_back(sample_at(Point{kRadiusMm * u * std::cos(a), kRadiusMm * u * std::sin(a)}, s));
  }
  return line;
}

ShakyHand random_hand(double amplitude_mm, Random& random) {
  ShakyHand hand;
  hand.hz = random.between(4.0, 7.0);
  hand.amplitude_mm = amplitude_mm;
  hand.axis_rad = random.between(0.0, std::numbers::pi);
  hand.across = random.between(0.0, 0.5);
  return hand;
}

Line shaken(const Line& line, const ShakyHand& hand, Random& random) {
  double phase = random.between(0.0, kTau);
  double hz = kDriftHz * random.normal(), size = kDriftShare * random.normal();
  const double dt = 1.0 / kRateHz, left = std::exp(-dt / kDriftS);
  const double fresh = std::sqrt(1.0 - left * left);
  const Vec axis{std::cos(hand.axis_rad), std::sin(hand.axis_rad)}, across{-axis.y, axis.x};
  Line result = line;
  for (InkSample& sample : result) {
    const double amplitude = hand.amplitude_mm * std::max(0.0, 1.0 + size);
    sample.position +=
        amplitude * std::cos(phase) * axis + hand.across * amplitude * std::sin(phase) * across;
    phase += kTau * (hand.hz + hz) * dt;
    hz = left * hz + fresh * kDriftHz * random.normal();
    size = left * size + fresh * kDriftShare * random.normal();
  }
  return result;
}

}  // namespace felt::bench
