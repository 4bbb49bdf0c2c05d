#include "felt/trial/paired_ratio.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/base/random.h"

namespace felt::paired_ratio_test {
namespace {

std::vector<double> logs_of(std::vector<double> ratios) {
  for (double& ratio : ratios) ratio = std::log(ratio);
  return ratios;
}

/// Values of scipy.stats.ttest_1samp 1.10.
TEST(PairedRatio, R75_KnownTests) {
  const auto tests = test_ratios(logs_of({0.8, 0.95, 0.7, 1.1, 0.85, 0.9}), 0.15);
  ASSERT_TRUE(tests);
  EXPECT_EQ(tests->people, 6U);
  EXPECT_NEAR(tests->ratio.mean, 0.8746365568615881, 1e-12);
  EXPECT_NEAR(tests->ratio.low, 0.74411087, 1e-8);
  EXPECT_NEAR(tests->ratio.high, 1.02805797, 1e-8);
  EXPECT_NEAR(tests->narrow_ratio.low, 0.77056014, 1e-8);
  EXPECT_NEAR(tests->narrow_ratio.high, 0.99277015, 1e-8);
  EXPECT_NEAR(tests->deviation, 0.15400506067201036, 1e-12);
  EXPECT_NEAR(tests->p_different, 0.08635396656529977, 1e-12);
  EXPECT_NEAR(tests->p_not_worse, 0.0036678113255913156, 1e-12);
  EXPECT_NEAR(tests->p_not_better, 0.46494987902500406, 1e-12);
  EXPECT_EQ(tests->p_same(), tests->p_not_better);
}

TEST(PairedRatio, WithoutAMarginThereIsNoTestAgainstIt) {
  const auto tests = test_ratios(logs_of({0.8, 0.95, 0.7, 1.1, 0.85}), 0.0);
  ASSERT_TRUE(tests);
  EXPECT_EQ(tests->p_not_worse, 1.0);
  EXPECT_EQ(tests->p_not_better, 1.0);
}

TEST(PairedRatio, TooFewOrInvalidValuesGiveNone) {
  const std::vector<double> logs(kMinIntervalValues, 0.1);
  EXPECT_FALSE(test_ratios(std::span(logs).first(kMinIntervalValues - 1), 0.1));
  EXPECT_FALSE(test_ratios(logs, -0.1));
  EXPECT_FALSE(test_ratios(logs, std::nan("")));
  std::vector<double> infinite = logs;
  infinite[0] = -HUGE_VAL;
  EXPECT_FALSE(test_ratios(infinite, 0.1));
}

TEST(PairedRatio, EqualRatiosAreCertain) {
  const auto same = test_ratios(std::vector<double>(6, 0.0), 0.1);
  EXPECT_EQ(same->p_different, 1.0);
  EXPECT_EQ(same->p_same(), 0.0);
  const auto less = test_ratios(std::vector<double>(6, std::log(0.7)), 0.1);
  EXPECT_EQ(less->p_different, 0.0);
  EXPECT_EQ(less->p_not_worse, 0.0);
  EXPECT_EQ(less->p_same(), 1.0);
}

RC_GTEST_PROP(PairedRatio, R75_TestsAgreeWithTheirIntervals, (std::uint32_t seed)) {
  Random random(seed);
  const double spread = random.between(0.01, 0.4), effect = random.between(-0.4, 0.4);
  std::vector<double> logs, reversed;
  const auto people = static_cast<int>(5 + random.bits() % 20);
  for (int i = 0; i < people; ++i) {
    logs.push_back(effect + spread * random.normal());
    reversed.push_back(-logs.back());
  }
  const double margin = random.between(0.02, 0.5);
  const RatioTests tests = *test_ratios(logs, margin), other = *test_ratios(reversed, margin);
  RC_ASSERT((tests.p_different < 0.05) == (tests.ratio.low > 1.0 || tests.ratio.high < 1.0));
  RC_ASSERT((tests.p_not_worse < 0.05) == (tests.narrow_ratio.high < 1.0 + margin));
  RC_ASSERT((tests.p_not_better < 0.05) == (tests.narrow_ratio.low > 1.0 / (1.0 + margin)));
  RC_ASSERT(std::abs(tests.ratio.mean * other.ratio.mean - 1.0) < 1e-12);
  RC_ASSERT(std::abs(tests.p_not_worse - other.p_not_better) < 1e-12);
}

TEST(Holm, R75_KnownProbabilities) {
  const std::vector<double> corrected =
      holm_corrected(std::vector<double>{0.01, 0.04, 0.03, 0.005});
  const std::vector<double> wanted = {0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(corrected[i], wanted[i], 1e-15) << i;
  const std::vector<double> others = holm_corrected(std::vector<double>{0.4, 0.6, 0.01});
  EXPECT_NEAR(others[0], 0.8, 1e-15);
  EXPECT_NEAR(others[1], 0.8, 1e-15);
  EXPECT_NEAR(others[2], 0.03, 1e-15);
  EXPECT_TRUE(holm_corrected({}).empty());
}

RC_GTEST_PROP(Holm, KeepsTheOrderAndIsAtMostBonferroni, (std::uint32_t seed)) {
  Random random(seed);
  std::vector<double> given;
  for (std::size_t i = 0; i < 1 + seed % 7; ++i) given.push_back(random.between(0.0, 0.5));
  const std::vector<double> corrected = holm_corrected(given);
  for (std::size_t i = 0; i < given.size(); ++i) {
    RC_ASSERT(corrected[i] >= given[i] && corrected[i] <= 1.0);
    RC_ASSERT(corrected[i] <= static_cast<double>(given.size()) * given[i] + 1e-12);
    for (std::size_t j = 0; j < given.size(); ++j) {
      RC_ASSERT(!(given[i] < given[j]) || corrected[i] <= corrected[j]);
    }
  }
}

}  // namespace
}  // namespace felt::paired_ratio_test
