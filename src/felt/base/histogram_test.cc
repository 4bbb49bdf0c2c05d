#include "felt/base/histogram.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace felt::histogram_test {
namespace {

TEST(Histogram, EmptyHasZeros) {
  const Histogram histogram;
  EXPECT_EQ(histogram.max(), 0U);
  EXPECT_EQ(histogram.quantile(0.999), 0U);
}

TEST(Histogram, SmallOnesAreExact) {
  Histogram histogram;
  for (int i = 0; i < 100; ++i) histogram.add(i);
  histogram.add(-5);  // counts as 0: happens if the clock's own cost was overestimated
  EXPECT_EQ(histogram.quantile(0.5), 49U);
  EXPECT_EQ(histogram.max(), 99U);
}

RC_GTEST_PROP(HistogramProperty, QuantileIsWithinABucketOfTheTrueOne, ()) {
  auto values = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::int64_t>>(
      rc::gen::map(rc::gen::inRange(0, 6200),
                   [](int bits) { return static_cast<std::int64_t>(std::exp2(bits / 100.0)); })));
  const double fraction = *rc::gen::element(0.0, 0.1, 0.5, 0.99, 0.999, 1.0);
  Histogram whole, first, second;
  for (std::size_t i = 0; i < values.size(); ++i) {
    whole.add(values[i]);
    (i % 2 == 0 ? first : second).add(values[i]);
  }
  first.add(second);
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(fraction * static_cast<double>(values.size()));
  const auto truth = static_cast<double>(values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1]);
  const auto found = static_cast<double>(whole.quantile(fraction));
  RC_ASSERT(found >= truth);
  RC_ASSERT(found <= truth * (1.0 + 1.0 / 64.0));
  RC_ASSERT(first.quantile(fraction) == whole.quantile(fraction));
  RC_ASSERT(first.max() == whole.max());
}

}  // namespace
}  // namespace felt::histogram_test
