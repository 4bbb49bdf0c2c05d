#pragma once

#include <string>

#include "felt/base/result.h"

namespace felt::desktop {

/// A pen of an X server's "inputtest" driver, spoken to over the driver's socket (its protocol 1.1:
/// man 4 inputtestdrv). One to a server. Blocking; any one thread.
class InputtestPen {
 public:
  static constexpr double kMaxPlace = 65535.0;  ///< of x and y, the whole screen
  static constexpr double kMaxPressure = 1000.0;

  /// Connects and agrees on the version. Error: says what the driver did.
  static Result<InputtestPen> open(const std::string& socket_path);
  InputtestPen(InputtestPen&& other) noexcept;
  ~InputtestPen();

  /// Near the tablet, or out of reach. False: the server is gone; likewise below.
  bool come(double x, double y);
  bool leave(double x, double y);
  /// x, y in 0..65535, pressure in 0..1000.
  bool move(double x, double y, double pressure);
  bool press(bool down, double x, double y, double pressure);
  /// Waits until the server has dealt with all of it.
  bool sync();

 private:
  explicit InputtestPen(int fd) noexcept : fd_(fd) {}
  bool send(const void* message, std::size_t size) const;
  bool receive(void* message, std::size_t size) const;

  int fd_ = -1;
};

}  // namespace felt::desktop
