#include "felt/rt/latest_value.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <memory>
#include <thread>
#include <vector>

namespace felt::latest_value_test {
namespace {

// A value as large as a force model. Every word identifies the value.
struct Value {
  std::array<std::uint64_t, 256> words{};
};

RC_GTEST_PROP(LatestValue, IsTheNewestPublishedAtTheLastUpdate,
              (const std::vector<bool>& publishes)) {
  LatestValue<int> latest(-1);
  int newest = -1;
  int seen = -1;
  for (const bool publish : publishes) {
    if (publish) {
      latest.publish(++newest);
    } else {
      RC_ASSERT(latest.update() == (newest != seen));
      seen = newest;
    }
    RC_ASSERT(latest.get() == seen);  // publishing alone does not change what the reader gets
  }
}

TEST(LatestValue, BeforeAnythingIsPublishedItIsTheInitialValue) {
  LatestValue<int> with(7);
  EXPECT_FALSE(with.update());
  EXPECT_EQ(with.get(), 7);
  EXPECT_EQ(LatestValue<int>().get(), 0);
}

TEST(LatestValue, TwoThreadsNeverTornNeverOlderThanSeenAndTheLastArrives) {
  constexpr std::uint64_t kValues = 400'000;
  const auto latest = std::make_unique<LatestValue<Value>>();
  std::atomic<bool> done{false};
  std::thread publisher([&] {
    Value value;
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      value.words.fill(i);
      latest->publish(value);
    }
    done.store(true, std::memory_order_release);
  });
  std::uint64_t seen = 0;
  std::uint64_t torn = 0;
  std::uint64_t older = 0;
  for (bool last_round = false; !last_round;) {
    last_round = done.load(std::memory_order_acquire);
    const bool is_new = latest->update();
    const auto& words = latest->get().words;
    for (const std::uint64_t word : words) torn += word == words[0] ? 0 : 1;
    older += words[0] < seen || (is_new && words[0] == seen) ? 1 : 0;
    seen = words[0];
  }
  publisher.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(older, 0U);
  EXPECT_EQ(seen, kValues);
}

}  // namespace
}  // namespace felt::latest_value_test
