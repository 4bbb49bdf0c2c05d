#include "felt/session/recorder.h"

#include <gtest/gtest.h>

namespace felt::recorder_test {
namespace {

TEST(Recorder, HandsOverInBatchesAndInOrder) {
  std::vector<Event> got;
  std::size_t largest = 0;
  Recorder recorder(
      [&](std::span<const Event> events) {
        largest = std::max(largest, events.size());
        got.insert(got.end(), events.begin(), events.end());
      },
      10);
  for (int i = 0; i < 25; ++i) recorder({i, PenEvent{{i * 0.1, 0, 0}, {}, 0}});
  EXPECT_EQ(got.size(), 20U);
  recorder.flush();
  recorder.flush();
  ASSERT_EQ(got.size(), 25U);
  EXPECT_EQ(largest, 10U);
  for (int i = 0; i < 25; ++i) {
    EXPECT_EQ(got[static_cast<std::size_t>(i)], (Event{i, PenEvent{{i * 0.1, 0, 0}, {}, 0}}));
  }
}

TEST(Recorder, TimesNeverRunBackwards) {
  std::vector<std::int64_t> times;
  Recorder recorder([&times](std::span<const Event> events) {
    for (const Event& event : events) times.push_back(event.time_ns);
  });
  for (const std::int64_t t : {-5, 3, 2, 3, 7, 1}) recorder({t, UndoEvent{}});
  recorder.flush();
  EXPECT_EQ(times, (std::vector<std::int64_t>{0, 3, 3, 3, 7, 7}));
}

}  // namespace
}  // namespace felt::recorder_test
