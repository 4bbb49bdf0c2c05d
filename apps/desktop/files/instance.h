#pragma once

#include <QLocalServer>
#include <QObject>
#include <QString>
#include <QStringList>

class QLocalSocket;

namespace felt::desktop {

/// One process for a person on a display, so that a file is open in one window and no more:
///
///   Instance instance;
///   if (instance.hand_over(files)) return 0;     // the first process takes them
///   connect(&instance, &Instance::wanted, ...);  // open each, or raise the window that has it
///
/// A socket that a crash left behind is taken over. Where no socket can be made, each process is
/// on its own.
class Instance : public QObject {
  Q_OBJECT

 public:
  /// `key` is for tests; "" is this person's on this display.
  explicit Instance(const QString& key = {}, QObject* parent = nullptr);

  /// True: another process has these files now (none: an empty drawing) and shows itself. False:
  /// there is no other; this is the first from now on.
  bool hand_over(const QStringList& files);
  [[nodiscard]] bool is_first() const { return server_.isListening(); }

 Q_SIGNALS:
  /// Another start wants these, as absolute paths; none: only that the program shows itself.
  void wanted(const QStringList& files);

 private:
  bool tell_first(const QStringList& files) const;
  void take(QLocalSocket* socket);

  QString name_;
  QLocalServer server_;
};

/// Brings a window to the front, out of the task bar if need be.
void bring_forward(QWidget& window);

}  // namespace felt::desktop
