#pragma once

#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <memory>
#include <string>

#include "felt/base/result.h"

namespace felt::desktop {

/// A private X server without graphics card and keyboard, but with a pen and a mouse that are
/// controlled through sockets (InputtestPen). The destructor stops the server.
class XServer {
 public:
  static constexpr int kWidth = 1280;
  static constexpr int kHeight = 800;

  /// Starts the server. Fails if it cannot run on this machine; the error says why.
  static Result<std::unique_ptr<XServer>> start();
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// Returns the name of the display, for example ":5".
  [[nodiscard]] const QString& display() const noexcept { return display_; }
  [[nodiscard]] std::string pen_socket() const;
  [[nodiscard]] std::string mouse_socket() const;

 private:
  XServer() = default;
  Result<void> run();

  QTemporaryDir folder_;
  QProcess process_;
  QString display_;
};

}  // namespace felt::desktop
