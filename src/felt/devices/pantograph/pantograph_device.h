#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>

#include "felt/devices/pantograph/board.h"
#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"
#include "felt/driver/force_gate.h"
#include "felt/rt/latest_value.h"

namespace felt::pantograph {

/// A 2DIY on its serial port.
///
/// A tick is one frame each way: write() sends torques, the next read() takes the angles that
/// answer them, carried on to the time of the read by the velocity that the driver makes of them. A
/// frame has no checksum and no mark of its beginning: what is not an answer in form (the device's
/// id, two angles that its arms can have) is a fault, everything that waits is thrown away, and the
/// next frame begins anew. Late angles count kMostMissed ticks longer, then read() fails with
/// kOther (or kBadData, when half an answer came), and after kMostSilentTicks with kDisconnected.
///
/// The board has no watchdog that we know of: torques hold until the next frame. All ways out
/// (stop(), a fault, the end of the device) send zero torques, more than once where they do not go;
/// a frame that did not go is a fault of write() (kOther). A process of its own (ByteStream's
/// keep_guard) sends them when this program was killed or stopped, or is silent for kGuardNs.
/// Without it nothing pushes: find_home() fails where it does not start, and write() (kForcesOff)
/// from when it has ended. A
/// board that hangs keeps its torques, whatever we do: pulling the plug switches the motors off
/// with the USB power, or their own switch.
///
/// Its encoders count from where they are switched on, so that the arms must be at rest then:
/// homing() is kRestPose until find_home().
class PantographDevice final : public DriverDevice {
 public:
  static constexpr std::int64_t kWaitNs = 400'000;
  static constexpr std::int64_t kSendNs = 100'000;
  /// How often stop() tries, and the end of the device, which has time.
  static constexpr int kStopTries = 4, kEndTries = 500;
  static constexpr std::int64_t kGuardNs = 50'000'000;  ///< of silence, for the guard
  static constexpr int kMostMissed = 4;
  static constexpr int kMostSilentTicks = 500;
  /// z of a pen that touches, and of one that does not: between two ticks no jump for the safety
  /// chain, and no speed that it would damp.
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

  /// Resets the board, sets it up, and waits for its first answer. Edit thread; also how a driver
  /// sees that there is a board at all.
  Result<void> set_up();

 private:
  enum class Heard : std::uint8_t { kNothing, kHalf, kAngles, kBad, kClosed };

  bool send(const std::array<double, 2>& torques_nm) noexcept;
  void let_go(int tries) noexcept;
  Heard hear(std::int64_t within_ns) noexcept;
  Heard take_reply() noexcept;
  Heard take_replies(Heard newest) noexcept;
  void throw_away() noexcept;
  void follow(const Vec3& measured, double step_s) noexcept;
  void place_pen(std::int64_t now_ns) noexcept;
  tl::expected<PenSample, DeviceFault> nothing_heard(Heard heard) noexcept;
  tl::unexpected<DeviceFault> failed(DeviceFault fault, std::string_view words) noexcept;
  tl::unexpected<DeviceFault> gone(std::string_view words) noexcept;

  std::unique_ptr<ByteStream> port_;
  const BoardModel& model_;
  DeviceDescriptor descriptor_;
  ForceGate gate_;
  Force sent_;  // what the torques of the newest frame push with
  std::atomic<bool> is_down_;
  bool is_home_ = false;
  bool is_set_up_ = false;  // it was told what it drives, since it began anew

  // The haptic thread's own; where no loop runs, that of the edit thread.
  std::array<std::byte, 64> in_{};
  std::size_t filled_ = 0;
  std::array<double, 2> angles_rad_{};
  std::optional<FiveBar> bar_;  // of the newest angles
  Vec3 place_, velocity_;       // filtered, mm and mm/s
  bool has_place_ = false;
  PenSample sample_;
  bool has_sample_ = false;
  int unanswered_ = 0;
  int missed_ = 0;
  bool is_gone_ = false;
  ShortText gone_words_;
  std::int64_t now_ns_ = 0;
  std::int64_t sent_ns_ = 0;   // the newest frame
  std::int64_t heard_ns_ = 0;  // when the newest angles were measured
  DeviceStatus status_;

  LatestValue<DeviceStatus> shown_;
};

}  // namespace felt::pantograph
