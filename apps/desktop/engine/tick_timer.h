#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>

class QSocketNotifier;

namespace felt::desktop {

/// A single-shot timer of the event loop, accurate to a few tens of microseconds. Qt's timers count
/// whole milliseconds, and the system may delay them by another 50 us.
///
///   connect(&timer, &TickTimer::due, this, &HapticLoop::due);
///   timer.start(loop.next_tick_ns() - loop.now_ns() + 50'000);
///
/// If the system provides no such timer, TickTimer uses one of Qt's, with the accuracy of that
/// timer. Use a TickTimer in the thread in which it was made.
class TickTimer : public QObject {
  Q_OBJECT

 public:
  explicit TickTimer(QObject* parent = nullptr);
  ~TickTimer() override;

  /// Lets the timer fire after `in_ns`, or immediately if `in_ns` is less than 1. Replaces an
  /// earlier start().
  void start(std::int64_t in_ns);
  void stop();

 Q_SIGNALS:
  void due();

 private:
  void take();

  int fd_ = -1;
  QSocketNotifier* notifier_ = nullptr;
  QTimer coarse_;  // used if the system provides no timer fd
};

}  // namespace felt::desktop
