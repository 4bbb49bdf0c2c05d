#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace felt::desktop {

/// Does work on files beside the window, one piece after another, so that the pen never waits for
/// a disk. What a piece returns is called on the thread of this object (Qt's main thread) when the
/// event loop runs, or in wait().
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
  /// Waits for what was started; answers that nobody heard are dropped.
  ~FileWorker() override;

  void start(Work work);
  [[nodiscard]] bool is_busy() const;
  /// Until nothing is in work, with all answers given. The window goes on being painted, but takes
  /// no input.
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
  int in_work_ = 0;  // waiting, running, or answer not given
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace felt::desktop
