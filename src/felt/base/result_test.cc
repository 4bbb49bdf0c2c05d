#include "felt/base/result.h"

#include <gtest/gtest.h>

namespace felt::result_test {
namespace {

Result<int> half_of_even(int n) {
  if (n % 2 != 0) return fail(ErrorCode::kInvalidArgument, "odd number");
  return n / 2;
}

TEST(Result, CarriesTheValueOrTheReason) {
  EXPECT_EQ(half_of_even(4).value(), 2);
  const Result<int> odd = half_of_even(3);
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(with_context(odd.error(), "line 7").message, "line 7: odd number");
}

}  // namespace
}  // namespace felt::result_test
