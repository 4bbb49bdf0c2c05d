#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace felt::desktop {

/// Runs work on files on another thread, in sequence, so that the pen never waits for a disk. Each
/// piece of work returns a function, which is called on the thread of this object (Qt's main
/// thread), from the event loop or in wait().
///
///   worker.start([copy = std::move(drawing)] {          // on the other thread
///     auto done = write(copy);
///     return [this, done] { tell(done); };              // here
///   });
class FileWorker : public QObject {
  Q_OBJECT

 public:
  using Answer = std::function<void()>;
  using Work = std::function<Answer()>;

  explicit FileWorker(QObject* parent = nullptr);
  /// Waits until all started work is done. Returned functions that were not called yet are dropped.
  ~FileWorker() override;

  void start(Work work);
  [[nodiscard]] bool is_busy() const;
  /// Waits until all work is done and all returned functions were called. Meanwhile the window is
  /// painted but gets no input.
  void wait();

 Q_SIGNALS:
  void idle();

 private:
  void run();
  void deliver();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Work> waiting_;
  std::deque<Answer> answers_;
  int in_progress_ = 0;  // number of pieces of work that are waiting or running, or whose returned
                         // function was not called yet
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace felt::desktop
