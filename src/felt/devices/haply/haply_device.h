#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "felt/devices/haply/request_window.h"
#include "felt/devices/haply/service_messages.h"
#include "felt/devices/haply/web_socket.h"
#include "felt/driver/driver.h"
#include "felt/driver/force_gate.h"
#include "felt/driver/loop_time.h"
#include "felt/driver/service_report.h"

namespace felt::haply {

/// The result of Driver::open: the connections to the service, our device and its description.
struct Connection {
  std::unique_ptr<WebSocket> control;
  std::unique_ptr<WebSocket> events;  ///< null if the events channel does not answer
  DeviceDescriptor descriptor;
  InventoryDevice device;
  std::string grip_id;  ///< empty if the device has no grip
  int version = 0;      ///< version_number()
};

/// An Inverse3 or Minverse, used through the Inverse Service.
///
/// In each tick, one message is sent and one received: write() sends the force, and the next read()
/// receives the state that answers it. That state is one period old, so read() extrapolates its
/// position to the current time with the velocity in the state. Forces still act late (see
/// Capabilities::delay_ticks). With two messages per tick, each state would be newer, but the
/// service adds up all forces that arrive within one of its own ticks (maker's page "Control
/// Commands"). Therefore a force is sent only if the service has answered all earlier messages, and
/// only a message without force may follow an unanswered message (RequestWindow).
///
/// read() waits kWaitNs for a state. While states are late, read() repeats the last sample, and the
/// last force stays in effect for a bounded time; then the force is set to zero (ServicePace).
/// While the force is zero for this reason, write() returns kForcesOff, until the service has
/// answered promptly for a while. After kMaxHeldNs without a state read() fails with kOther, and
/// after kMaxSilentNs with kDisconnected.
///
/// Each tick also polls the events channel, without waiting. If the service reports a brake, a
/// stall, or that the force has reached the service's stability limit, the force is set to zero
/// immediately, and write() returns kForcesOff with the service's message. The same happens if a
/// state says that the device has no power.
///
/// DeviceStatus::faults counts each fault once, however many ticks it lasts.
class HaplyDevice final : public DriverDevice {
 public:
  static constexpr std::int64_t kWaitNs = 300'000;          ///< wait for a state
  static constexpr std::int64_t kFirstWaitNs = 50'000'000;  ///< wait for the first state
  static constexpr std::int64_t kSendNs = 100'000;
  static constexpr std::int64_t kMaxHeldNs = 20'000'000;
  static constexpr std::int64_t kMaxSilentNs = 1'000'000'000;
  /// After this many states in a row that show no force although a force was sent, the other name
  /// of the force vector is tried (ForceKey).
  static constexpr int kDeafStates = 200;
  static constexpr double kFeltN = 0.3;  ///< a state must show a sent force of this size or more

  explicit HaplyDevice(Connection connection);
  ~HaplyDevice() override;

  [[nodiscard]] std::string_view name() const noexcept override { return descriptor_.id; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override { return report_.shown(); }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  std::optional<Vec3> pen_axis() noexcept override { return axis_; }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return gate_.held(); }
  void stop() noexcept override;
  [[nodiscard]] Homing homing() noexcept override;
  [[nodiscard]] std::string homing_words() override;
  Result<void> find_home() override;

  [[nodiscard]] ForceKey force_key() const noexcept { return key_; }

 private:
  enum class Received : std::uint8_t { kNothing, kState, kBad, kClosed };

  bool send(const Force& force) noexcept;
  void put(const Force& force) noexcept;
  void release() noexcept;
  void wait_until(std::int64_t now_ns) noexcept;
  void take_state() noexcept;
  [[nodiscard]] std::optional<ShortText> no_force_words() const noexcept;
  Received receive(std::int64_t within_ns) noexcept;
  Received receive_all(std::int64_t within_ns) noexcept;
  void receive_events() noexcept;
  void take_event(const Event& event) noexcept;
  void check_that_force_is_received() noexcept;
  [[nodiscard]] double ahead_s(std::int64_t now_ns) const noexcept;
  void count_rate(std::int64_t now_ns) noexcept;
  tl::expected<PenSample, DeviceFault> nothing_received() noexcept;
  tl::unexpected<DeviceFault> gone(std::string_view words) noexcept;
  [[nodiscard]] std::string first_notice(bool has_events) const;

  std::unique_ptr<WebSocket> control_, events_;
  DeviceDescriptor descriptor_;
  InventoryDevice inventory_;
  std::string grip_id_;
  ForceKey key_;
  ForceGate gate_;  // its held() is the force of the newest message
  RequestWindow window_;

  // These are used by the haptic thread, or by the edit thread while no loop runs.
  State state_;
  PenSample sample_;
  std::optional<Vec3> axis_;  // axis of the grip at the time of sample_
  bool has_sample_ = false;
  bool is_calibrated_;
  bool is_gone_ = false;
  bool brake_is_on_ = false;
  bool events_are_over_ = false;
  bool has_power_;
  ShortText brake_words_, gone_words_;
  int deaf_states_ = 0;
  int keys_tried_ = 1;
  LoopTime time_;
  std::int64_t now_ns_ = 0;
  std::int64_t tick_ns_ = 0;  // time since the previous read
  std::int64_t sent_ns_ = 0;  // time of the newest message
  std::int64_t rate_since_ns_ = 0;
  std::uint64_t rate_reads_ = 0;
  std::array<char, kMaxCommand> command_{};
  ServiceReport report_;
};

}  // namespace felt::haply
