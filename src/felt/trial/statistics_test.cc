#include "felt/trial/statistics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "felt/base/random.h"

namespace felt::statistics_test {
namespace {

TEST(MeanInterval, KnownValues) {
  // The mean is 3; 0.5 is its standard error. With Student's t the interval would be 1.61 to 4.39.
  const std::vector<double> values = {1.75, 2.38, 3.0, 3.62, 4.25};
  const auto interval = mean_interval(values, 0.95);
  ASSERT_TRUE(interval);
  EXPECT_DOUBLE_EQ(interval->mean, 3.0);
  EXPECT_LT(interval->low, 2.0);
  EXPECT_GT(interval->high, 4.0);
  EXPECT_EQ(mean_interval(values, 0.95), interval);
  EXPECT_NE(mean_interval(values, 0.95, 2), interval);
  const auto narrow = mean_interval(values, 0.5);
  EXPECT_GT(narrow->low, interval->low);
  EXPECT_LT(narrow->high, interval->high);
}

TEST(MeanInterval, TooFewOrInvalidValuesGiveNone) {
  const std::vector<double> values(kMinIntervalValues, 2.0);
  EXPECT_FALSE(mean_interval(std::span(values).first(kMinIntervalValues - 1), 0.95));
  EXPECT_FALSE(mean_interval({}, 0.95));
  EXPECT_FALSE(mean_interval(values, 1.0));
  EXPECT_FALSE(mean_interval(values, std::nan("")));
  std::vector<double> infinite = values;
  infinite[2] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(mean_interval(infinite, 0.95));
}

TEST(MeanInterval, EqualValuesGiveAnEmptyInterval) {
  const std::vector<double> values(7, 0.1);
  const auto interval = mean_interval(values, 0.95);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, interval->high);
  EXPECT_FALSE(effect_size_dz(values));
}

RC_GTEST_PROP(MeanInterval, IsAroundTheMeanAndScales, (std::uint32_t seed)) {
  Random random(seed);
  std::vector<double> values, scaled;
  for (int i = 0; i < 12; ++i) {
    values.push_back(std::exp(random.normal()));
    scaled.push_back(10.0 - 4.0 * values.back());
  }
  const auto interval = *mean_interval(values, 0.95), mirrored = *mean_interval(scaled, 0.95);
  RC_ASSERT(interval.low < interval.mean && interval.mean < interval.high);
  RC_ASSERT(std::abs(mirrored.low - (10.0 - 4.0 * interval.high)) < 1e-9 * interval.high);
  RC_ASSERT(std::abs(mirrored.high - (10.0 - 4.0 * interval.low)) < 1e-9 * interval.high);
}

TEST(EffectSizeDz, IsTheMeanInStandardDeviations) {
  EXPECT_DOUBLE_EQ(*effect_size_dz(std::vector<double>{1.0, 3.0}), 2.0 / std::sqrt(2.0));
  EXPECT_FALSE(effect_size_dz(std::vector<double>{1.0}));
}

/// The differences of one study between two conditions, mm. Errors are lognormal: people, shapes
/// and trials have their own factors, and people react differently to the second condition.
std::vector<double> modelled_differences(Random& random, double effect) {
  std::vector<double> differences;
  for (int person = 0; person < 12; ++person) {
    const double skill = 0.3 * random.normal();
    double difference = 0.0;
    for (const double shape : {-0.2, 0.0, 0.2}) {
      const double first = 0.5 * std::exp(skill + shape + 0.25 * random.normal());
      const double second = 0.5 * std::exp(skill + shape + 0.25 * random.normal());
      difference += (effect * second - first) / 3.0;
    }
    differences.push_back(difference);
  }
  return differences;
}

// 400 studies: the standard deviation of a share of 95 % is 1.1 %, so these bounds are 3 of them.
TEST(MeanInterval, CoversAPlantedEffectOfTwentyPercent) {
  const double mean_error =
      0.5 * std::exp(0.5 * (0.09 + 0.0625)) * (std::exp(-0.2) + 1.0 + std::exp(0.2)) / 3.0;
  for (const double effect : {0.8, 1.0}) {
    Random random(17);
    int covered = 0;
    for (int study = 0; study < 400; ++study) {
      const auto interval = mean_interval(modelled_differences(random, effect), 0.95);
      const double truth = (effect - 1.0) * mean_error;
      if (interval->low <= truth && truth <= interval->high) ++covered;
    }
    EXPECT_GE(covered, 0.917 * 400) << effect;
    EXPECT_LE(covered, 0.983 * 400) << effect;
  }
}

}  // namespace
}  // namespace felt::statistics_test
