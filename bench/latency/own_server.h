#pragma once

#include <sys/types.h>

#include <string>

namespace felt::bench {

/// An X server without a screen to look at (Xvfb, package xvfb), for as long as this object is:
/// no window manager, no compositor, nobody else's windows.
class OwnServer {
 public:
  OwnServer();
  ~OwnServer();
  OwnServer(const OwnServer&) = delete;
  OwnServer& operator=(const OwnServer&) = delete;

  /// ":7"; empty: there is no Xvfb, or it did not start within 10 s.
  [[nodiscard]] const std::string& display() const noexcept { return display_; }

 private:
  pid_t process_ = -1;
  std::string display_;
};

}  // namespace felt::bench
