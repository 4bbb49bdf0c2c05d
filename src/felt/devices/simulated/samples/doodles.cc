#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "felt/base/random.h"
#include "felt/devices/simulated/samples/drawings.h"

namespace felt {
namespace {

int whole_between(Random& random, int low, int high) {
  return static_cast<int>(random.between(low, high + 1));
}

std::string word(Random& random) {
  std::string letters;
  for (int i = whole_between(random, 1, 6); i > 0; --i) {
    letters += std::string_view("efhilnot")[static_cast<std::size_t>(whole_between(random, 0, 7))];
  }
  return letters;
}

// Returns a random walk with gentle turns and occasional corners.
Gesture doodle(Random& random, Point at) {
  Gesture g{.via = {at}};
  const double step_mm = random.between(1.5, 12.0), bend_rad = random.between(0.2, 1.3);
  double heading = random.between(0.0, 2.0 * std::numbers::pi);
  for (int i = whole_between(random, 2, 25); i > 0; --i) {
    const bool corner = random.between(0.0, 1.0) < 0.08;
    if (corner) g.via.push_back(g.via.back());
    heading += corner ? random.between(1.2, 2.6) : random.between(-bend_rad, bend_rad);
    g.via.push_back(g.via.back() + step_mm * Vec{std::cos(heading), std::sin(heading)});
  }
  return g;
}

// Returns one exercise, word or doodle. Random numbers are generated one by one, because the order
// in which a compiler evaluates arguments is unspecified.
std::vector<Gesture> anything(Random& random, Point at) {
  const int kind = whole_between(random, 0, 7), count = whole_between(random, 1, 9);
  const double size = random.between(0.0, 1.0), other = random.between(-1.0, 1.0);
  switch (kind) {
    case 0:
      return {straight_line(at, at + Vec{100.0 * size - 50.0, 60.0 * other})};
    case 1:
      return {zigzag(at, {0.8 + 5.0 * size, 12.0 * other}, count)};
    case 2:
      return {loops(at, 1.5 + 8.0 * size, 1.0 + 5.0 * std::fabs(other), count)};
    case 3:
      return {spiral(at, 2.0 + 22.0 * size, count)};
    case 4:
      return cursive(word(random), at, 1.8 + 5.0 * size);
    default:
      return {doodle(random, at)};
  }
}

}  // namespace

std::vector<Gesture> random_gestures(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<Gesture> gestures;
  while (gestures.size() < count) {
    const Point at{random.between(20.0, 180.0), random.between(30.0, 250.0)};
    const double pressure = random.between(0.15, 0.95), tempo = random.between(0.5, 2.5);
    for (Gesture& g : anything(random, at)) {
      g.pressure = pressure;
      g.tempo = tempo;
      gestures.push_back(std::move(g));
    }
  }
  gestures.resize(count);
  return gestures;
}

}  // namespace felt
