#include <cmath>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/devices/simulated/samples/drawings.h"

namespace felt {
namespace {

constexpr int kPointsPerTurn = 10;

Vec on_circle(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

void add_hatching(std::vector<Gesture>& page, Point at) {
  for (int i = 0; i < 14; ++i) {
    const Point low = at + Vec{2.2 * i, 16.0}, high = at + Vec{2.2 * i + 9.0, 0.0};
    Gesture g = straight_line(low, high);
    g.pressure = 0.2 + 0.045 * i;
    g.tempo = 1.8;
    g.end_pressure = 0.2;
    page.push_back(g);
  }
}

void add_shading(std::vector<Gesture>& page, Point at) {
  Gesture g = zigzag(at, {1.1, 14.0}, 25);
  g.pressure = 0.3;
  g.tempo = 2.2;
  page.push_back(g);
}

}  // namespace

Gesture straight_line(Point from, Point to) {
  return {.via = {from, lerp(from, to, 0.35), lerp(from, to, 0.7), to}};
}

Gesture zigzag(Point at, Vec step, int corners) {
  Gesture g{.via = {at}};
  for (int i = 1; i <= corners + 1; ++i) {
    const Point p = at + Vec{step.x * i, i % 2 == 0 ? 0.0 : step.y};
    g.via.push_back(p);
    if (i <= corners) g.via.push_back(p);
  }
  return g;
}

Gesture loops(Point at, double radius_mm, double advance_mm, int turns) {
  Gesture g;
  for (int i = 0; i <= turns * kPointsPerTurn; ++i) {
    const double turn = i / double(kPointsPerTurn);
    const Vec v = radius_mm * on_circle(kTau * (0.25 - turn));
    g.via.push_back(at + Vec{advance_mm * turn + 0.7 * v.x - 0.25 * v.y, v.y - radius_mm});
  }
  return g;
}

Gesture spiral(Point center, double radius_mm, int turns) {
  Gesture g;
  for (int i = 0; i <= turns * kPointsPerTurn; ++i) {
    const double turn = i / double(kPointsPerTurn);
    g.via.push_back(center + radius_mm * (0.05 + 0.95 * turn / turns) * on_circle(kTau * turn));
  }
  return g;
}

Gesture wave(Point at, double length_mm, double height_mm, int periods) {
  Gesture g;
  const int count = 6 * periods;
  for (int i = 0; i <= count; ++i) {
    const double x = i / double(count);
    g.via.push_back(at + Vec{length_mm * x, -0.5 * height_mm * std::sin(kTau * periods * x)});
  }
  return g;
}

std::vector<Gesture> exercise_page() {
  std::vector<Gesture> page;
  for (int i = 0; i < 4; ++i) {
    Gesture g = straight_line({12.0, 14.0 + 5.0 * i}, {80.0, 14.0 + 5.0 * i});
    g.pressure = 0.18 + 0.2 * i;
    page.push_back(g);
  }
  page.push_back(wave({92.0, 16.0}, 66.0, 9.0, 5));
  Gesture swell = wave({92.0, 28.0}, 66.0, 3.0, 1);
  swell.pressure = 0.9;
  swell.end_pressure = 0.05;
  page.push_back(swell);
  page.push_back(loops({16.0, 52.0}, 6.0, 6.5, 10));
  page.push_back(loops({96.0, 50.0}, 3.5, 3.6, 17));
  page.push_back(zigzag({12.0, 74.0}, {5.5, -12.0}, 11));
  page.push_back(spiral({104.0, 76.0}, 15.0, 5));
  add_hatching(page, {126.0, 62.0});
  add_shading(page, {124.0, 84.0});
  for (int i = 0; i < 5; ++i) {
    Gesture circle = spiral({18.0 + 13.0 * i, 92.0}, 5.0, 1);
    for (std::size_t k = 0; k < circle.via.size(); ++k) {
      circle.via[k] = Point{18.0 + 13.0 * i, 92.0} +
                      (1.5 + i) * on_circle(-kTau * double(k) / kPointsPerTurn - 1.5);
    }
    page.push_back(circle);
  }
  for (int i = 0; i < 8; ++i) {
    page.push_back({.via = {{16.0 + 7.0 * i, 106.0}}, .pressure = 0.12 + 0.11 * i});
  }
  for (const Gesture& g : cursive("feltline", {84.0, 110.0}, 5.0)) page.push_back(g);
  return page;
}

}  // namespace felt
