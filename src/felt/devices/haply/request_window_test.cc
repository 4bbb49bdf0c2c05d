#include "felt/devices/haply/request_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "felt/base/constants.h"

namespace felt::haply::request_window_test {
namespace {

TEST(RequestWindow, OneMessageAtATimeAndOneToLetGo) {
  RequestWindow window;
  EXPECT_TRUE(window.is_clear());
  EXPECT_FALSE(window.may_release()) << "nothing to let go of";
  window.sent(true);
  EXPECT_FALSE(window.is_clear());
  EXPECT_TRUE(window.may_release());
  window.sent(false);
  EXPECT_FALSE(window.may_release());
  window.answered();
  EXPECT_FALSE(window.is_clear());
  EXPECT_FALSE(window.may_release()) << "the newest bears no force";
  window.answered();
  EXPECT_TRUE(window.is_clear());
}

TEST(RequestWindow, WhatIsNeverAnsweredIsAskedOnceMoreAndNoMore) {
  RequestWindow window;
  window.sent(false);
  int asked = 0;
  for (int i = 0; i < 10'000; ++i) {
    window.wait(kMs);
    if (!window.is_overdue()) continue;
    window.sent(false);
    ++asked;
  }
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(window.is_clear());
  window.answered();
  EXPECT_FALSE(window.is_clear()) << "the other answer may still come";
  for (int i = 0; i < 200; ++i) window.wait(kMs);
  EXPECT_TRUE(window.is_clear()) << "one state has answered both";
}

// Simulates a service that handles one message after the other, at different speeds.
TEST(RequestWindow, OneWaitsBeforeASlowServiceAndFourAtMostBeforeOneThatIsMiscounted) {
  for (const double answer_ms : {0.5, 1.2, 2.0, 2.1, 5.0, 19.0, 30.0, 100.0, 300.0}) {
    RequestWindow window;
    std::deque<double> done_ms;
    double free_ms = 0.0;
    std::size_t largest = 0;
    for (int t = 0; t < 20'000; ++t) {
      window.wait(kMs);
      for (; !done_ms.empty() && done_ms.front() <= t; done_ms.pop_front()) window.answered();
      if (window.is_clear() || window.is_overdue()) {
        window.sent(window.is_clear());
        free_ms = std::max(free_ms, static_cast<double>(t)) + answer_ms;
        done_ms.push_back(free_ms);
      }
      largest = std::max(largest, done_ms.size());
    }
    EXPECT_LE(largest, answer_ms < 20.0 ? 1u : 4u) << answer_ms << " ms";
  }
}

}  // namespace
}  // namespace felt::haply::request_window_test
