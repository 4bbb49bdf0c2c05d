#include "felt/document/selection.h"

#include <gtest/gtest.h>

namespace felt {
namespace {

TEST(Selection, StartsEmpty) {
  EXPECT_TRUE(Selection().empty());
}

}  // namespace
}  // namespace felt
