#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "felt/devices/hapticmaster/controller_link.h"
#include "felt/devices/hapticmaster/controller_text.h"
#include "felt/devices/hapticmaster/machine_watch.h"
#include "felt/devices/hapticmaster/motion_check.h"
#include "felt/devices/hapticmaster/request_queue.h"
#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"
#include "felt/driver/force_gate.h"
#include "felt/driver/loop_time.h"
#include "felt/driver/service_report.h"

namespace felt::hapticmaster {

/// Opens another connection to the same controller.
using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;

/// What the status says if the machine does not confirm that it is off.
inline constexpr std::string_view kNotOff =
    "The machine does not confirm that it is switched off: press its emergency button!";
/// What the status says before the machine is prepared.
inline constexpr std::string_view kNotPrepared =
    "The machine is not ready: it must be calibrated and switched on first.";

/// A HapticMASTER, used through its controller.
///
/// The machine measures the force of the hand and moves a virtual mass. The driver creates one
/// effect, a bias force on that mass, and sets it in each tick. read() asks for the velocity of the
/// mass and for the position, in one round trip, and waits kWaitNs for them; write() sets the
/// force, whose answer the next read() receives. Answers come in the order of the requests
/// (RequestQueue). While answers are late, read() repeats the last sample, and the force stays for
/// a bounded time and is then set to zero (ServicePace); after kMaxHeldNs read() fails with kOther.
///
/// The machine is switched off (switch_off()) if a condition lasts longer than its limit in the
/// table kLimits (MachineWatch), if the controller refuses to end a force, if the machine has left
/// the state `force` for `off` or `init`, or if its guard does not run. Then read() returns
/// kNotCalibrated until find_home() has succeeded again, and repeats the request to switch off
/// until the machine confirms it. All limits are in real time (LoopTime).
///
/// Every kStateTicks ticks, read() also asks for the state. If it is not `force`, the machine does
/// not follow the hand, and write() sends no force and returns kForcesOff. If an answer does not
/// belong to its request, or came without one, nothing that the controller says can be trusted: the
/// device is disconnected.
///
/// A force lasts until the next command, whatever happens to this program. Therefore a separate
/// process (PortGuard) with a connection of its own switches the machine off and removes all
/// effects after kGuardNs without a sign of life (read()), unless stop() has sent a release since
/// that was confirmed. find_home() proves that it does so, twice, before an effect is enabled. It
/// also acts immediately if the machine is to be switched off, if the connection of this object
/// fails, and at the end.
///
/// Nothing moves before find_home(), which the user must agree to: until then, the driver only asks
/// for states and limits.
class HapticMasterDevice final : public DriverDevice {
 public:
  static constexpr std::int64_t kWaitNs = 2'500'000;
  static constexpr std::int64_t kSendNs = 200'000;
  static constexpr std::int64_t kAskNs = 1'000'000'000;  ///< wait for an answer on the edit thread
  static constexpr std::int64_t kMaxHeldNs = 20'000'000;
  static constexpr std::int64_t kGuardNs = 50'000'000;
  static constexpr std::int64_t kMaxGuardNs = 100'000'000;  ///< by then all effects must be gone
  /// Until the machine confirms that it is off, it is asked to switch off this often.
  static constexpr std::int64_t kOffAskedNs = 50'000'000;
  /// If it has not confirmed that after this time, the user is told to switch it off.
  static constexpr std::int64_t kOffKnownNs = 500'000'000;
  static constexpr int kStateTicks = 2;
  static constexpr double kInertiaKg = 3.0;
  /// Friction of the virtual mass. Without it, the smallest error of the force sensor would move
  /// the machine, and a handle that was let go would coast.
  static constexpr double kFrictionN = 0.5;

  /// `link` has no request under way. `sector` is the workspace that the controller reported.
  HapticMasterDevice(std::unique_ptr<ControllerLink> link, Connect connect, const Sector& sector,
                     DeviceDescriptor descriptor);
  ~HapticMasterDevice() override;

  [[nodiscard]] std::string_view name() const noexcept override { return descriptor_.id; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override { return report_.shown(); }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return gate_.held(); }
  void stop() noexcept override;
  [[nodiscard]] Homing homing() noexcept override {
    return mode_ == Mode::kReady && guard_->is_guarded() ? Homing::kNone : Homing::kByItself;
  }
  [[nodiscard]] std::string homing_words() override;
  Result<void> find_home() override;

 private:
  /// What the driver may do. find_home() leads from kNotReady to kReady, switch_off() back, and
  /// lose() from anywhere to kGone, which is permanent.
  enum class Mode : std::uint8_t { kNotReady, kReady, kGone };
  enum class Received : std::uint8_t { kNothing, kPosition, kDoubtful, kBad, kRefused, kClosed };

  // hapticmaster_device.cc: the haptic loop.
  std::int64_t tick(std::int64_t now_ns) noexcept;
  bool send(Request request, std::string_view text) noexcept;
  void request_all() noexcept;
  Received receive(std::int64_t within_ns) noexcept;
  Received take_answer(std::string_view answer) noexcept;
  Received take_position(std::string_view answer, const RequestQueue::Sent& sent) noexcept;
  [[nodiscard]] Signs signs_of(Received received) const noexcept;
  Received take_velocity(std::string_view answer) noexcept;
  Received take_state(std::string_view answer) noexcept;
  Received take_confirmation(std::string_view answer, Request request) noexcept;
  Received lose(std::string_view words, std::string_view answer) noexcept;
  void switch_off(const ShortText& words) noexcept;
  void ask_off() noexcept;
  void follow_off(std::int64_t ns) noexcept;
  void place_pen() noexcept;
  void put(const Force& force) noexcept;
  bool release() noexcept;
  [[nodiscard]] std::optional<ShortText> no_force_words() noexcept;
  tl::expected<PenSample, DeviceFault> nothing_received() noexcept;
  tl::expected<PenSample, DeviceFault> position_received() noexcept;
  tl::unexpected<DeviceFault> failed(DeviceFault fault, const ShortText& words) noexcept;
  tl::unexpected<DeviceFault> not_ready() noexcept;

  // hapticmaster_setup.cc: what the edit thread does while no loop runs.
  Result<std::string> ask(std::string_view text);
  Result<void> tell(std::string_view text);
  Result<void> settle();
  Result<void> start_guard();
  Result<void> prove_guard(std::string_view state);
  Result<void> expect_state(std::string_view expected);
  Result<void> calibrate_force();
  Result<void> find_end_stops();
  Result<void> create_effect();
  Result<void> prepare();
  Result<void> ensure_off();
  Result<void> shut_down();
  void pause(std::int64_t ns);

  std::unique_ptr<ControllerLink> link_;
  Connect connect_;
  DeviceDescriptor descriptor_;
  ForceGate gate_;  // its held() is the force of the newest command
  RequestQueue queue_;
  std::unique_ptr<ByteStream> guard_;  // null before find_home()
  EffectName effect_{};                // of the last find_home()
  Mode mode_ = Mode::kNotReady;
  ShortText mode_words_;  // why it is not ready or gone
  // Since switch_off(), until the machine confirms that it is off:
  bool is_off_pending_ = false;
  std::int64_t off_ns_ = 0;        // time since switch_off()
  std::int64_t off_asked_ns_ = 0;  // time since it was asked for last
  ShortText off_words_;            // why it is switched off

  // These are used by the haptic thread, or by the edit thread while no loop runs.
  LoopTime time_;
  MachineWatch watch_;
  MotionCheck motion_;
  Vec3 measured_mm_;
  std::int64_t measured_ns_ = 0;           // when the newest position was asked for
  std::optional<Vec3> velocity_mm_per_s_;  // nullopt if the newest answer was not a velocity
  PenSample sample_;
  bool has_sample_ = false;
  bool is_in_force_ = false;  // the machine's state as far as it is known
  // The force is to be zero since the last confirmed release, and that is not confirmed yet.
  bool is_release_pending_ = false;
  bool is_resting_ = false;  // since a confirmed stop(), until the next read()
  ShortText refused_words_;  // the controller's error, or what is wrong with its state
  int ticks_ = 0;
  std::int64_t now_ns_ = 0;
  std::int64_t sum_ns_ = 0;  // of the times of all ticks; goes on if the clock stands still
  ServiceReport report_;
};

/// Writes the requests with which the guard takes every effect away, as bytes.
using LastWords = std::array<std::byte, 64>;
std::span<const std::byte> last_words(LastWords& room) noexcept;

/// Asks the controller on a connection that has no other request under way. Fails with the
/// controller's error, or if no answer comes in time. Used on the edit thread.
Result<std::string> ask_controller(ControllerLink& link, std::string_view text);

}  // namespace felt::hapticmaster
