#pragma once

#include <QObject>
#include <QSocketNotifier>
#include <array>
#include <memory>

namespace felt::desktop {

/// While it exists, SIGTERM, SIGINT and SIGHUP (a logout, `kill`, Ctrl-C, a terminal that closes)
/// emit `asked`. Otherwise they would end the process immediately, with the device's last force
/// still on. The second signal ends it as usual. One per process, main thread.
class SignalWatch : public QObject {
  Q_OBJECT

 public:
  explicit SignalWatch(QObject* parent = nullptr);
  ~SignalWatch() override;

 Q_SIGNALS:
  /// A signal asks the program to end. Emitted from the event loop.
  void asked();

 private:
  std::array<int, 2> pipe_{-1, -1};
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace felt::desktop
