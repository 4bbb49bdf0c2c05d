#pragma once

#include <QLocalServer>
#include <QObject>
#include <QString>
#include <QStringList>

class QLocalSocket;

namespace felt::desktop {

/// Ensures that each user has one process per display, so that a file is open in only one window:
///
///   Instance instance;
///   if (instance.hand_over(files)) return 0;     // the first process opens them
///   connect(&instance, &Instance::wanted, ...);  // open each, or raise the window that has it
///
/// A socket left behind by a crash is replaced. If no socket can be made, each process works
/// independently.
class Instance : public QObject {
  Q_OBJECT

 public:
  /// `key` is for tests; "" means this user on this display.
  explicit Instance(const QString& key = {}, QObject* parent = nullptr);

  /// Passes the files to the first process and returns true if that process has received them. The
  /// first process then opens the files, or only shows its window if the list is empty. Returns
  /// false if no other process answers; then this process becomes the first process.
  bool hand_over(const QStringList& files);
  [[nodiscard]] bool is_first() const { return server_.isListening(); }

 Q_SIGNALS:
  /// Emitted when another process of the program has passed these absolute paths. If the list is
  /// empty, only show a window.
  void wanted(const QStringList& files);

 private:
  bool report_first(const QStringList& files) const;
  void take(QLocalSocket* socket);

  QString name_;
  QLocalServer server_;
};

/// Brings a window to the front, and restores it if it is minimised.
void bring_forward(QWidget& window);

}  // namespace felt::desktop
