#include "bench/steady/peers.h"

#include <algorithm>
#include <cmath>

namespace felt::bench {
namespace {

constexpr std::size_t kAveraged = 20;
constexpr double kMinCutoffHz = 0.8, kBeta = 0.02, kSpeedCutoffHz = 1.0;

double share_of_new(double cutoff_hz, double dt_s) {
  return dt_s / (dt_s + 1.0 / (kTau * cutoff_hz));
}

struct OneEuro {
  double value, speed = 0.0;

  void push(double next, double dt_s) {
    // The speed is that of the measured positions (the filtered one in the paper's first form).
    speed += share_of_new(kSpeedCutoffHz, dt_s) * ((next - last) / dt_s - speed);
    last = next;
    value += share_of_new(kMinCutoffHz + kBeta * std::fabs(speed), dt_s) * (next - value);
  }
  double last = value;
};

}  // namespace

Line averaged(const Line& line) {
  Line result = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t count = std::min(i + 1, kAveraged);
    Vec sum;
    for (std::size_t k = 0; k < count; ++k) sum += line[i - k].position - Point{};
    result[i].position = Point{} + sum / static_cast<double>(count);
  }
  return result;
}

Line one_euro(const Line& line) {
  Line result = line;
  OneEuro x{line[0].position.x}, y{line[0].position.y};
  for (std::size_t i = 1; i < line.size(); ++i) {
    x.push(line[i].position.x, 1.0 / kRateHz);
    y.push(line[i].position.y, 1.0 / kRateHz);
    result[i].position = {x.value, y.value};
  }
  return result;
}

}  // namespace felt::bench
