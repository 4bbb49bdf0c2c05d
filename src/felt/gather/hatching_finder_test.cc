#include "felt/gather/hatching_finder.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "felt/gather/line_groups.h"
#include "felt/gather/testing/rough_lines.h"

namespace felt::hatching_finder_test {
namespace {

/// Returns a line from a to b as a hand draws it: it waves by `wave_mm`.
RoughLine drawn_line(Point a, Point b, double wave_mm, TestRandom& random) {
  const double phase = 3.0 * random.signed_unit(), turns = 6.0 + 2.0 * random.signed_unit();
  RoughLine line;
  for (int k = 0; k <= 40; ++k) {
    const double t = k / 40.0;
    line.push_back(lerp(a, b, t) + wave_mm * std::sin(turns * t + phase) * perp(normalized(b - a)));
  }
  return line;
}

/// Returns parallel lines. Each gap differs by up to `irregular` of the spacing, and so do the
/// ends.
std::vector<RoughLine> hatching(int count, double spacing_mm, double length_mm, double irregular,
                                std::uint64_t seed) {
  TestRandom random(seed);
  std::vector<RoughLine> lines;
  const double off = 0.5 * irregular * spacing_mm;
  for (int i = 0; i < count; ++i) {
    const double x = i * spacing_mm;
    const Point low{x + off * random.signed_unit(), 4.0 * irregular * random.signed_unit()};
    const Point high{x + off * random.signed_unit(),
                     length_mm + 4.0 * irregular * random.signed_unit()};
    const bool is_upwards = i % 2 == 0;  // drawn to and fro
    lines.push_back(drawn_line(is_upwards ? low : high, is_upwards ? high : low,
                               0.3 * irregular * spacing_mm, random));
  }
  return lines;
}

std::size_t group_count(const std::vector<RoughLine>& lines, const GroupOptions& options = {}) {
  const std::vector<std::uint32_t> groups = line_groups(lines, options).value();
  return std::set<std::uint32_t>(groups.begin(), groups.end()).size();
}

void turn(std::vector<RoughLine>& lines, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  for (RoughLine& line : lines) {
    for (Point& p : line) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  }
}

TEST(HatchingFinder, AHatchingStaysAsItIs) {
  EXPECT_EQ(group_count(hatching(15, 2.0, 40.0, 0.0, 1)), 15U);
  GroupOptions chosen;
  chosen.keeps_hatchings = false;
  EXPECT_EQ(group_count(hatching(15, 2.0, 40.0, 0.0, 1), chosen), 1U);
}

RC_GTEST_PROP(HatchingFinder, AnyHatchingDrawnByHandStaysAsItIs, (std::uint32_t seed)) {
  const int count = *rc::gen::inRange(4, 40);
  const double spacing_mm = 0.1 * *rc::gen::inRange(5, 60);
  const double irregular = 0.01 * *rc::gen::inRange(0, 16);
  std::vector<RoughLine> lines = hatching(count, spacing_mm, 40.0, irregular, seed);
  turn(lines, 0.01 * *rc::gen::inRange(0, 628));
  RC_ASSERT(group_count(lines) == lines.size());
}

RC_GTEST_PROP(HatchingFinder, TwoOrThreeParallelsStayAsTheyAre, (std::uint32_t seed)) {
  const int count = *rc::gen::inRange(2, 4);
  const double spacing_mm = 0.1 * *rc::gen::inRange(18, 60);
  const double irregular = 0.01 * *rc::gen::inRange(0, 11);
  std::vector<RoughLine> lines = hatching(count, spacing_mm, 100.0, irregular, seed);
  turn(lines, 0.01 * *rc::gen::inRange(0, 628));
  RC_ASSERT(group_count(lines, {.ink_mm = 0.5}) == lines.size());
}

TEST(HatchingFinder, ParallelsWhoseInkNearlyTouchesAreOneLine) {
  for (const int count : {2, 3}) {
    EXPECT_EQ(group_count(hatching(count, 0.7, 100.0, 0.0, 1), {.ink_mm = 0.5}), 1U) << count;
  }
}

/// Returns lines that are bent like arcs of one circle or like copies of one wave.
std::vector<RoughLine> bent_hatching(int count, double spacing_mm, bool is_fan, double irregular,
                                     std::uint64_t seed) {
  TestRandom random(seed);
  std::vector<RoughLine> lines;
  for (int i = 0; i < count; ++i) {
    const double off = (i + 0.5 * irregular * random.signed_unit()) * spacing_mm;
    RoughLine line;
    for (int k = 0; k <= 60; ++k) {
      const double t = k / 60.0, radius_mm = 40.0 + off;
      line.push_back(is_fan ? Point{radius_mm * std::cos(1.5 * t), radius_mm * std::sin(1.5 * t)}
                            : Point{60.0 * t, off + 8.0 * std::sin(4.0 * t)});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

RC_GTEST_PROP(HatchingFinder, AnyBentHatchingStaysAsItIs, (std::uint32_t seed)) {
  const int count = *rc::gen::inRange(5, 30);
  const double spacing_mm = 0.1 * *rc::gen::inRange(8, 30);
  const double irregular = 0.01 * *rc::gen::inRange(0, 20);
  std::vector<RoughLine> lines =
      bent_hatching(count, spacing_mm, *rc::gen::arbitrary<bool>(), irregular, seed);
  turn(lines, 0.01 * *rc::gen::inRange(0, 628));
  RC_ASSERT(group_count(lines) == lines.size());
}

TEST(HatchingFinder, BentParallelsStayAsTheyAre) {
  for (const int count : {2, 3}) {
    for (const bool is_fan : {false, true}) {
      EXPECT_EQ(group_count(bent_hatching(count, 3.0, is_fan, 0.0, 1), {.ink_mm = 0.5}),
                static_cast<std::size_t>(count));
    }
  }
}

TEST(HatchingFinder, RingsStayUnlessTheyAreOneCircleDrawnAgain) {
  const auto rings = [](int count, double apart_mm) {
    std::vector<RoughLine> lines;
    for (int i = 0; i < count; ++i) {
      RoughLine line;
      for (int k = 0; k <= 120; ++k) {
        const double angle = 2.0 * 3.14159265358979 * (k % 120) / 120.0;
        const double radius_mm = 30.0 + apart_mm * i;
        line.push_back({radius_mm * std::cos(angle), radius_mm * std::sin(angle)});
      }
      lines.push_back(std::move(line));
    }
    return lines;
  };
  for (const int count : {2, 3, 5}) {
    EXPECT_EQ(group_count(rings(count, 4.0), {.ink_mm = 0.5}), static_cast<std::size_t>(count));
  }
  EXPECT_EQ(group_count(rings(2, 1.0), {.ink_mm = 0.5}), 1U);
}

TEST(HatchingFinder, StavesStayAsTheyAre) {
  for (const int staves : {1, 2, 6}) {
    TestRandom random(7);
    std::vector<RoughLine> lines;
    for (int i = 0; i < 5 * staves; ++i) {
      const double y = 30.0 * (i / 5) + 2.0 * (i % 5);
      lines.push_back(drawn_line({20, y}, {190, y}, 0.0, random));
    }
    EXPECT_EQ(group_count(lines), lines.size());
  }
}

TEST(HatchingFinder, CrossHatchingStaysAsItIs) {
  for (const int count : {4, 5, 10}) {
    for (const double degrees : {45.0, 60.0, 90.0}) {
      std::vector<RoughLine> lines = hatching(count, 2.0, 2.0 * count, 0.1, 3);
      std::vector<RoughLine> across = hatching(count, 2.0, 2.0 * count, 0.1, 4);
      turn(across, degrees * 3.14159265358979 / 180.0);
      lines.insert(lines.end(), across.begin(), across.end());
      EXPECT_EQ(group_count(lines), lines.size()) << count << " at " << degrees;
    }
  }
}

TEST(HatchingFinder, TwoHatchingsWithACommonLineStayAsTheyAre) {
  TestRandom random(1);
  std::vector<RoughLine> lines;
  for (const double x : {0.0, 2.0, 4.0, 6.0, 8.0, 12.5, 17.0, 21.5}) {
    lines.push_back(drawn_line({x, 0}, {x, 60}, 0.0, random));
  }
  EXPECT_EQ(group_count(lines), lines.size());
}

/// Someone who draws a line again does not leave equal gaps.
TEST(HatchingFinder, RoughBundlesStillBecomeOne) {
  int split = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const int count : {2, 3, 5, 8}) {
      const std::vector<RoughLine> bundle =
          jittered_copies(straight({0, 0}, {100, 20}), count, 0.5, seed);
      if (group_count(bundle) != 1) ++split;
    }
  }
  EXPECT_LE(split, 4) << "of 400";
}

TEST(HatchingFinder, LinesOfAHatchingThatAreDrawnTwiceStillBecomeOne) {
  std::vector<RoughLine> lines;
  for (int i = 0; i < 8; ++i) {
    for (RoughLine& line : jittered_copies(straight({4.0 * i, 0}, {4.0 * i, 60}), 3, 0.2,
                                           static_cast<std::uint64_t>(i))) {
      lines.push_back(std::move(line));
    }
  }
  EXPECT_EQ(group_count(lines), 8U);
}

}  // namespace
}  // namespace felt::hatching_finder_test
