#pragma once

#include <functional>
#include <memory>

#include "felt/driver/open_device.h"
#include "felt/geometry/rect.h"
#include "felt/replay/real_device.h"
#include "felt/rt/realtime_thread.h"

namespace felt {

/// A real device in the haptic loop, from opening to unplugging. Forces are off at first. Closed
/// without force by its destructor.
class LiveLoop {
 public:
  /// Asks the user, with the maker's instructions, whether the arm may move by itself.
  using MayMove = std::function<bool(const std::string& instructions)>;

  /// Opens the device, finds its home if it needs that (without asking if `may_move` is null), and
  /// starts the loop. If no plane was calibrated, the centre of the device's reach is the centre of
  /// `page`. The error has the maker's words, and what to try.
  static Result<std::unique_ptr<LiveLoop>> start(const RealDevice& device, const Rect& page,
                                                 double force_limit_n, const MayMove& may_move);
  LiveLoop(const LiveLoop&) = delete;
  LiveLoop& operator=(const LiveLoop&) = delete;
  ~LiveLoop();

  /// Ends it without force. False: the device hangs in its maker's call (RealtimeThread::stop());
  /// device and loop are given up then, and nothing here but the destructor may be called any more.
  /// Neither may the driver: its own calls may wait for that one.
  [[nodiscard]] bool stop() noexcept;
  /// After stop() that was true: ticks again, forces off. Error: as start().
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
