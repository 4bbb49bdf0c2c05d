#pragma once

#include <memory>
#include <optional>
#include <string>

#include "felt/driver/calibrated_device.h"
#include "felt/geometry/rect.h"
#include "felt/rt/realtime_thread.h"
#include "real_device.h"

namespace felt::cli {

/// A real device in the haptic loop, from opening to unplugging. Forces are off at first. Closed
/// without force by its destructor.
class LiveLoop {
 public:
  /// Opens it, finds its home where it needs that (`may_move`: asks a person first where it is
  /// null), and starts the loop. Where nobody has shown the plane, the middle of what the device
  /// reaches is the middle of `page`. Error: the maker's words, and what to try.
  static Result<std::unique_ptr<LiveLoop>> start(const RealDevice& device, const Rect& page,
                                                 double force_limit_n, bool asks);
  LiveLoop(const LiveLoop&) = delete;
  LiveLoop& operator=(const LiveLoop&) = delete;
  ~LiveLoop();

  /// Ends it without force. False: the device hangs in its maker's call (RealtimeThread::stop());
  /// device and loop are given up then, and nothing here but the destructor may be called any more.
  /// Neither may the driver: its own calls may wait for that one.
  [[nodiscard]] bool stop() noexcept;
  /// After stop() that was true: ticks again, forces off. Error: as start().
  Result<void> go_on();

  /// In the sheet's frame, its plane's scale counted, with the person's limits.
  [[nodiscard]] const Capabilities& capabilities() const noexcept {
    return calibrated_->capabilities();
  }
  [[nodiscard]] Servo& servo() noexcept { return *servo_; }
  [[nodiscard]] RealtimeThread& thread() noexcept { return *thread_; }
  [[nodiscard]] DeviceStatus status() noexcept { return device_->status(); }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept {
    return device_->descriptor();
  }

 private:
  LiveLoop(std::unique_ptr<DriverDevice> device, const DeviceProfile& profile,
           const PlaneCalibration& plane, double force_limit_n);

  std::unique_ptr<DriverDevice> device_;
  std::unique_ptr<CalibratedDevice> calibrated_;
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<RealtimeThread> thread_;
};

}  // namespace felt::cli
