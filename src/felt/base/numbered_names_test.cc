#include "felt/base/numbered_names.h"

#include <gtest/gtest.h>

namespace felt::numbered_names_test {
namespace {

TEST(NumberedNames, TheNumberTakesThePlaceOfThePercentSign) {
  EXPECT_EQ(NumberedNames::parse("a%b/walk-%03d.svg").value().name(7), "a%b/walk-007.svg");
  EXPECT_EQ(NumberedNames::parse("w%d").value().name(12), "w12");
  EXPECT_EQ(NumberedNames::parse("100%-%2d.png").value().name(123), "100%-123.png");
  EXPECT_FALSE(NumberedNames::parse("a%d/walk.svg"));
  EXPECT_FALSE(NumberedNames::parse("50%.svg"));
}

TEST(NumberedNames, TheNumberComesBeforeTheSuffix) {
  EXPECT_EQ(NumberedNames::before_suffix("a.b/walk%d.svg").name(7), "a.b/walk%d-007.svg");
  EXPECT_EQ(NumberedNames::before_suffix("a.b/walk").name(1234), "a.b/walk-1234");
}

}  // namespace
}  // namespace felt::numbered_names_test
