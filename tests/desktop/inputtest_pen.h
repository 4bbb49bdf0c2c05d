#pragma once

#include <string>

#include "felt/base/result.h"

namespace felt::desktop {

/// A pen or a mouse of the "inputtest" driver of an X server. A mouse ignores pressures. Talks to
/// the driver through its socket (protocol 1.1: man 4 inputtestdrv). Calls block. Use from one
/// thread only.
class InputtestPen {
 public:
  static constexpr double kMaxPlace = 65535.0;  ///< largest x and y; 0..kMaxPlace is the screen
  static constexpr double kMaxPressure = 1000.0;

  /// Connects and agrees on the version. Fails if the driver does not answer as expected; the error
  /// contains the answer.
  static Result<InputtestPen> open(const std::string& socket_path);
  InputtestPen(InputtestPen&& other) noexcept;
  ~InputtestPen();

  /// come() moves the pen near the tablet, leave() out of reach. These and the functions below
  /// return false if the server has ended.
  bool come(double x, double y);
  bool leave(double x, double y);
  /// Moves the pen. Requires x and y in 0..65535 and a pressure in 0..1000.
  bool move(double x, double y, double pressure);
  bool press(bool down, double x, double y, double pressure);
  /// Waits until the server has handled all events.
  bool sync();

 private:
  explicit InputtestPen(int fd) noexcept : fd_(fd) {}
  bool send(const void* message, std::size_t size) const;
  bool receive(void* message, std::size_t size) const;

  int fd_ = -1;
};

}  // namespace felt::desktop
