#pragma once

#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <memory>
#include <string>

#include "felt/base/result.h"

namespace felt::desktop {

/// An X server of our own, without graphics card, keyboard and mouse, but with a pen that listens
/// on a socket (InputtestPen). Ends with this object.
class XServer {
 public:
  static constexpr int kWidth = 1280;
  static constexpr int kHeight = 800;

  /// Error: why it cannot run here.
  static Result<std::unique_ptr<XServer>> start();
  ~XServer();
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// ":5"
  [[nodiscard]] const QString& display() const noexcept { return display_; }
  [[nodiscard]] std::string pen_socket() const;

 private:
  XServer() = default;
  Result<void> run();

  QTemporaryDir folder_;
  QProcess process_;
  QString display_;
};

}  // namespace felt::desktop
