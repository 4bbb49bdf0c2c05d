#include "desktop/files/file_worker.h"

#include <QEventLoop>
#include <utility>

namespace felt::desktop {

FileWorker::FileWorker(QObject* parent) : QObject(parent), thread_([this] { run(); }) {}

FileWorker::~FileWorker() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void FileWorker::start(Work work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(work));
    ++in_progress_;
  }
  wake_.notify_one();
}

bool FileWorker::is_busy() const {
  const std::lock_guard lock(mutex_);
  return in_progress_ > 0;
}

/// Calls the functions that were returned before without the event loop: if the caller handles a
/// posted event, Qt's nested loop may sleep although deliver() was posted already.
void FileWorker::wait() {
  deliver();
  if (!is_busy()) return;
  QEventLoop loop;
  connect(this, &FileWorker::idle, &loop, &QEventLoop::quit);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
}

void FileWorker::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
    if (waiting_.empty()) return;  // started work is always finished, even when stopping
    Work work = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    Answer answer = work();
    work = nullptr;  // frees the captured data on this thread, because a drawing has many strokes
    lock.lock();
    answers_.push_back(std::move(answer));
    QMetaObject::invokeMethod(this, &FileWorker::deliver, Qt::QueuedConnection);
  }
}

void FileWorker::deliver() {
  for (;;) {
    Answer answer;
    {
      const std::lock_guard lock(mutex_);
      if (answers_.empty()) return;
      answer = std::move(answers_.front());
      answers_.pop_front();
    }
    if (answer) answer();
    bool is_idle = false;
    {
      const std::lock_guard lock(mutex_);
      is_idle = --in_progress_ == 0;
    }
    if (is_idle) Q_EMIT idle();
  }
}

}  // namespace felt::desktop
