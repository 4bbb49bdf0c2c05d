#include "felt/tools/smooth/ironing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/smooth/testing/jitter_ink.h"

namespace felt::ironing_test {
namespace {

using testing::circle_arc;
using testing::Jitter;
using testing::jittery;
using testing::RandomStroke;
using testing::rms_from;

/// Returns the whole stroke ironed with one dose.
Stroke ironed(const Stroke& stroke, double dose, const IronOptions& options = {}) {
  const ArcMap map(stroke, 1e-5);
  Ironing iron(stroke, map, options);
  for (double s = 0.0; s <= map.length_mm(); s += 1.0) iron.add(s, 10.0, 0.1 * dose);
  return iron.finished().value_or(stroke);
}

/// Returns 300 degrees of a circle in arcs of 30 degrees, accurate to 1e-6 of the radius.
Stroke arcs(Point center, double radius) {
  const double step = std::numbers::pi / 6, handle = 4.0 / 3.0 * std::tan(step / 4) * radius;
  StrokeData d;
  for (int i = 0; i <= 10; ++i) {
    const Vec out{std::cos(i * step), std::sin(i * step)};
    const Point p = center + radius * out;
    if (i > 0) d.points.push_back(p - handle * perp(out));
    d.points.push_back(p);
    if (i < 10) d.points.push_back(p + handle * perp(out));
  }
  d.joints.assign(9, JointKind::kSmooth);
  d.widths = {{0.0, 1.0}, {10.0, 1.0}};
  return Stroke::create(d).value();
}

double exact_length(const Stroke& stroke) {
  return ArcMap(stroke, 1e-5).length_mm();
}

std::vector<FilterPlace> row_of(const std::function<Point(double)>& at, int n, double weight) {
  std::vector<FilterPlace> row;
  for (int k = 0; k < n; ++k) row.push_back({at(0.25 * k), weight, false});
  return row;
}

TEST(JerkFilter, ParabolasStayAndWavesComeThroughAsTheFormulaSays) {
  JerkFilter filter;
  std::vector<Point> out(401);
  auto row = row_of([](double s) { return Point{s, 3 + 0.2 * s - 0.01 * s * s}; }, 401, 1e5);
  filter.apply(row, out);
  for (std::size_t k = 0; k < row.size(); ++k) EXPECT_LT(distance(out[k], row[k].point), 1e-7);
  for (const double wave : {2.0, 5.0, 10.0, 20.0, 40.0}) {
    const double w = 2.0 * std::numbers::pi / wave;
    row = row_of([w](double s) { return Point{s, std::sin(w * s)}; }, 401, jerk_weight(10.0, 0.25));
    filter.apply(row, out);
    double through = 0.0;
    for (std::size_t k = 160; k < 240; ++k) through = std::max(through, std::fabs(out[k].y));
    EXPECT_NEAR(through, 1.0 / (1.0 + std::pow(10.0 / wave, 6.0)), 0.02) << wave;
  }
}

TEST(JerkFilter, IsTheMinimumAndLeavesFixedAndUnweightedPlacesBitForBit) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    RandomStroke random(seed);
    std::vector<FilterPlace> row;
    const int n = random.pick(1, 80);
    for (int k = 0; k < n; ++k) {
      row.push_back({{k + random.uniform(-1, 1), random.uniform(-1, 1)},
                     random.chance(0.2) ? 0.0 : random.uniform(0.0, 50.0),
                     random.chance(0.05)});
    }
    std::vector<Point> out(row.size());
    JerkFilter().apply(row, out);
    const auto cost = [&](const std::vector<Point>& q) {
      double sum = 0.0;
      for (std::size_t k = 0; k < q.size(); ++k) sum += distance_squared(q[k], row[k].point);
      for (std::size_t j = 0; j + 3 < q.size(); ++j) {
        if (row[j + 1].is_fixed || row[j + 2].is_fixed) continue;
        const double w =
            std::min({row[j].weight, row[j + 1].weight, row[j + 2].weight, row[j + 3].weight});
        const Vec jerk = (q[j] - q[j + 3]) - 3.0 * (q[j + 1] - q[j + 2]);
        sum += w * norm_squared(jerk);
      }
      return sum;
    };
    const double smallest = cost(out);
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (row[k].is_fixed || row[k].weight == 0.0) {
        EXPECT_EQ(out[k], row[k].point);
      } else if (out[k] != row[k].point) {
        for (const Vec d : {Vec{1e-4, 0}, Vec{-1e-4, 0}, Vec{0, 1e-4}, Vec{0, -1e-4}}) {
          auto moved = out;
          moved[k] += d;
          EXPECT_GT(cost(moved), smallest);
        }
      }
    }
  }
}

TEST(Ironing, ACircleKeepsItsRadiusThroughFiftyPasses) {
  for (const double radius : {2.0, 3.0, 5.0, 10.0, 20.0, 60.0}) {
    SCOPED_TRACE(radius);
    Stroke stroke = arcs({100, 100}, radius);
    for (int pass = 0; pass < 50; ++pass) stroke = ironed(stroke, 3.0);
    for (int i = 5; i <= 95; ++i) {
      const double r = distance(stroke.position(0.01 * i * stroke.segment_count()), {100, 100});
      EXPECT_NEAR(r, radius, 0.01 * radius) << i;
    }
  }
}

TEST(Ironing, JitterGoesTheShapeStaysAndSegmentsAreFewer) {
  struct Ink {
    const char* name;
    Jitter jitter;
    double share_left;
  };
  // Waves of tremor that are as long as they are high displace the ink from its path, by up to 0.09
  // mm.
  for (const Ink& ink : {Ink{"jitter", {0.2, 0.0}, 0.41}, Ink{"tremor 3 mm", {0.2, 3.0}, 0.6},
                         Ink{"tremor 6 mm", {0.2, 6.0}, 0.4}}) {
    for (const testing::Way& way : {testing::wave(), circle_arc({60, 60}, 30, 0, 270)}) {
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        SCOPED_TRACE(std::string(ink.name) + ", seed " + std::to_string(seed));
        const Stroke before = jittery(way, ink.jitter, seed);
        const Stroke clean = jittery(way, {0.0, 0.0}, seed);
        const Stroke after = ironed(before, 3.0);
        EXPECT_LT(rms_from(after, way, 0.05, 0.95),
                  ink.share_left * rms_from(before, way, 0.05, 0.95));
        EXPECT_LT(after.segment_count(), before.segment_count());
        EXPECT_NEAR(exact_length(after), exact_length(clean), 0.03 * exact_length(clean));
        EXPECT_EQ(after.data().points.front(), before.data().points.front());
        EXPECT_EQ(after.data().points.back(), before.data().points.back());
      }
    }
  }
}

TEST(Ironing, TheCornersOfAShakyLineAreNoCorners) {
  // The line is as drawn with a mouse: back and forth by 1 mm every few millimetres, with sharp
  // turns.
  for (const double height : {1.3, 1.9}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(std::to_string(height) + " mm, seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      std::uniform_real_distribution<double> uniform(0.6, 1.0);
      std::vector<Point> turns{{0, 0}};
      while (turns.back().x < 100.0) {
        const double side = turns.size() % 2 ? 1.0 : -1.0;
        turns.push_back(
            {turns.back().x + 2.0 * uniform(random), 0.5 * side * height * uniform(random)});
      }
      const testing::Way way = [&](double t) {
        const double at = t * (static_cast<double>(turns.size()) - 1.001);
        const auto i = static_cast<std::size_t>(at);
        return lerp(turns[i], turns[i + 1], at - static_cast<double>(i));
      };
      const Stroke before = jittery(way, {0.0, 0.0}, seed);
      EXPECT_GT(std::ranges::count(before.data().joints, JointKind::kCorner), 8);
      const ArcMap map(before, 1e-5);
      Ironing iron(before, map, {});
      EXPECT_GT(iron.roughness_mm(0.5 * map.length_mm(), 10.0), 0.1 * height);
      const Stroke after = ironed(before, 5.0);
      const testing::Way straight = [](double t) { return Point{100 * t, 0}; };
      EXPECT_LT(rms_from(after, straight, 0.1, 0.9), 0.6 * rms_from(before, straight, 0.1, 0.9));
    }
  }
}

/// Returns the largest turn of a stroke, measured between arms of 2 mm, in degrees.
double sharpest_deg(const Stroke& stroke) {
  const ArcMap map(stroke, 1e-5);
  constexpr double kArm = 2.0;
  double sharpest = 0.0;
  for (double s = kArm; s <= map.length_mm() - kArm; s += 0.25) {
    const Point p = stroke.position(map.u_at(s));
    sharpest = std::max(sharpest, angle_between(p - stroke.position(map.u_at(s - kArm)),
                                                stroke.position(map.u_at(s + kArm)) - p));
  }
  return sharpest * 180.0 / std::numbers::pi;
}

/// Returns a path of 120 mm along a wave from which a shaky hand deviates.
testing::Way shaky_way(double rms_mm, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, rms_mm);
  std::vector<Point> points;
  Vec off;
  for (int i = 0; i <= 250; ++i) {
    off = 0.6 * off + Vec{0.5 * normal(random), 0.8 * normal(random)};
    const double t = i / 250.0;
    points.push_back(Point{120 * t, 10 * std::sin(2.0 * std::numbers::pi * t)} + off);
  }
  return [points](double t) {
    const double at = std::min(t * 250.0, 249.999);
    const auto i = static_cast<std::size_t>(at);
    return lerp(points[i], points[i + 1], at - static_cast<double>(i));
  };
}

TEST(Ironing, ThreePassesLeaveNoSpikeOfAShakyLine) {
  for (const double rms : {0.2, 0.35, 0.5}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(std::to_string(rms) + " mm, seed " + std::to_string(seed));
      Stroke stroke = jittery(shaky_way(rms, seed), {0.0, 0.0}, seed);
      for (int pass = 0; pass < 3; ++pass) stroke = ironed(stroke, 3.0);
      EXPECT_LT(sharpest_deg(stroke), 50.0);
    }
  }
}

TEST(Ironing, ASingleCornerOfALineStays) {
  for (const double turn_deg : {38.0, 60.0, 90.0, 150.0}) {
    for (const double jitter : {0.0, 0.03}) {
      const double turn = turn_deg * std::numbers::pi / 180.0;
      const testing::Way corner = [turn](double t) {
        const double s = 60 * t - 30;
        return s < 0 ? Point{s, 0} : Point{s * std::cos(turn), s * std::sin(turn)};
      };
      Stroke stroke = jittery(corner, {jitter, 0.0}, 3);
      const auto corners = std::ranges::count(stroke.data().joints, JointKind::kCorner);
      if (turn_deg >= 90.0) {
        EXPECT_EQ(corners, 1);
      }
      for (int pass = 0; pass < 3; ++pass) stroke = ironed(stroke, 3.0);
      EXPECT_EQ(std::ranges::count(stroke.data().joints, JointKind::kCorner), corners) << turn_deg;
    }
  }
}

// Teeth that are drawn are higher than those of a shaky hand.
TEST(Ironing, DrawnTeethStay) {
  for (const double slope : {0.9, 1.5, 3.0}) {
    for (const double tooth_mm : {6.0, 9.0}) {
      const testing::Way teeth = [=](double t) {
        const double x = 90 * t, phase = std::fmod(x / tooth_mm, 1.0);
        return Point{x, slope * tooth_mm * std::min(phase, 1.0 - phase)};
      };
      const Stroke before = jittery(teeth, {0.0, 0.0}, 1);
      const auto corners = std::ranges::count(before.data().joints, JointKind::kCorner);
      ASSERT_GT(corners, 10);
      const Stroke after = ironed(before, 3.0);
      EXPECT_EQ(std::ranges::count(after.data().joints, JointKind::kCorner), corners)
          << slope << ' ' << tooth_mm;
    }
  }
}

TEST(Ironing, BeyondTheReachSegmentsStayBitForBit) {
  int kept = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke before = jittery(testing::wave(), {}, seed);
    const ArcMap map(before, 1e-5);
    RandomStroke random(seed);
    const double at = random.uniform(20.0, map.length_mm() - 20.0);
    Ironing iron(before, map, {});
    iron.add(at, 10.0, 2.0);
    const auto after = iron.finished();
    ASSERT_TRUE(after);
    for (int i = 0; i < before.segment_count(); ++i) {
      const bool outside = map.start_of(i + 1) < at - 10.4 || map.start_of(i) > at + 10.4;
      if (!outside) continue;
      ++kept;
      bool found = false;
      for (int j = 0; j < after->segment_count(); ++j) {
        found = found || after->segment(j) == before.segment(i);
      }
      EXPECT_TRUE(found) << i;
    }
  }
  EXPECT_GT(kept, 100);
}

TEST(Ironing, CornersStayUnlessTheyAreToBeSmoothed) {
  const auto zigzag = [](double t) {
    const double x = 60 * t, phase = std::fmod(3 * t, 1.0);
    return Point{x, phase < 0.5 ? 40 * phase : 40 - 40 * phase};
  };
  const Stroke before = jittery(zigzag, {0.03, 0.0}, 1);
  std::vector<Point> corners;
  for (int i = 1; i < before.segment_count(); ++i) {
    if (before.joint(i) == JointKind::kCorner) corners.push_back(before.position(i));
  }
  ASSERT_EQ(corners.size(), 5u);
  const Stroke kept = ironed(before, 3.0);
  for (const Point c : corners) {
    bool found = false;
    for (int i = 1; i < kept.segment_count(); ++i) {
      found = found || (kept.joint(i) == JointKind::kCorner && kept.position(i) == c);
    }
    EXPECT_TRUE(found);
  }
  const Stroke round = ironed(before, 3.0, {.smooth_corners = true});
  EXPECT_EQ(std::ranges::count(round.data().joints, JointKind::kCorner), 0);
  double nearest_to_first = 1e9;
  for (int i = 0; i <= 1000; ++i) {
    const Point p = round.position(0.001 * i * round.segment_count());
    nearest_to_first = std::min(nearest_to_first, distance(p, corners[0]));
  }
  EXPECT_GT(nearest_to_first, 0.2);
}

TEST(Ironing, NeitherOrderNorPortionsMatter) {
  const Stroke before = jittery(testing::wave(), {}, 3);
  const ArcMap map(before, 1e-5);
  Ironing a(before, map, {}), b(before, map, {});
  for (int i = 0; i <= 40; ++i) a.add(20.0 + i, 10.0, 0.25);
  for (int round = 0; round < 2; ++round) {
    for (int i = 40; i >= 0; --i) b.add(20.0 + i, 10.0, 0.125);
  }
  a.catch_up();
  b.catch_up();
  const Stroke one = a.shown().value(), two = b.shown().value();
  ASSERT_EQ(one.segment_count(), two.segment_count());
  for (std::size_t i = 0; i < one.data().points.size(); ++i) {
    EXPECT_LT(distance(one.data().points[i], two.data().points[i]), 1e-7);
  }
}

TEST(Ironing, WhatIsShownBitByBitIsWhatIsIronedAtOnce) {
  double largest = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const bool is_tremor = seed % 2 == 0;
    const Stroke before = jittery(testing::wave(), {0.2, is_tremor ? 4.0 : 0.0}, seed);
    const ArcMap map(before, 1e-5);
    RandomStroke random(seed);
    Ironing bits(before, map, {}), whole(before, map, {});
    double at = random.uniform(0.0, map.length_mm());
    for (int i = 0; i < 400; ++i) {
      at = std::clamp(at + random.uniform(-4.0, 4.0), 0.0, map.length_mm());
      bits.add(at, 10.0, 0.05);
      whole.add(at, 10.0, 0.05);
      if (random.chance(0.3)) bits.catch_up();
      if (random.chance(0.2)) static_cast<void>(bits.shown());
    }
    bits.catch_up();
    whole.catch_up();
    const Stroke shown = bits.shown().value(), exact = whole.shown().value();
    std::vector<Point> line;
    for (int i = 0; i <= 20000; ++i) {
      line.push_back(exact.position(i / 20000.0 * exact.segment_count()));
    }
    for (int i = 0; i <= 2000; ++i) {
      const Point p = shown.position(i / 2000.0 * shown.segment_count());
      largest = std::max(largest, std::sqrt(nearest_on_polyline(line, p).distance_squared));
    }
    // The result does not depend on the previews.
    EXPECT_EQ(bits.finished().value(), whole.finished().value());
  }
  EXPECT_LT(largest, 0.03);
}

TEST(Ironing, WidthsStayWhereTheyWereOnTheLine) {
  const Stroke before = jittery(testing::wave(), {0.2, 6.0}, 4);
  const Stroke after = ironed(before, 3.0);
  const ArcMap old_map(before, 1e-5), new_map(after, 1e-5);
  const double stretch = new_map.length_mm() / old_map.length_mm();
  for (int i = 0; i <= 100; ++i) {
    const double s = 0.01 * i * old_map.length_mm();
    EXPECT_NEAR(after.width_mm(new_map.u_at(s * stretch)), before.width_mm(old_map.u_at(s)), 0.12);
  }
}

TEST(Ironing, AClosedLineIsIronedAllAroundAndAcrossItsSeam) {
  std::mt19937_64 random(7);
  StrokeData d;
  const int n = 60;
  for (int i = 0; i <= n; ++i) {
    const double a = 2.0 * std::numbers::pi * (i % n) / n;
    const double r = 20.0 + ((i % n) % 2 == 0 ? 0.2 : -0.2);
    const Point p = Point{50, 50} + r * Vec{std::cos(a), std::sin(a)};
    const Vec along = (2.0 * std::numbers::pi * 20 / n / 3) * Vec{-std::sin(a), std::cos(a)};
    if (i > 0) d.points.push_back(p - along);
    d.points.push_back(p);
    if (i < n) d.points.push_back(p + along);
  }
  d.points.back() = d.points.front();
  d.joints.assign(n, JointKind::kSmooth);
  d.closed = true;
  d.widths = {{0.0, 1.0}, {60.0, 1.0}};
  const Stroke before = Stroke::create(d).value();
  const ArcMap map(before, 1e-5);
  for (const bool all : {true, false}) {
    SCOPED_TRACE(all);
    Ironing iron(before, map, {.tolerance_mm = 0.02});
    for (double s = all ? 0.0 : -20.0; s < (all ? map.length_mm() : 20.0); s += 1.0) {
      iron.add(s < 0.0 ? s + map.length_mm() : s, 10.0, 0.4);
    }
    const auto after = iron.finished();
    ASSERT_TRUE(after);
    EXPECT_TRUE(after->closed());
    EXPECT_LT(after->segment_count(), before.segment_count());
    const ArcMap new_map(*after, 1e-5);
    for (double s = -10.0; s <= 10.0; s += 0.1) {
      EXPECT_NEAR(distance(after->position(new_map.u_at(s)), {50, 50}), 20.0, 0.04) << s;
    }
  }
}

TEST(Ironing, AnyStrokeComesOutValidAndWhatIsShownIsWhatIsDone) {
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Stroke before = testing::random_stroke(seed);
    const ArcMap map(before, 1e-5);
    RandomStroke random(seed + 500);
    IronOptions options{.wave_mm = random.uniform(2.0, 40.0),
                        .smooth_corners = random.chance(0.5),
                        .tolerance_mm = random.uniform(0.01, 0.5)};
    Ironing iron(before, map, options);
    for (int i = random.pick(1, 5); i > 0; --i) {
      iron.add(random.uniform(0.0, map.length_mm()), options.wave_mm, random.uniform(0.0, 3.0));
    }
    EXPECT_GE(iron.roughness_mm(random.uniform(0.0, map.length_mm()), 5.0), 0.0);
    iron.catch_up();
    const auto quick = iron.shown(), done = iron.finished();
    EXPECT_EQ(quick.has_value(), done.has_value());
    if (!quick || !done) continue;
    ++changed;
    EXPECT_TRUE(check_invariants(done->data()));
    EXPECT_LE(done->segment_count(), quick->segment_count());
    std::vector<Point> line;
    for (int i = 0; i <= 4000; ++i) {
      line.push_back(quick->position(i / 4000.0 * quick->segment_count()));
    }
    for (int i = 0; i <= 200; ++i) {
      const Point p = done->position(i / 200.0 * done->segment_count());
      EXPECT_LE(std::sqrt(nearest_on_polyline(line, p).distance_squared),
                options.tolerance_mm + 0.01);
    }
  }
  EXPECT_GT(changed, 150);
}

TEST(Ironing, RoughnessIsZeroOnSmoothInkAndFallsUnderTheIron) {
  for (const double radius : {3.0, 10.0, 40.0}) {
    const Stroke smooth = arcs({100, 100}, radius);
    const ArcMap map(smooth, 1e-5);
    Ironing iron(smooth, map, {});
    EXPECT_EQ(iron.roughness_mm(0.5 * map.length_mm(), 5.0), 0.0) << radius;
  }
  const Stroke rough = jittery(testing::wave(), {0.2, 4.0}, 1);
  const ArcMap map(rough, 1e-5);
  Ironing iron(rough, map, {});
  double last = iron.roughness_mm(40.0, 5.0);
  EXPECT_GT(last, 0.08);
  for (int i = 0; i < 30; ++i) {
    iron.add(40.0, 10.0, 0.2);
    const double now = iron.roughness_mm(40.0, 5.0);
    EXPECT_LE(now, last + 1e-9);
    last = now;
  }
  EXPECT_LT(last, 0.02);
}

}  // namespace
}  // namespace felt::ironing_test
