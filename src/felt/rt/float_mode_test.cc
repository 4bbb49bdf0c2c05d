#include "felt/rt/float_mode.h"

#include <gtest/gtest.h>

#include <limits>

namespace felt::float_mode_test {
namespace {

TEST(FlushDenormals, WithinItsBlockOnly) {
#if defined(__SSE2__) || defined(__aarch64__)
  volatile double smallest = std::numeric_limits<double>::min();
  EXPECT_NE(smallest / 4.0, 0.0);
  {
    const FlushDenormals flush;
    volatile double result = smallest / 4.0;
    {
      const FlushDenormals again;  // nests
      EXPECT_EQ(smallest / 4.0, 0.0);
    }
    EXPECT_EQ(smallest / 4.0, 0.0);
    EXPECT_EQ(result, 0.0);
  }
  EXPECT_NE(smallest / 4.0, 0.0);
#else
  GTEST_SKIP() << "denormals stay on on this processor";
#endif
}

}  // namespace
}  // namespace felt::float_mode_test
