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
#include "felt/devices/hapticmaster/request_queue.h"
#include "felt/driver/byte_stream.h"
#include "felt/driver/driver.h"
#include "felt/driver/force_gate.h"
#include "felt/driver/service_pace.h"
#include "felt/rt/latest_value.h"

namespace felt::hapticmaster {

/// Opens another connection to the same controller.
using Connect = std::function<Result<std::unique_ptr<ByteStream>>()>;

/// A HapticMASTER, used through its controller.
///
/// The machine measures the force of the hand and moves a virtual mass. The driver creates one
/// effect, a bias force on that mass, and sets it in each tick. read() asks for the velocity of the
/// mass and for the position, in one round trip, and waits kWaitNs for them; write() sets the
/// force, whose answer the next read() receives. Answers come in the order of the requests
/// (RequestQueue). While answers are late, read() repeats the last sample, and the force stays for
/// a bounded time and is then set to zero (ServicePace); after kMaxHeldNs read() fails with kOther,
/// after kMaxSilentNs with kDisconnected.
///
/// Every kStateTicks ticks, read() also asks for the state. If it is not `force`, the machine does
/// not follow the hand, and write() sends no force and returns kForcesOff. If it is `off` or
/// `init`, or if the effect is gone, read() returns kNotCalibrated until find_home() has succeeded
/// again. If an answer does not belong to its request, or came without one, nothing that the
/// controller says can be trusted: the device is disconnected.
///
/// A force lasts until the next command, whatever happens to this program. Therefore a separate
/// process (PortGuard) with a connection of its own switches the machine off and removes all
/// effects after kGuardNs without a sign of life (read()), unless stop() has sent a release since.
/// find_home() proves that it does so, twice, before an effect is enabled. It also acts immediately
/// if the connection of this object fails, and at the end.
///
/// Nothing moves before find_home(), which the user must agree to: until then, the driver only asks
/// for states and limits.
class HapticMasterDevice final : public DriverDevice {
 public:
  static constexpr std::int64_t kWaitNs = 2'500'000;
  static constexpr std::int64_t kSendNs = 200'000;
  static constexpr std::int64_t kAskNs = 1'000'000'000;  ///< wait for an answer on the edit thread
  static constexpr std::int64_t kMaxHeldNs = 20'000'000;
  static constexpr std::int64_t kMaxSilentNs = 1'000'000'000;
  static constexpr std::int64_t kGuardNs = 50'000'000;
  static constexpr std::int64_t kMaxGuardNs = 100'000'000;  ///< by then all effects must be gone
  static constexpr int kStateTicks = 2;
  static constexpr double kBeyondMm = 50.0;  ///< a position farther outside is invalid
  static constexpr double kInertiaKg = 3.0;

  /// `link` has no request under way. `sector` is the workspace that the controller reported.
  HapticMasterDevice(std::unique_ptr<ControllerLink> link, Connect connect, const Sector& sector,
                     DeviceDescriptor descriptor);
  ~HapticMasterDevice() override;

  [[nodiscard]] std::string_view name() const noexcept override { return descriptor_.id; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override;
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return gate_.held(); }
  void stop() noexcept override;
  [[nodiscard]] Homing homing() noexcept override {
    return is_home_ && guard_->is_guarded() ? Homing::kNone : Homing::kByItself;
  }
  [[nodiscard]] std::string homing_words() override;
  Result<void> find_home() override;

 private:
  enum class Received : std::uint8_t { kNothing, kPosition, kBad, kRefused, kClosed };

  // hapticmaster_device.cc: the haptic loop.
  void wait_until(std::int64_t now_ns) noexcept;
  bool send(Request request, std::string_view text) noexcept;
  void request_all() noexcept;
  Received receive(std::int64_t within_ns) noexcept;
  Received take_answer(std::string_view answer) noexcept;
  Received take_position(std::string_view answer, std::int64_t sent_ns) noexcept;
  Received take_velocity(std::string_view answer) noexcept;
  Received take_state(std::string_view answer) noexcept;
  Received take_confirmation(std::string_view answer, Request request) noexcept;
  Received lose(std::string_view words, std::string_view answer) noexcept;
  void follow_pace(bool has_position) noexcept;
  void place_pen() noexcept;
  void put(const Force& force) noexcept;
  void release() noexcept;
  [[nodiscard]] std::optional<ShortText> no_force_words() noexcept;
  tl::expected<PenSample, DeviceFault> nothing_received() noexcept;
  tl::unexpected<DeviceFault> failed(DeviceFault fault, const ShortText& words) noexcept;
  tl::unexpected<DeviceFault> gone() noexcept;

  // hapticmaster_setup.cc: what the edit thread does while no loop runs.
  Result<std::string> ask(std::string_view text);
  Result<void> tell(std::string_view text);
  Result<void> settle();
  Result<void> start_guard();
  Result<void> prove_guard();
  Result<void> calibrate();
  Result<void> create_effect();
  Result<void> prepare();
  void switch_off();
  void pause(std::int64_t ns);

  std::unique_ptr<ControllerLink> link_;
  Connect connect_;
  Box inside_;  // every position of the machine
  DeviceDescriptor descriptor_;
  ForceGate gate_;  // its held() is the force of the newest command
  ServicePace pace_;
  RequestQueue queue_;
  std::unique_ptr<ByteStream> guard_;  // null before find_home()
  bool is_home_ = false;
  bool is_gone_ = false;
  ShortText gone_words_;

  // These are used by the haptic thread, or by the edit thread while no loop runs.
  Vec3 measured_mm_, velocity_mm_per_s_;
  int positions_ = 0;             // in a row, counted up to kSteadyPositions
  bool has_velocity_ = false;     // since the velocity was last asked for
  std::int64_t measured_ns_ = 0;  // when the newest position was asked for
  PenSample sample_;
  bool has_sample_ = false;
  bool is_in_force_ = false;  // the machine's state as far as it is known
  ShortText refused_words_;   // the controller's error, or what is wrong with its state
  std::optional<ShortText> force_stopped_;  // until write() has reported it
  std::optional<ShortText> pace_words_;     // message for the user while the pace is off
  bool is_pace_reported_ = false;
  int ticks_ = 0;
  std::int64_t now_ns_ = 0;
  std::int64_t tick_ns_ = 0;  // time since the previous read
  bool has_ticked_ = false;
  DeviceStatus status_;

  LatestValue<DeviceStatus> shown_;
};

/// The requests with which the guard takes every effect away, as bytes.
using LastWords = std::array<std::byte, 64>;
std::span<const std::byte> last_words(LastWords& room) noexcept;

/// Asks the controller on a connection that has no other request under way. Fails with the
/// controller's error, or if no answer comes in time. Used on the edit thread.
Result<std::string> ask_controller(ControllerLink& link, std::string_view text);

}  // namespace felt::hapticmaster
