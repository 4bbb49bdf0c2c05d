#pragma once

#include <QObject>
#include <QSocketNotifier>
#include <array>
#include <memory>

namespace felt::desktop {

/// Emits `asked` for SIGTERM, SIGINT and SIGHUP, which a logout, `kill`, Ctrl-C or a closing
/// terminal sends. Without a SignalWatch, these signals would end the process immediately, while
/// the device still exerts its last force. A second signal ends the process as usual. A process may
/// have only one SignalWatch, in the main thread.
class SignalWatch : public QObject {
  Q_OBJECT

 public:
  explicit SignalWatch(QObject* parent = nullptr);
  ~SignalWatch() override;

 Q_SIGNALS:
  /// Emitted from the event loop when a signal asks the program to end.
  void asked();

 private:
  std::array<int, 2> pipe_{-1, -1};
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace felt::desktop
