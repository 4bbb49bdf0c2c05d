#include "felt/stroke/fit/run_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "felt/stroke/stroke.h"
#include "felt/stroke/testing/fit_oracle.h"
#include "felt/stroke/testing/test_ink.h"

namespace felt::run_search_test {
namespace {

using testing::InkShape;
using testing::kAllShapes;
using testing::TestInk;
using testing::window_of;

RunSearch search_all(const SampleWindow& window, const RunStart& start, std::size_t first) {
  RunSearch search;
  search.begin(window, start, first);
  while (search.step(window, window.size(), true) != RunSearch::Status::kDone) {
  }
  return search;
}

class SearchIn : public ::testing::TestWithParam<InkShape> {};
INSTANTIATE_TEST_SUITE_P(AllInk, SearchIn, ::testing::ValuesIn(kAllShapes),
                         ::testing::PrintToStringParamName());

// The run found is a valid fit, and a slightly longer run fails.
TEST_P(SearchIn, FindsARunThatHardlyCouldBeLonger) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const SampleWindow window = window_of(random.draw(GetParam(), 400), random.tolerance());
    if (window.size() < 2) continue;
    const RunSearch search = search_all(window, {}, 0);
    const std::size_t count = search.count();
    ASSERT_GE(count, 2u);
    ASSERT_LE(count, std::min(window.size(), SegmentFit::kMaxRun));
    SegmentFit fit;
    ASSERT_TRUE(fit.fit(window, {}, 0, count));
    EXPECT_EQ(fit.curve(), search.curve());
    if (count == std::min(window.size(), SegmentFit::kMaxRun)) continue;
    bool fails = false;
    for (std::size_t more = 1; more <= std::max<std::size_t>(1, count / 16); ++more) {
      fails = fails || !fit.fit(window, {}, 0, count + more);
    }
    EXPECT_TRUE(fails);
  }
}

TEST_P(SearchIn, R7OfferingSamplesOneByOneFindsTheSame) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const SampleWindow window = window_of(random.draw(GetParam(), 400), random.tolerance());
    if (window.size() < 2) continue;
    const RunSearch whole = search_all(window, {}, 0);
    RunSearch search;
    search.begin(window, {}, 0);
    RunSearch::Status status = RunSearch::Status::kBusy;
    for (std::size_t limit = 2; status != RunSearch::Status::kDone;) {
      const std::size_t offered = std::min(limit, window.size());
      status = search.step(window, offered, offered == window.size());
      if (status == RunSearch::Status::kNeedSamples) {
        limit += static_cast<std::size_t>(random.pick(1, 3));
      }
    }
    EXPECT_EQ(search.count(), whole.count());
    EXPECT_EQ(search.curve(), whole.curve());
  }
}

TEST_P(SearchIn, EveryStartComesToAnEnd) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    TestInk random(seed);
    const SampleWindow window = window_of(random.draw(GetParam(), 100), random.tolerance());
    for (std::size_t first = 0; first < window.size(); first += 7) {
      const RunStart start{RunStart::Kind::kTangent, window.point(first) + random.noise(0.05),
                           random.direction()};
      RunSearch search = search_all(window, start, first);
      search.ensure_length(window);
      EXPECT_GE(search.count(), 1u);
      EXPECT_LE(first + search.count(), window.size());
      EXPECT_EQ(search.parameters().size(), search.count());
      EXPECT_EQ(search.parameters().back(), 1.0);
      EXPECT_EQ(search.curve().p[0], start.point);
      EXPECT_GE(control_length(search.curve()), kMinSegmentMm);
    }
  }
}

TEST(RunSearch, NeverLooksBeyondItsLimit) {
  std::vector<Point> ink = TestInk(1).draw(InkShape::kSmooth, 40);
  const RunSearch alone = search_all(window_of(ink, 0.15), {}, 0);
  for (int i = 0; i < 40; ++i) ink.push_back({1000.0 + i, -500.0});
  const SampleWindow window = window_of(ink, 0.15);
  RunSearch search;
  search.begin(window, {}, 0);
  while (search.step(window, 40, true) != RunSearch::Status::kDone) {
  }
  EXPECT_EQ(search.curve(), alone.curve());
  EXPECT_EQ(search.count(), alone.count());
}

TEST(RunSearch, PinsTheEndsToTheirSamples) {
  const std::vector<Point> ink = TestInk(5).draw(InkShape::kDense, 60);
  const SampleWindow window = window_of(ink, 0.15);
  RunSearch search = search_all(window, {}, 0);
  const std::size_t count = search.count();
  search.pin(window, true, true);
  EXPECT_EQ(search.count(), count);
  EXPECT_EQ(search.curve().p[0], window.point(0));
  EXPECT_EQ(search.curve().p[3], window.point(count - 1));
}

}  // namespace
}  // namespace felt::run_search_test
