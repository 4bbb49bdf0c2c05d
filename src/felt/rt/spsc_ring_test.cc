#include "felt/rt/spsc_ring.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <deque>
#include <memory>
#include <thread>
#include <vector>

namespace felt::spsc_ring_test {
namespace {

// Every word identifies its element, so that a torn one is detected.
struct Element {
  std::array<std::uint64_t, 10> words{};
};

Element element(std::uint64_t i) {
  Element made;
  for (std::size_t k = 0; k < made.words.size(); ++k) made.words[k] = i * 31 + k;
  return made;
}

bool is_element(const Element& e, std::uint64_t i) {
  return e.words == element(i).words;
}

RC_GTEST_PROP(SpscRing, IsAQueueThatDropsWhatDoesNotFit, (const std::vector<int>& steps)) {
  SpscRing<int, 8> ring;
  std::deque<int> model;
  std::uint64_t dropped = 0;
  int next = 0;
  for (const int step : steps) {
    if (step % 3 != 0) {
      const bool fits = model.size() < 8;
      if (fits) model.push_back(next);
      if (!fits) ++dropped;
      RC_ASSERT(ring.push(next++) == fits);
    } else {
      std::vector<int> out(static_cast<std::size_t>(step / 3 < 0 ? -(step / 3) : step / 3) % 5);
      const std::size_t count = ring.pop(out);
      RC_ASSERT(count == std::min(model.size(), out.size()));
      for (std::size_t i = 0; i < count; ++i) {
        RC_ASSERT(out[i] == model.front());
        model.pop_front();
      }
    }
    RC_ASSERT(ring.size() == model.size());
    RC_ASSERT(ring.dropped() == dropped);
  }
}

TEST(SpscRing, MayBeMadeForFewerElements) {
  for (const auto& [asked, expected] :
       std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}, {1, 2}, {7, 4}, {8, 8}, {64, 8}}) {
    SpscRing<int, 8> ring(asked);
    EXPECT_EQ(ring.capacity(), expected);
    for (int i = 0; i < 20; ++i) ring.push(i);
    EXPECT_EQ(ring.size(), expected);
    EXPECT_EQ(ring.dropped(), 20 - expected);
    int first = -1;
    EXPECT_TRUE(ring.pop(first));
    EXPECT_EQ(first, 0);
  }
}

TEST(SpscRing, TwoThreadsEverythingArrivesOnceInOrderAndWhole) {
  constexpr std::uint64_t kElements = 200'000;
  const auto ring = std::make_unique<SpscRing<Element, 64>>();
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kElements;) {
      if (ring->push(element(i))) ++i;  // if the ring is full, retries the same element
    }
  });
  std::array<Element, 7> out{};
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < kElements;) {
    const std::size_t count = ring->pop(out);
    for (std::size_t k = 0; k < count; ++k) wrong += is_element(out[k], i++) ? 0 : 1;
    if (count == 0) std::this_thread::yield();
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(ring->size(), 0U);
}

TEST(SpscRing, TwoThreadsAProducerThatNeverWaitsCountsEachLoss) {
  constexpr std::uint64_t kElements = 200'000;
  const auto ring = std::make_unique<SpscRing<Element, 16>>();
  std::atomic<bool> done{false};
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < kElements; ++i) ring->push(element(i));
    done.store(true, std::memory_order_release);
  });
  std::uint64_t arrived = 0;
  std::uint64_t next = 0;
  Element e;
  for (bool last_round = false; !last_round;) {
    last_round = done.load(std::memory_order_acquire);
    while (ring->pop(e)) {
      const std::uint64_t i = e.words[0] / 31;
      ASSERT_TRUE(is_element(e, i)) << "torn";
      ASSERT_GE(i, next) << "out of order";
      next = i + 1;
      ++arrived;
    }
  }
  producer.join();
  EXPECT_EQ(arrived + ring->dropped(), kElements);
}

TEST(SpscRing, IndicesMayWrapManyTimes) {
  SpscRing<std::uint32_t, 2> ring;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    ASSERT_TRUE(ring.push(i));
    std::uint32_t out = 0;
    ASSERT_TRUE(ring.pop(out));
    ASSERT_EQ(out, i);
  }
  EXPECT_EQ(ring.dropped(), 0U);
}

}  // namespace
}  // namespace felt::spsc_ring_test
