#pragma once

#include <QObject>
#include <QSocketNotifier>
#include <array>
#include <memory>

namespace felt::desktop {

/// While one lives, SIGTERM, SIGINT and SIGHUP (a logout, `kill`, Ctrl-C, a terminal that closes)
/// ask for an end instead of ending us on the spot, with a device's last force still on. The second
/// one ends us as ever. One per process, main thread.
class SignalWatch : public QObject {
  Q_OBJECT

 public:
  explicit SignalWatch(QObject* parent = nullptr);
  ~SignalWatch() override;

 Q_SIGNALS:
  /// From the event loop.
  void asked();

 private:
  std::array<int, 2> pipe_{-1, -1};
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace felt::desktop
