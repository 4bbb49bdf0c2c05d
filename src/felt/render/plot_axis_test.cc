#include "felt/render/plot_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace felt::plot_axis_test {
namespace {

TEST(PlotTicks, AreRoundNumbersInTheRange) {
  const PlotTicks ticks = plot_ticks(-0.3, 2.7, 5);
  EXPECT_EQ(ticks.step, 1.0);
  EXPECT_EQ(ticks.values, (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_EQ(plot_ticks(0.0, 0.5, 5).label(0.3), "0.3");
  EXPECT_EQ(plot_ticks(0.0, 0.1, 5).label(0.02), "0.02");
  EXPECT_EQ(plot_ticks(0.0, 60.0, 6).label(40.0), "40");
  EXPECT_EQ(plot_ticks(-1.0, 1.0, 4).label(-0.0), "0.0");
}

TEST(PlotTicks, AnyRangeHasAboutAsManyAsAsked) {
  for (double width = 1e-6; width < 1e6; width *= 1.37) {
    for (const double low : {0.0, -0.4 * width, 3.1 * width, -2.0 * width}) {
      for (const int count : {2, 4, 10}) {
        const PlotTicks ticks = plot_ticks(low, low + width, count);
        ASSERT_GE(ticks.values.size(), 2u) << low << " + " << width;
        EXPECT_LE(static_cast<int>(ticks.values.size()), 4 * count + 1);
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
          EXPECT_GE(ticks.values[i], low - 1e-6 * width);
          EXPECT_LE(ticks.values[i], low + width * (1.0 + 1e-6));
          // The text equals the value.
          EXPECT_NEAR(std::stod(ticks.label(ticks.values[i])), ticks.values[i],
                      1e-9 + 1e-6 * width);
        }
      }
    }
  }
}

TEST(PlotTicks, NoneWhereThereIsNoRange) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(plot_ticks(1.0, 1.0, 5).values.empty());
  EXPECT_TRUE(plot_ticks(2.0, 1.0, 5).values.empty());
  EXPECT_TRUE(plot_ticks(0.0, inf, 5).values.empty());
  EXPECT_TRUE(plot_ticks(std::nan(""), 1.0, 5).values.empty());
}

}  // namespace
}  // namespace felt::plot_axis_test
