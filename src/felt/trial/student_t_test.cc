#include "felt/trial/student_t.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "felt/base/random.h"

namespace felt::student_t_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Values of pt of R 4.2.
TEST(StudentT, KnownShares) {
  EXPECT_NEAR(student_t_share(-1.5, 7), 0.088649243494985, 1e-14);
  EXPECT_NEAR(student_t_share(2.0, 8), 0.959741881021369, 1e-14);
  EXPECT_NEAR(student_t_share(0.3, 1), 0.592773579077742, 1e-14);
  EXPECT_NEAR(student_t_share(3.3, 39), 0.998963807200314, 1e-14);
  EXPECT_NEAR(student_t_share(-4.0, 6), 0.003559488981874, 1e-14);
  EXPECT_EQ(student_t_share(0.0, 5), 0.5);
  EXPECT_EQ(student_t_share(kInfinity, 5), 1.0);
  EXPECT_EQ(student_t_share(-kInfinity, 5), 0.0);
}

/// Values of qt of R 4.2.
TEST(StudentT, KnownQuantiles) {
  struct Known {
    double share;
    std::size_t freedom;
    double t;
  };
  for (const Known& known : {Known{0.975, 1, 12.706204736175},
                             {0.975, 2, 4.302652729749},
                             {0.975, 7, 2.364624251593},
                             {0.95, 11, 1.795884818704},
                             {0.8, 15, 0.866244973195},
                             {0.975, 39, 2.022690920037},
                             {0.999, 200, 3.131479814221},
                             {0.025, 7, -2.364624251593}}) {
    EXPECT_NEAR(student_t_quantile(known.share, known.freedom), known.t, 1e-10) << known.freedom;
  }
  EXPECT_NEAR(student_t_quantile(0.5, 3), 0.0, 1e-12);
}

RC_GTEST_PROP(StudentT, TheQuantileIsTheInverseOfTheShare, (std::uint32_t seed)) {
  Random random(seed);
  const auto freedom = static_cast<std::size_t>(1 + random.bits() % 300);
  const double share = random.between(0.001, 0.999);
  const double t = student_t_quantile(share, freedom);
  RC_ASSERT(std::abs(student_t_share(t, freedom) - share) < 1e-12);
  RC_ASSERT(std::abs(student_t_share(-t, freedom) - (1.0 - share)) < 1e-12);
}

TEST(StudentInterval, KnownValues) {
  // The mean is 3 and its standard error 0.4418; Student's t is 2.7764.
  const std::vector<double> values = {1.75, 2.38, 3.0, 3.62, 4.25};
  const auto interval = student_interval(values, 0.95);
  ASSERT_TRUE(interval);
  EXPECT_DOUBLE_EQ(interval->mean, 3.0);
  EXPECT_NEAR(interval->high - 3.0, 2.776445105198 * mean_and_error(values).standard_error, 1e-9);
  EXPECT_NEAR(interval->high + interval->low, 6.0, 1e-12);
}

TEST(StudentInterval, TooFewOrInvalidValuesGiveNone) {
  std::vector<double> values(kMinIntervalValues, 2.0);
  EXPECT_FALSE(student_interval(std::span(values).first(kMinIntervalValues - 1), 0.95));
  EXPECT_FALSE(student_interval(values, 1.0));
  const auto equal = student_interval(values, 0.95);
  ASSERT_TRUE(equal);
  EXPECT_EQ(equal->low, equal->high);
  values[1] = kInfinity;
  EXPECT_FALSE(student_interval(values, 0.95));
}

}  // namespace
}  // namespace felt::student_t_test
