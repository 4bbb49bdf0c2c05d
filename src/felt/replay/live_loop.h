#pragma once

#include <functional>
#include <memory>

#include "felt/driver/open_device.h"
#include "felt/geometry/rect.h"
#include "felt/replay/real_device.h"
#include "felt/rt/realtime_thread.h"

namespace felt {

/// A real device in the haptic loop, from opening to unplugging. Forces are off at first. The
/// destructor sets the force to zero and closes the device.
class LiveLoop {
 public:
  /// Shows the user the maker's instructions and asks whether the arm may move on its own.
  using MayMove = std::function<bool(const std::string& instructions)>;

  /// Opens the device, homes it if necessary, and starts the loop. If `may_move` is null, homes the
  /// device without asking the user. If no plane was calibrated, the centre of the device's
  /// workspace is the centre of `page`. On failure, the error contains the maker's message and a
  /// suggestion.
  static Result<std::unique_ptr<LiveLoop>> start(const RealDevice& device, const Rect& page,
                                                 double force_limit_n, const MayMove& may_move);
  LiveLoop(const LiveLoop&) = delete;
  LiveLoop& operator=(const LiveLoop&) = delete;
  ~LiveLoop();

  /// Sets the force to zero and stops the loop. Returns false if the device is unresponsive in a
  /// call of its maker's library (RealtimeThread::stop()). Device and loop are then abandoned, and
  /// only the destructor may be called. The driver must not be used either, because its calls may
  /// wait for the unresponsive call.
  [[nodiscard]] bool stop() noexcept;
  /// Restarts the ticks, with forces off. Requires that stop() returned true. Fails like start().
  Result<void> go_on();

  [[nodiscard]] OpenDevice& device() noexcept { return *device_; }
  [[nodiscard]] Servo& servo() noexcept { return *servo_; }
  [[nodiscard]] RealtimeThread& thread() noexcept { return *thread_; }

 private:
  LiveLoop(std::unique_ptr<OpenDevice> device, double force_limit_n);

  std::unique_ptr<OpenDevice> device_;
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<RealtimeThread> thread_;
};

}  // namespace felt
