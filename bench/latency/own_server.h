#pragma once

#include <sys/types.h>

#include <string>

namespace felt::bench {

/// An X server without a monitor (Xvfb, package xvfb) that runs during the lifetime of this object.
/// It has no window manager, no compositor and no windows of other programs.
class OwnServer {
 public:
  OwnServer();
  ~OwnServer();
  OwnServer(const OwnServer&) = delete;
  OwnServer& operator=(const OwnServer&) = delete;

  /// Returns the display, for example ":7". Returns "" if Xvfb is not installed or did not start
  /// within 10 s.
  [[nodiscard]] const std::string& display() const noexcept { return display_; }

 private:
  pid_t process_ = -1;
  std::string display_;
};

}  // namespace felt::bench
