#include "desktop/files/file_worker.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace felt::desktop::file_worker_test {
namespace {

TEST(FileWorker, AnswersComeInTheOrderOfTheWork) {
  FileWorker worker;
  std::vector<int> order;
  for (int i = 0; i < 20; ++i) {
    worker.start(
        [&order, i]() -> FileWorker::Answer { return [&order, i] { order.push_back(i); }; });
  }
  worker.wait();
  ASSERT_EQ(order.size(), 20u);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
  EXPECT_FALSE(worker.is_busy());
}

/// An action that was queued waits for work that finished after the action was queued and before
/// it ran. Qt's glib event dispatcher does not wake for events that were posted before the event
/// that is being handled, so the answer must not depend on such an event.
TEST(FileWorker, AQueuedActionMayWaitForWorkThatIsAlreadyDone) {
  FileWorker worker;
  bool is_answered = false, has_waited = false;
  QMetaObject::invokeMethod(
      &worker,
      [&] {
        worker.wait();
        has_waited = is_answered;
      },
      Qt::QueuedConnection);
  std::atomic<bool> is_done = false;
  worker.start([&]() -> FileWorker::Answer {
    is_done = true;
    return [&] { is_answered = true; };
  });
  while (!is_done) std::this_thread::yield();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // until the answer is posted, too
  QCoreApplication::processEvents();
  EXPECT_TRUE(has_waited);
}

}  // namespace
}  // namespace felt::desktop::file_worker_test
