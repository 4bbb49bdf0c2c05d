#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>

class QSocketNotifier;

namespace felt::desktop {

/// A single shot of the event loop that comes when it is asked to, to some ten microseconds; timers
/// of Qt come on whole milliseconds, and the system may put these off by another 50 us.
///
///   connect(&timer, &TickTimer::due, this, &HapticLoop::due);
///   timer.start(loop.next_tick_ns() - loop.now_ns() + 50'000);
///
/// Where the system has no such timer, one of Qt does what it can. The thread it lives in.
class TickTimer : public QObject {
  Q_OBJECT

 public:
  explicit TickTimer(QObject* parent = nullptr);
  ~TickTimer() override;

  /// In so many ns, at once where that is less than one; in place of what start() said before.
  void start(std::int64_t in_ns);
  void stop();

 Q_SIGNALS:
  void due();

 private:
  void take();

  int fd_ = -1;
  QSocketNotifier* notifier_ = nullptr;
  QTimer coarse_;  // without an fd
};

}  // namespace felt::desktop
