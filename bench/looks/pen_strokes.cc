#include "pen_strokes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace felt::bench {
namespace {

constexpr double kSpeedMmPerS = 60.0;
constexpr double kIntervalS = 0.0075;

/// Returns the samples of a pen that moves along `at`, for t in 0..1, over about `length_mm`.
PenStroke sampled(double length_mm, const std::function<Point(double)>& at,
                  const std::function<double(double)>& pressure) {
  PenStroke stroke;
  const int count = std::max(2, static_cast<int>(length_mm / kSpeedMmPerS / kIntervalS));
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    stroke.push_back({at(t), pressure(t), std::llround(1e9 * kIntervalS * i), 0.0});
  }
  return stroke;
}

}  // namespace

PenStroke line_of(Point from, Point to, double first_pressure, double last_pressure) {
  return sampled(
      norm(to - from), [=](double t) { return from + t * (to - from); },
      [=](double t) { return std::lerp(first_pressure, last_pressure, t); });
}

TestPage ramp() {
  return {kRampX1 + 10.0,
          2.0 * kRampY,
          {line_of({kRampX0, kRampY}, {kRampX1, kRampY}, kRampFrom, kRampTo)}};
}

TestPage even_lines(double pressure, int times) {
  TestPage page{kRampX1 + 10.0, kEvenApart * kEvenLines, {}};
  for (int i = 0; i < kEvenLines; ++i) {
    const double y = kEvenApart * (i + 0.5);
    for (int n = 0; n < times; ++n) {
      page.strokes.push_back(line_of({kRampX0, y}, {kRampX1, y}, pressure, pressure));
    }
  }
  return page;
}

TestPage lines_there_and_back(double pressure) {
  TestPage page = even_lines(pressure, 1);
  for (PenStroke& stroke : page.strokes) {
    const std::int64_t end_ns = stroke.back().time_ns.value_or(0);
    for (std::size_t i = stroke.size() - 1; i-- > 0;) {
      InkSample back = stroke[i];
      back.time_ns = 2 * end_ns - back.time_ns.value_or(0);
      stroke.push_back(back);
    }
  }
  return page;
}

TestPage chart_cell() {
  TestPage page{86.0, 34.0, {}};
  page.strokes.push_back(line_of({4, 5}, {82, 5}, kRampFrom, kRampTo));
  const auto swell = [](double t) { return 0.9 * std::sin(std::numbers::pi * t); };
  page.strokes.push_back(sampled(
      44,
      [](double t) {
        return Point{4 + 36 * t, 14 + 3.5 * std::sin(9 * t)};
      },
      swell));
  for (int i = 0; i < 7; ++i) {
    page.strokes.push_back(line_of({4 + 2.2 * i, 31}, {14 + 2.2 * i, 22}, 0.45, 0.3));
    page.strokes.push_back(line_of({2 + 2.2 * i, 22}, {12 + 2.2 * i, 31}, 0.45, 0.3));
  }
  page.strokes.push_back(sampled(
      260,
      [](double t) {
        const double zigzag = 2.0 * std::abs(20.0 * t - std::floor(20.0 * t + 0.5));
        return Point{48 + 28 * t + 4 * zigzag, 30 - 18 * zigzag};
      },
      [](double t) { return 0.2 + 0.6 * t; }));
  return page;
}

}  // namespace felt::bench
