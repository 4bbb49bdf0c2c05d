#include "felt/document/key_timing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/base/constants.h"
#include "felt/document/history.h"
#include "felt/document/testing/random_guides.h"

namespace felt::key_timing_test {
namespace {

using ::testing::HasSubstr;

std::string error_of(const KeyTiming& timing) {
  const Result<void> fine = check_key_timing(timing);
  return fine ? "" : fine.error().message;
}

TEST(KeyTiming, EveryNumberHasItsLimits) {
  testing::RandomStroke random(1);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(error_of(testing::random_timing(random)), "");
  EXPECT_EQ(error_of({}), "");
  EXPECT_THAT(error_of({.between = -1}), HasSubstr("between: "));
  EXPECT_THAT(error_of({.between = 1001}), HasSubstr("between: "));
  EXPECT_THAT(error_of({.hold = 0}), HasSubstr("hold: "));
  EXPECT_THAT(error_of({.hold = 1001}), HasSubstr("hold: "));
  for (const double wrong : {-0.1, 1.1, kNan}) {
    EXPECT_THAT(error_of({.ease = {wrong, 0, 1, 1}}), HasSubstr("ease: "));
    EXPECT_THAT(error_of({.ease = {0, 0, 1, wrong}}), HasSubstr("ease: "));
  }
}

TEST(KeyTiming, AStrokeIsInOnePairOnly) {
  EXPECT_EQ(error_of({.pairs = {{{1}, {2}}, {{2}, {1}}, {{3}, {}}, {{4}, {}}, {{}, {5}}}}), "");
  EXPECT_THAT(error_of({.pairs = {{{}, {}}}}), HasSubstr("no stroke"));
  EXPECT_THAT(error_of({.pairs = {{{1}, {2}}, {{1}, {}}}}), HasSubstr("two pairs"));
  EXPECT_THAT(error_of({.pairs = {{{1}, {2}}, {{}, {2}}}}), HasSubstr("two pairs"));
  EXPECT_THAT(error_of({.pairs = std::vector<KeyPair>(10'001, {{1}, {}})}), HasSubstr("10000"));
}

TEST(KeyTiming, ALayerKeepsItAndUndoRestoresIt) {
  Document document;
  const LayerState before = document.layers()[0].state();
  LayerState after = before;
  after.timing = shared_timing({.between = 3, .pairs = {{{1}, {2}}}});
  Edit edit{"Motion timing", {}};
  edit.layers.push_back({{1}, before, after, 0, 0});
  ASSERT_TRUE(document.apply(edit));
  EXPECT_EQ(*document.layers()[0].timing, (KeyTiming{.between = 3, .pairs = {{{1}, {2}}}}));
  EXPECT_FALSE(document == Document());
  EXPECT_FALSE(document.apply(edit)) << "the layer has another timing by now";
  ASSERT_TRUE(document.apply(edit.inverse()));
  EXPECT_TRUE(document == Document());
  EXPECT_EQ(shared_timing({}), nullptr);
  EXPECT_EQ(timing_or_default(nullptr), KeyTiming());
}

}  // namespace
}  // namespace felt::key_timing_test
