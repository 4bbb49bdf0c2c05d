#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "felt/devices/forcedimension/dhd_library.h"
#include "felt/devices/forcedimension/dhd_models.h"
#include "felt/driver/driver.h"
#include "felt/driver/force_gate.h"
#include "felt/haptics/pen_sample.h"
#include "felt/rt/latest_value.h"

namespace felt::dhd {

/// An open device. Values are in the device's own axes: x towards the user, y right, z up.
///
/// The motors have three states. *Braked*: the driver switched the motors off (initially, and after
/// stop()), and their short-circuited windings damp the arm. *Live*: forces are enabled, and each
/// write() sends a force. *Taken*: the device switched the motors off by itself; read() still
/// works, and write() returns kForcesOff. If the user switched the motors off (force button, grip),
/// only the user can switch them on again. If a guard of the device switched the motors off, this
/// object enables them again. If that guard was the watchdog, it does so as soon as no force is
/// requested; otherwise, when no force has been requested for kRestNs and the arm moves slowly.
///
/// Velocities are computed here from positions, as for the simulated devices (VelocityFilter),
/// because all proofs of the forces' stability assume this filter. The library's own velocity is an
/// average over 20 ms and lags 8 ms more than the filter. Damping that uses the library's velocity
/// feels different: in the test scenarios, it displaces ink by up to 0.53 mm instead of 0.02 mm.
///
/// Each tick needs a write(), even if the force is zero, because the library compensates gravity
/// within each force command. Without force commands, the device's watchdog brakes after 31 ms.
class DhdDevice final : public DriverDevice {
 public:
  static constexpr std::int64_t kRestNs = 500'000'000;
  /// Time after a fault before the motors are enabled again.
  static constexpr std::int64_t kRetryNs = 50'000'000;
  /// The controller's state is read at each kStatusEvery-th read(), and at a read() that comes more
  /// than kGapNs after the previous read().
  static constexpr unsigned kStatusEvery = 2;
  static constexpr std::int64_t kGapNs = 5'000'000;

  /// Requires that `id` was opened with library->open(); the destructor closes it. The arm does not
  /// move, because the motors are braked.
  DhdDevice(std::shared_ptr<Library> library, Id id, DeviceDescriptor descriptor,
            const SystemType& type, std::optional<double> pen_mass_kg);
  ~DhdDevice() override;

  // Device
  [[nodiscard]] std::string_view name() const noexcept override { return descriptor_.label; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override { return gate_.held(); }

  // DriverDevice
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override;
  [[nodiscard]] Homing homing() noexcept override;
  [[nodiscard]] std::string homing_words() override;
  Result<void> find_home() override;

 private:
  enum class Motors : std::uint8_t { kBraked, kLive, kTaken };

  void set_up(std::optional<double> pen_mass_kg);
  Result<void> move_home();
  Result<void> wait_for_rest_pose();

  void look_at_status() noexcept;
  void look_whether_home(bool reset_flag) noexcept;
  void look_at_motors(const std::array<int, kStatusRoom>& status) noexcept;
  tl::expected<PenSample, DeviceFault> ask_sample() noexcept;
  [[nodiscard]] std::uint32_t ask_buttons() const noexcept;
  tl::expected<void, DeviceFault> send(const Force& force) noexcept;
  tl::expected<void, DeviceFault> enable() noexcept;
  void brake() noexcept;
  tl::expected<void, DeviceFault> write_taken(bool asks) noexcept;
  tl::expected<void, DeviceFault> write_braked(bool asks) noexcept;
  [[nodiscard]] bool may_take_back(bool asks) const noexcept;

  DeviceFault vendor_fault() noexcept;
  DeviceFault note(DeviceFault fault, std::int64_t code, std::string_view words) noexcept;
  tl::unexpected<DeviceFault> read_failed(DeviceFault fault) noexcept;
  tl::unexpected<DeviceFault> write_failed(DeviceFault fault) noexcept;
  void publish() noexcept;

  std::shared_ptr<Library> library_;
  const Api& api_;
  Id id_;
  DeviceDescriptor descriptor_;
  SystemType type_;
  ForceGate gate_;

  Motors motors_ = Motors::kBraked;
  int cause_ = kCauseNone;           // valid while taken
  std::int64_t quiet_since_ns_ = 0;  // while taken: since when no force was requested
  std::optional<std::int64_t> failed_ns_;
  std::optional<DeviceFault> read_fault_, write_fault_;
  VelocityFilter velocity_;
  std::optional<std::int64_t> placed_ns_;  // time of the last position
  double speed_mm_per_s_ = 0.0;
  bool is_home_ = false;
  bool reset_flag_at_home_ = false;
  bool is_gone_ = false;
  std::int64_t now_ns_ = 0;
  unsigned ticks_ = 0;
  DeviceStatus status_;
  LatestValue<DeviceStatus> published_;
};

}  // namespace felt::dhd
