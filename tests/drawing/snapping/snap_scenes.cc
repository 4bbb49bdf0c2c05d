#include "tests/drawing/snapping/snap_scenes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/base/random.h"
#include "felt/devices/simulated/samples/drawings.h"

namespace felt::snap_test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double between(Random& random, double low, double high) {
  return random.between(low, high);
}

Vec any_direction(Random& random) {
  const double a = between(random, 0.0, kTurn);
  return {std::cos(a), std::sin(a)};
}

Gesture line(std::vector<Point> via, double pressure = 0.4, double tempo = 1.0) {
  return {.via = std::move(via), .pressure = pressure, .tempo = tempo};
}

/// Returns parallel lines with ends as uneven as those of a real hand.
std::vector<Gesture> hatching(Random& random, Point at, Vec along, Vec step, int count, bool back) {
  std::vector<Gesture> lines;
  const Vec unit = normalized(along);
  for (int i = 0; i < count; ++i) {
    Point a = at + static_cast<double>(i) * step + between(random, -0.6, 0.6) * unit;
    Point b = at + static_cast<double>(i) * step + along + between(random, -0.6, 0.6) * unit;
    if (back && i % 2 == 1) std::swap(a, b);
    lines.push_back(line({a, b}, 0.4, between(random, 0.8, 1.5)));
  }
  return lines;
}

void append(std::vector<Gesture>& all, std::vector<Gesture> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

SnapScene hatched(double spacing_mm) {
  Random random(static_cast<std::uint64_t>(100.0 * spacing_mm));
  SnapScene scene{.name = fmt::format("hatching {:.1f} mm", spacing_mm), .strokes = {}};
  append(scene.strokes, hatching(random, {10, 10}, {18, 2}, {0, spacing_mm}, 20, false));
  append(scene.strokes, hatching(random, {60, 10}, {12, 9}, {0, 1.25 * spacing_mm}, 20, true));
  append(scene.strokes, hatching(random, {100, 10}, {0, 6}, {spacing_mm, 0}, 20, false));
  return scene;
}

SnapScene cross_hatched() {
  Random random(3);
  SnapScene scene{.name = "cross-hatching", .strokes = {}};
  for (const double s : {1.0, 1.5, 2.0}) {
    const Point at{10 + 60 * (s - 1.0), 10};
    append(scene.strokes, hatching(random, at, {20, 0}, {0, s}, 13, false));
    append(scene.strokes, hatching(random, at, {0, 13 * s}, {s, 0}, 13, true));
  }
  return scene;
}

/// Returns six patches, each shaded with four zigzags, and one that is hatched three times.
SnapScene shaded() {
  Random random(4);
  SnapScene scene{.name = "shading", .strokes = {}};
  for (int patch = 0; patch < 6; ++patch) {
    for (int pass = 0; pass < 4; ++pass) {
      std::vector<Point> via;
      for (int i = 0; i < 14; ++i) {
        const Vec jitter{between(random, -0.5, 0.5), between(random, -0.5, 0.5)};
        const double along = i % 2 == 0 ? 0.0 : 12.0, step = 0.9 * i;
        const Vec offset = pass % 2 == 0 ? Vec{along, step} : Vec{step, along};
        const Point p = Point{10.0 + 25 * patch, 10} + offset + jitter;
        via.push_back(p);
        if (i > 0 && i < 13) via.push_back(p);  // a repeated point makes a corner
      }
      scene.strokes.push_back(line(via, 0.3, 1.5));
    }
  }
  for (int pass = 0; pass < 3; ++pass) {
    append(scene.strokes, hatching(random, {10, 60}, {20, 3}, {0, 1.2}, 14, pass == 1));
  }
  return scene;
}

SnapScene grass() {
  Random random(5);
  SnapScene scene{.name = "grass and fur", .strokes = {}};
  for (int i = 0; i < 80; ++i) {
    const Point root{10 + 1.1 * i, 60 + between(random, -0.8, 0.8)};
    const double sway = between(random, -4, 4), tall = between(random, 5, 11);
    scene.strokes.push_back(
        line({root, root + Vec{0.2 * sway, -0.5 * tall}, root + Vec{sway, -tall}}, 0.4,
             between(random, 1.0, 2.0)));
  }
  return scene;
}

SnapScene dashes() {
  SnapScene scene{.name = "dashes and dots", .strokes = {}};
  for (int i = 0; i < 40; ++i) {
    const Point at{10 + 7.0 * (i % 20), 20.0 + 10 * (i / 20)};
    scene.strokes.push_back(line({at, at + Vec{5.0 - 0.5 * (i / 20), 0.3}}));
  }
  for (int i = 0; i < 40; ++i) {
    const Point at{10 + 1.3 * i, 50};
    scene.strokes.push_back(line({at}));
    if (i % 3 == 0) scene.strokes.push_back(line({at + Vec{0, 2}, at + Vec{6, 8}}));
  }
  return scene;
}

SnapScene words() {
  SnapScene scene{.name = "words", .strokes = {}};
  double y = 20;
  for (const double height : {2.0, 2.5, 3.0, 4.0, 6.0}) {
    for (int row = 0; row < 4; ++row) {
      append(scene.strokes, cursive("the lion n e l e l o f hill felt then noon", {10, y}, height));
      y += 4 * height;
    }
  }
  return scene;
}

/// Returns an ellipse without its last `gap_mm`. It starts at the angle `from`, in radians.
std::vector<Point> outline(Point center, Vec radii, double from, double gap_mm) {
  const double around = kTurn * std::sqrt(0.5 * norm_squared(radii));
  const double turns = 1.0 - gap_mm / around;
  std::vector<Point> via;
  for (int i = 0; i <= 24; ++i) {
    const double a = from + kTurn * turns * i / 24;
    via.push_back(center + Vec{radii.x * std::cos(a), radii.y * std::sin(a)});
  }
  return via;
}

/// Returns the vector by which an end misses the start: up to 1.5 mm in any direction.
Vec miss(Random& random) {
  return 1.5 * std::sqrt(random.between(0.0, 1.0)) * any_direction(random);
}

SnapScene round_shapes(const std::string& name, double shape) {
  Random random(6);
  SnapScene scene{.name = name, .strokes = {}, .lines_per_shape = 1};
  for (int i = 0; i < 48; ++i) {
    const double d = std::array{3.0, 4.0, 5.0, 7.0, 10.0, 20.0}[static_cast<std::size_t>(i % 6)];
    const Point center{20.0 + 34 * (i % 6), 20.0 + 26.0 * (i / 6)};
    const double gap = between(random, 0.0, 1.5);
    auto via = outline(center, {0.5 * d * shape, 0.5 * d}, between(random, 0, kTurn), gap);
    // A hand misses its start sideways by only a part of the gap, also with other shapes.
    via.back() += 0.25 * std::max(0.4, gap) * any_direction(random);
    scene.strokes.push_back(line(via));
  }
  return scene;
}

std::vector<Point> corners_of(Point at, double side) {
  return {at, at + Vec{side, 0}, at + Vec{side, side}, at + Vec{0, side}};
}

SnapScene squares(bool one_line) {
  Random random(7);
  SnapScene scene{.name = one_line ? "squares" : "squares of four lines",
                  .strokes = {},
                  .lines_per_shape = one_line ? 1 : 4};
  for (int i = 0; i < 30; ++i) {
    const double side = std::array{3.0, 4.0, 6.0, 10.0, 25.0}[static_cast<std::size_t>(i % 5)];
    const auto p = corners_of({20.0 + 32 * (i % 5), 20.0 + 32.0 * (i / 5)}, side);
    const Point last = p[0] + (side < 5 ? 0.7 : 1.0) * miss(random);
    if (one_line) {
      scene.strokes.push_back(line({p[0], p[1], p[1], p[2], p[2], p[3], p[3], last}));
    } else {
      const auto near = [&](Point q) {
        return q + between(random, 0.0, 0.7) * any_direction(random);
      };
      scene.strokes.push_back(line({p[0], p[1]}));
      scene.strokes.push_back(line({near(p[1]), p[2]}));
      scene.strokes.push_back(line({near(p[2]), p[3]}));
      scene.strokes.push_back(line({near(p[3]), near(p[0])}));
    }
  }
  return scene;
}

/// Returns three quarters of an outline, and a second line that closes it.
SnapScene continued() {
  Random random(8);
  SnapScene scene{.name = "continued lines", .strokes = {}, .lines_per_shape = 2};
  for (int i = 0; i < 30; ++i) {
    const double d = std::array{4.0, 6.0, 10.0, 15.0, 25.0}[static_cast<std::size_t>(i % 5)];
    const Point center{20.0 + 32 * (i % 5), 20.0 + 32.0 * (i / 5)};
    const auto ring = outline(center, {0.5 * d, 0.5 * d}, between(random, 0, kTurn), 0.0);
    std::vector<Point> first(ring.begin(), ring.begin() + 17),
        second(ring.begin() + 16, ring.end());
    second.front() += between(random, 0.0, 0.7) * any_direction(random);
    second.back() = second.back() + 0.5 * miss(random);
    scene.strokes.push_back(line(first));
    scene.strokes.push_back(line(second));
  }
  return scene;
}

}  // namespace

std::vector<SnapScene> scenes_to_leave_alone() {
  std::vector<SnapScene> scenes;
  for (const double spacing : {0.7, 1.0, 1.5, 1.8, 2.0, 3.0}) scenes.push_back(hatched(spacing));
  scenes.push_back(cross_hatched());
  scenes.push_back(shaded());
  scenes.push_back(grass());
  scenes.push_back(dashes());
  scenes.push_back(words());
  return scenes;
}

std::vector<SnapScene> scenes_to_close() {
  return {round_shapes("circles", 1.0),
          round_shapes("ellipses", 1.7),
          round_shapes("letters o", 0.75),
          squares(true),
          squares(false),
          continued()};
}

}  // namespace felt::snap_test
