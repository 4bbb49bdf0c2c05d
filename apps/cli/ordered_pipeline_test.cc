#include "apps/cli/ordered_pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <vector>

namespace felt::cli::ordered_pipeline_test {
namespace {

struct Item {
  int number = 0;
  std::size_t size = 1;
  [[nodiscard]] std::size_t bytes() const { return size; }
};
struct Output {
  int number = 0;
};

/// Squares the numbers below `count`; every fifth one is slow.
std::vector<int> squares(int jobs, int count, int stop_at) {
  std::vector<int> taken;
  int given = 0;
  OrderedPipeline<Item, Output> pipeline(jobs);
  pipeline.run(
      [] {
        return [](const Item& item, Output& output) {
          if (item.number % 5 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
          output.number = item.number * item.number;
        };
      },
      [&](Item& item) {
        item.number = given;
        return given++ < count;
      },
      [&](const Output& output) {
        taken.push_back(output.number);
        return static_cast<int>(taken.size()) < stop_at;
      });
  return taken;
}

TEST(OrderedPipeline, KeepsTheOrderWhateverTheThreads) {
  for (const int jobs : {1, 2, 3, 16}) {
    for (const int count : {0, 1, 7, 500}) {
      const std::vector<int> taken = squares(jobs, count, 1 << 30);
      ASSERT_EQ(taken.size(), static_cast<std::size_t>(count));
      for (int i = 0; i < count; ++i) EXPECT_EQ(taken[static_cast<std::size_t>(i)], i * i);
    }
  }
}

TEST(OrderedPipeline, EndsEarlyWhenTold) {
  EXPECT_EQ(squares(1, 1000, 3).size(), 3U);
  EXPECT_EQ(squares(4, 1000, 3).size(), 3U);
}

TEST(OrderedPipeline, ComesHomeWhenItsCallerThrows) {
  OrderedPipeline<Item, Output> pipeline(3);
  int given = 0;
  const auto run = [&] {
    pipeline.run([] { return [](const Item&, Output&) {}; },
                 [&](Item&) -> bool {
                   if (++given == 10) throw std::runtime_error("source");
                   return true;
                 },
                 [](const Output&) { return true; });
  };
  EXPECT_THROW(run(), std::runtime_error);
}

TEST(OrderedPipeline, HoldsFewLargeItemsAtATime) {
  std::atomic<int> held = 0, largest = 0;
  int given = 0;
  OrderedPipeline<Item, Output> pipeline(8);
  pipeline.run([] { return [](const Item&, Output&) {}; },
               [&](Item& item) {
                 item.size = std::size_t{60} << 20;
                 if (given++ == 50) return false;
                 largest = std::max<int>(largest, ++held);
                 return true;
               },
               [&](const Output&) {
                 --held;
                 return true;
               });
  EXPECT_LE(largest, 2);
}

}  // namespace
}  // namespace felt::cli::ordered_pipeline_test
