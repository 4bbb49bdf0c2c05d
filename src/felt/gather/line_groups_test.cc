#include "felt/gather/line_groups.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "felt/gather/testing/rough_lines.h"

namespace felt::line_groups_test {
namespace {

using Groups = std::vector<std::uint32_t>;

// Strips of `count` lines each, `apart` mm from each other.
std::vector<RoughLine> strips(int strips, int count, double apart_mm, double jitter_mm) {
  std::vector<RoughLine> lines;
  for (int s = 0; s < strips; ++s) {
    const Cubic middle = straight({0.0, s * apart_mm}, {100.0, s * apart_mm});
    const std::vector<RoughLine> bundle =
        jittered_copies(middle, count, jitter_mm, 7U + static_cast<std::uint64_t>(s));
    lines.insert(lines.end(), bundle.begin(), bundle.end());
  }
  return lines;
}

TEST(LineGroups, NothingHasNoGroups) {
  EXPECT_EQ(line_groups({}).value(), Groups{});
}

TEST(LineGroups, OneLineAndDotsAreGroupsOfTheirOwn) {
  const std::vector<RoughLine> lines{{{0, 0}, {10, 0}}, {}, {{5, 5}}, {{5, 5}, {5, 5}}};
  EXPECT_EQ(line_groups(lines).value(), (Groups{0, 1, 2, 3}));
}

TEST(LineGroups, CopiesAreOneGroupAndDistantStripsAreNot) {
  EXPECT_EQ(line_groups(strips(3, 4, 30.0, 0.3)).value(),
            (Groups{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2}));
}

TEST(LineGroups, ADoubleOutlineStaysTwoLines) {
  EXPECT_EQ(line_groups(strips(2, 5, 6.0, 0.2)).value(), (Groups{0, 0, 0, 0, 0, 1, 1, 1, 1, 1}));
}

TEST(LineGroups, LinesThatCrossAtARightAngleStayApart) {
  std::vector<RoughLine> lines = jittered_copies(straight({0, 50}, {100, 50}), 3, 0.3, 1);
  const std::vector<RoughLine> others = jittered_copies(straight({50, 0}, {50, 100}), 3, 0.3, 2);
  lines.insert(lines.end(), others.begin(), others.end());
  EXPECT_EQ(line_groups(lines).value(), (Groups{0, 0, 0, 1, 1, 1}));
}

TEST(LineGroups, ADenseHatchingEndsSoon) {
  std::vector<RoughLine> lines;
  for (int i = 0; i < 1000; ++i) {
    lines.push_back({{i * 1e-3, 0.0}, {i * 1e-3, 10.0 + i % 7}});
  }
  const Groups groups = line_groups(lines).value();
  EXPECT_EQ(groups.size(), lines.size());
}

TEST(LineGroups, RefusesBadCoordinatesWithTheStroke) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e10, -HUGE_VAL}) {
    const std::vector<RoughLine> lines{{{0, 0}, {1, 1}}, {{0, 0}, {bad, 1}}};
    const auto groups = line_groups(lines);
    ASSERT_FALSE(groups);
    EXPECT_EQ(groups.error().code, ErrorCode::kInvalidArgument);
    EXPECT_NE(groups.error().message.find("stroke 1 "), std::string::npos);
  }
}

TEST(LineGroups, LargeCoordinatesAreFine) {
  std::vector<RoughLine> lines = strips(2, 3, 30.0, 0.3);
  for (RoughLine& line : lines) {
    for (Point& p : line) p = {p.x * 1e6 - 5e7, p.y * 1e6 + 9e8 - 1e8};
  }
  EXPECT_EQ(line_groups(lines).value(), (Groups{0, 0, 0, 1, 1, 1}));
}

TEST(LineGroups, CopiesCostNothing) {
  std::vector<RoughLine> lines(50'000, RoughLine{{0, 0}, {50, 7}, {100, 0}});
  lines.push_back({{0, 50}, {100, 50}});
  Groups expected(lines.size(), 0);
  expected.back() = 1;
  EXPECT_EQ(line_groups(lines).value(), expected);
}

TEST(LineGroups, RefusesACrowdThatWouldTakeTooLongWithItsPlace) {
  const std::vector<RoughLine> lines =
      jittered_copies(straight({500, 300}, {500.5, 300}), 20'000, 0.4, 5);
  const auto groups = line_groups(lines);
  ASSERT_FALSE(groups);
  EXPECT_EQ(groups.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(groups.error().message.find("near 500,300 mm"), std::string::npos)
      << groups.error().message;
}

// Returns true if both partitions are equal apart from the numbers of the groups.
bool same_partition(const Groups& a, const Groups& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if ((a[i] == a[k]) != (b[i] == b[k])) return false;
    }
  }
  return true;
}

RC_GTEST_PROP(LineGroups, OrderAndDirectionDoNotMatter, (std::uint32_t seed)) {
  std::vector<RoughLine> lines = strips(3, 4, 25.0, 0.4);
  const Groups before = line_groups(lines).value();
  RC_ASSERT(line_groups(lines).value() == before);
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), 0U);
  TestRandom random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::vector<RoughLine> shuffled;
  Groups expected;
  for (const std::size_t i : order) {
    shuffled.push_back(lines[i]);
    if (random.below(2) == 1) std::reverse(shuffled.back().begin(), shuffled.back().end());
    expected.push_back(before[i]);
  }
  RC_ASSERT(same_partition(line_groups(shuffled).value(), expected));
}

}  // namespace
}  // namespace felt::line_groups_test
