#include "desktop/files/instance.h"

#include <unistd.h>

#include <QCryptographicHash>
#include <QDataStream>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocalSocket>
#include <QLockFile>
#include <QStandardPaths>
#include <QWidget>

namespace felt::desktop {
namespace {

constexpr quint32 kMagic = 0x46656c74;
constexpr int kWaitMs = 2000;
constexpr qint64 kMaxBytes = 1 << 20;
constexpr char kTaken = '1';

/// Returns the path of the socket. It is in the runtime folder (XDG_RUNTIME_DIR) if the user can
/// write there, otherwise in the folder for temporary files. Returns "" if each process should work
/// independently.
QString socket_name(const QString& key) {
  QString text = key;
  if (text.isEmpty()) {
    // If the platform has no visible windows, each process works independently.
    const QString platform = QGuiApplication::platformName();
    if (platform == QStringLiteral("offscreen") || platform == QStringLiteral("minimal")) return {};
    text = QString::number(::getuid()) + QLatin1Char('|') + qEnvironmentVariable("DISPLAY") +
           QLatin1Char('|') + qEnvironmentVariable("WAYLAND_DISPLAY");
  }
  const QByteArray hash =
      QCryptographicHash::hash(text.toUtf8(), QCryptographicHash::Sha256).toHex().left(16);
  const QString name = QStringLiteral("feltline-") + QString::fromLatin1(hash);
  const QString runtime = qEnvironmentVariable("XDG_RUNTIME_DIR");
  const QString folder =
      !runtime.isEmpty() && QFileInfo(runtime).isWritable() ? runtime : QDir::tempPath();
  return folder + QLatin1Char('/') + name;
}

}  // namespace

Instance::Instance(const QString& key, QObject* parent) : QObject(parent), name_(socket_name(key)) {
  server_.setSocketOptions(QLocalServer::UserAccessOption);
  connect(&server_, &QLocalServer::newConnection, this, [this] {
    while (QLocalSocket* socket = server_.nextPendingConnection()) take(socket);
  });
}

/// Connects to the first process and sends it the paths. The first process answers with one byte.
/// If no answer comes, this process listens on the socket itself. A lock file ensures that two
/// processes that start simultaneously do this one after the other.
bool Instance::hand_over(const QStringList& files) {
  if (is_first() || name_.isEmpty()) return false;
  // Another process that starts now waits here.
  QLockFile start(name_ + QStringLiteral(".lock"));
  start.tryLock(kWaitMs);
  QStringList paths;
  for (const QString& file : files) paths.push_back(QFileInfo(file).absoluteFilePath());
  if (report_first(paths)) return true;
  // If no process answers, the socket was left behind by a dead process.
  QLocalServer::removeServer(name_);
  server_.listen(name_);
  return false;
}

bool Instance::report_first(const QStringList& files) const {
  QLocalSocket socket;
  socket.connectToServer(name_);
  if (!socket.waitForConnected(kWaitMs)) return false;
  QByteArray message;
  QDataStream out(&message, QIODevice::WriteOnly);
  out.setVersion(QDataStream::Qt_6_4);
  out << kMagic << files;
  socket.write(message);
  if (!socket.waitForBytesWritten(kWaitMs)) return false;
  while (socket.bytesAvailable() == 0) {
    if (!socket.waitForReadyRead(kWaitMs)) return false;
  }
  return socket.read(1) == QByteArray(1, kTaken);
}

void Instance::take(QLocalSocket* socket) {
  connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
  connect(socket, &QLocalSocket::readyRead, this, [this, socket] {
    if (socket->bytesAvailable() > kMaxBytes) return socket->abort();
    QDataStream in(socket);
    in.setVersion(QDataStream::Qt_6_4);
    in.startTransaction();
    quint32 magic = 0;
    QStringList files;
    in >> magic >> files;
    if (magic != 0 && magic != kMagic) return socket->abort();
    if (!in.commitTransaction()) return;  // the message is incomplete: wait for the rest
    socket->write(QByteArray(1, kTaken));
    socket->flush();
    socket->disconnectFromServer();
    // Queued, so that the caller gets its answer before a dialog can open.
    QMetaObject::invokeMethod(
        this, [this, files] { Q_EMIT wanted(files); }, Qt::QueuedConnection);
  });
}

void bring_forward(QWidget& window) {
  window.setWindowState(window.windowState() & ~Qt::WindowMinimized);
  window.show();
  window.raise();
  window.activateWindow();
}

}  // namespace felt::desktop
