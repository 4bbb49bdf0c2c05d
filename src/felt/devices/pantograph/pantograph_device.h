#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "felt/devices/pantograph/board.h"
#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"
#include "felt/driver/force_gate.h"
#include "felt/driver/position_filter.h"
#include "felt/rt/latest_value.h"

namespace felt::pantograph {

/// A 2DIY on a serial port.
///
/// In each tick, one frame is sent and one received: write() sends torques, and the next read()
/// receives the angles that answer them. The driver estimates the velocity from the angles and uses
/// it to extrapolate the position to the time of the read. A frame has neither checksum nor start
/// mark. A valid reply has the device's id and two possible angles; any other reply is a fault. All
/// received bytes are then discarded, so that the reply to the next frame is read from its start.
/// If a reply is late, read() returns the last sample for up to kMaxMissed ticks. After kMaxMissed
/// ticks, read() fails with kOther, or with kBadData if only a part of a reply came; after
/// kMaxSilentTicks it fails with kDisconnected.
///
/// The board has no known watchdog: torques hold until the next frame. Therefore the driver sends
/// zero torques after every fault, in stop() and in the destructor, and repeats this if necessary.
/// If a frame cannot be sent, write() fails with kOther. A separate process (ByteStream's
/// keep_guard) sends zero torques if this program was killed or stopped, or is silent for kGuardNs.
/// Without that process no force is possible: find_home() fails if the process does not start, and
/// write() returns kForcesOff after it has ended. If the board itself hangs, it keeps its torques;
/// in that case, the motors can be turned off only by their switch or by unplugging the USB cable.
///
/// The encoders count from the position that the arms had when the board was last set up, so the
/// user must hold the arms in their rest pose during find_home(). Until find_home() has succeeded,
/// homing() returns kRestPose.
class PantographDevice final : public DriverDevice {
 public:
  static constexpr std::int64_t kWaitNs = 400'000;
  static constexpr std::int64_t kSendNs = 100'000;
  /// Number of times that stop() and the destructor try to send zero torques. The destructor has
  /// more time.
  static constexpr int kStopTries = 4, kEndTries = 500;
  static constexpr std::int64_t kGuardNs = 50'000'000;  ///< silence until the guard acts
  static constexpr int kMaxMissed = 4;
  static constexpr int kMaxSilentTicks = 500;
  /// The z of a pen that touches the surface and of a pen that does not. The difference is so small
  /// that the safety chain treats it neither as a jump nor as a high speed that must be damped.
  static constexpr double kDownMm = -0.25, kUpMm = 0.25;

  PantographDevice(std::unique_ptr<ByteStream> port, const BoardModel& model,
                   DeviceDescriptor descriptor, const OpenOptions& options);
  ~PantographDevice() override;

  [[nodiscard]] std::string_view name() const noexcept override { return descriptor_.id; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override;
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return sent_; }
  bool set_pen_down(bool is_down) noexcept override {
    is_down_.store(is_down);
    return true;
  }
  [[nodiscard]] Homing homing() noexcept override {
    return is_home_ ? Homing::kNone : Homing::kRestPose;
  }
  [[nodiscard]] std::string homing_words() override;
  Result<void> find_home() override;

  /// Resets the board, sets it up, and waits for its first answer. The driver also uses it to check
  /// that a board is connected. Used on the edit thread.
  Result<void> set_up();

 private:
  enum class Received : std::uint8_t { kNothing, kHalf, kAngles, kBad, kClosed };

  bool send(const std::array<double, 2>& torques_nm) noexcept;
  void release(int tries) noexcept;
  Received receive(std::int64_t within_ns) noexcept;
  Received take_reply() noexcept;
  Received take_replies(Received newest) noexcept;
  void throw_away() noexcept;
  void place_pen(std::int64_t now_ns) noexcept;
  tl::expected<PenSample, DeviceFault> nothing_received(Received received) noexcept;
  tl::unexpected<DeviceFault> failed(DeviceFault fault, std::string_view words) noexcept;
  tl::unexpected<DeviceFault> gone(std::string_view words) noexcept;

  std::unique_ptr<ByteStream> port_;
  const BoardModel& model_;
  DeviceDescriptor descriptor_;
  ForceGate gate_;
  PositionFilter filter_;
  Force sent_;  // the force of the newest frame's torques
  std::atomic<bool> is_down_;
  bool is_home_ = false;
  bool is_set_up_ = false;  // the board has been set up since the last reset

  // These are used by the haptic thread, or by the edit thread while no loop runs.
  std::array<std::byte, 64> in_{};
  std::size_t filled_ = 0;
  std::array<double, 2> angles_rad_{};
  std::optional<FiveBar> bar_;  // linkage at the newest angles
  PenSample sample_;
  bool has_sample_ = false;
  int unanswered_ = 0;
  int missed_ = 0;
  bool is_gone_ = false;
  ShortText gone_words_;
  std::int64_t now_ns_ = 0;
  std::int64_t sent_ns_ = 0;      // time of the newest frame
  std::int64_t received_ns_ = 0;  // when the newest angles were measured
  DeviceStatus status_;

  LatestValue<DeviceStatus> shown_;
};

}  // namespace felt::pantograph
