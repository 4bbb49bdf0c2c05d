#include "tests/desktop/x_server.h"

#include <QDeadlineTimer>
#include <QFile>
#include <QStandardPaths>
#include <QThread>

namespace felt::desktop {
namespace {

constexpr int kStartMs = 20'000;
constexpr int kStopMs = 5'000;

/// The configuration of the server: %1 and %4 are the sockets of pen and mouse, %2 and %3 are
/// the size of the screen.
constexpr auto kConfiguration = R"(
Section "ServerFlags"
  Option "AutoAddDevices" "false"
  Option "AutoEnableDevices" "false"
  Option "DontVTSwitch" "true"
EndSection
Section "Device"
  Identifier "No card"
  Driver "dummy"
  VideoRam 65536
EndSection
Section "Monitor"
  Identifier "No monitor"
  HorizSync 5.0 - 1000.0
  VertRefresh 5.0 - 200.0
EndSection
Section "Screen"
  Identifier "Screen"
  Device "No card"
  Monitor "No monitor"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Virtual %2 %3
  EndSubSection
EndSection
Section "InputDevice"
  Identifier "Simulated Pen"
  Driver "inputtest"
  Option "SocketPath" "%1"
  Option "DeviceType" "PointerAbsoluteProximity"
  Option "PointerHasPressure" "true"
EndSection
Section "InputDevice"
  Identifier "Simulated Mouse"
  Driver "inputtest"
  Option "SocketPath" "%4"
  Option "DeviceType" "PointerAbsolute"
EndSection
Section "ServerLayout"
  Identifier "Layout"
  Screen "Screen"
  InputDevice "Simulated Pen" "CorePointer"
  InputDevice "Simulated Mouse" "SendCoreEvents"
EndSection
)";

}  // namespace

Result<std::unique_ptr<XServer>> XServer::start() {
  std::unique_ptr<XServer> server(new XServer);
  if (Result<void> running = server->run(); !running) return tl::unexpected(running.error());
  return server;
}

XServer::~XServer() {
  process_.terminate();
  if (!process_.waitForFinished(kStopMs)) process_.kill();
  process_.waitForFinished(kStopMs);
}

std::string XServer::pen_socket() const {
  return folder_.filePath(QStringLiteral("pen")).toStdString();
}

std::string XServer::mouse_socket() const {
  return folder_.filePath(QStringLiteral("mouse")).toStdString();
}

Result<void> XServer::run() {
  const QString program = QStandardPaths::findExecutable(
      QStringLiteral("Xorg"), {QStringLiteral("/usr/bin"), QStringLiteral("/usr/lib/xorg")});
  if (program.isEmpty()) return fail(ErrorCode::kNotFound, "there is no Xorg");
  QFile file(folder_.filePath(QStringLiteral("xorg.conf")));
  if (!file.open(QIODevice::WriteOnly)) {
    return fail(ErrorCode::kNotFound, file.errorString().toStdString());
  }
  file.write(QString::fromLatin1(kConfiguration)
                 .arg(QString::fromStdString(pen_socket()))
                 .arg(kWidth)
                 .arg(kHeight)
                 .arg(QString::fromStdString(mouse_socket()))
                 .toUtf8());
  file.close();
  const QString log = folder_.filePath(QStringLiteral("xorg.log"));
  process_.setStandardErrorFile(QProcess::nullDevice());
  process_.start(program,
                 {QStringLiteral("-config"), file.fileName(), QStringLiteral("-logfile"), log,
                  QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-noreset"),
                  QStringLiteral("-novtswitch"), QStringLiteral("-sharevts"),
                  QStringLiteral("-nolisten"), QStringLiteral("tcp")});
  const QDeadlineTimer deadline(kStartMs);
  QByteArray number;
  while (!number.endsWith('\n') && !deadline.hasExpired() &&
         process_.state() != QProcess::NotRunning) {
    process_.waitForReadyRead(100);
    number += process_.readAllStandardOutput();
  }
  const auto has_sockets = [this] {
    return QFile::exists(QString::fromStdString(pen_socket())) &&
           QFile::exists(QString::fromStdString(mouse_socket()));
  };
  while (!has_sockets() && !deadline.hasExpired() && process_.state() != QProcess::NotRunning) {
    process_.waitForReadyRead(50);
  }
  if (!number.endsWith('\n') || !has_sockets()) {
    QFile said(log);
    const bool is_open = said.open(QIODevice::ReadOnly);
    const QByteArray end = is_open ? said.readAll().right(400) : QByteArray();
    return fail(
        ErrorCode::kUnsupported,
        "Xorg with the drivers dummy and inputtest does not start (needs root, or a wrapper "
        "that allows it): " +
            end.toStdString());
  }
  display_ = QStringLiteral(":") + QString::fromLatin1(number.trimmed());
  return {};
}

}  // namespace felt::desktop
