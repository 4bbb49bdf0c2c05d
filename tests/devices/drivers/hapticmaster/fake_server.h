#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "felt/driver/byte_stream.h"
#include "tests/devices/drivers/hapticmaster/fake_controller.h"

namespace felt::hapticmaster {

/// The fake controller behind real TCP connections of this computer, on the real clock. One thread
/// accepts connections, answers requests and advances the simulated machine by calling serve().
class FakeServer {
 public:
  explicit FakeServer(FakeController& controller);
  ~FakeServer();
  FakeServer(const FakeServer&) = delete;
  FakeServer& operator=(const FakeServer&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  /// From now on, nothing is read from the first connection, that of the driver.
  void stall_first() noexcept { is_first_stalled_ = true; }
  /// Waits at most 1 ms for bytes and handles what has arrived.
  void serve();
  /// Returns the time since the server was made.
  [[nodiscard]] std::int64_t now_ns() const noexcept;

 private:
  struct Line {
    int socket = -1;
    std::unique_ptr<FakeController::Port> port;
  };
  void accept_line();
  static bool transfer(Line& line);

  FakeController& controller_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::int64_t begin_ns_ = 0;
  std::vector<Line> lines_;
  bool is_first_stalled_ = false;
};

}  // namespace felt::hapticmaster
