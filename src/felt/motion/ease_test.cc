#include "felt/motion/ease.h"

#include <gtest/gtest.h>

#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"

namespace felt::ease_test {
namespace {

void expect_monotone(const Ease& ease) {
  EXPECT_EQ(ease.at(0.0), 0.0);
  EXPECT_EQ(ease.at(1.0), 1.0);
  EXPECT_EQ(ease.at(-3.0), 0.0);
  EXPECT_EQ(ease.at(kNan), 0.0);
  EXPECT_EQ(ease.at(9.0), 1.0);
  double before = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double now = ease.at(i / 1000.0);
    EXPECT_GE(now, before);
    EXPECT_LE(now, 1.0);
    before = now;
  }
}

TEST(Ease, NeverGoesBack) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto share = [&] { return random.between(0.0, 1.0); };
    const double x1 = share(), y1 = share(), x2 = share(), y2 = share();
    const auto ease = Ease::cubic(x1, y1, x2, y2);
    ASSERT_TRUE(ease);
    expect_monotone(*ease);
    std::vector<Point> line{{share(), share()}};
    for (int i = 0; i < 20; ++i) line.push_back({share() * 50.0, share() * 50.0});
    const auto drawn = Ease::drawn(line);
    ASSERT_TRUE(drawn);
    expect_monotone(*drawn);
  }
}

TEST(Ease, HasTheValuesOfCss) {
  EXPECT_NEAR(Ease().at(0.3), 0.3, 1e-12);
  // cubic-bezier(0.42, 0, 0.58, 1) is symmetric; the others as browsers compute them.
  EXPECT_NEAR(Ease::parse("ease-in-out")->at(0.5), 0.5, 1e-4);
  EXPECT_NEAR(Ease::parse("ease-in-out")->at(0.25), 0.1291, 1e-3);
  EXPECT_NEAR(Ease::parse("ease")->at(0.5), 0.8024, 1e-3);
  EXPECT_NEAR(Ease::parse("0,0,1,1")->at(0.7), 0.7, 1e-4);
}

TEST(Ease, RefusesWhatIsNoEase) {
  for (const char* text : {"", "fast", "0,0,1", "0,0,1,1,1", "0,0,1,1.5", "-0.1,0,1,1", "0;0;1;1",
                           "0,0,1,nan", "0,,1,1"}) {
    EXPECT_FALSE(Ease::parse(text)) << text;
  }
  EXPECT_FALSE(Ease::drawn({}));
  EXPECT_FALSE(Ease::drawn(std::vector<Point>{{0, 0}, {0, 5}}));
  EXPECT_FALSE(Ease::drawn(std::vector<Point>{{0, 0}, {kNan, 2}, {5, 5}}));
}

TEST(Ease, FollowsADrawnLine) {
  // Half of the way in a fifth of the time, upwards on the page.
  const auto ease = Ease::drawn(std::vector<Point>{{10, 50}, {20, 30}, {60, 10}});
  ASSERT_TRUE(ease);
  EXPECT_NEAR(ease->at(0.2), 0.5, 1e-12);
  EXPECT_NEAR(ease->at(0.6), 0.75, 1e-12);
}

}  // namespace
}  // namespace felt::ease_test
