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

/// One open device. In its own axes: x towards the person, y right, z up.
///
/// The motors are in one of three states. *Braked*: we let them go (at first, and after stop());
/// the arm is damped by its own windings. *Live*: forces are enabled, each write() is one. *Taken*:
/// the device switched them off by itself; it is read on, write() says kForcesOff. What a person
/// took (force button, grip), a person gives back. After its own guards we ask for them again:
/// after its watchdog as soon as nothing is asked of it, after the others when nothing was asked
/// for kRestNs and the arm is slow.
///
/// Velocities are made here, from places, as the simulated devices make theirs (VelocityFilter):
/// all that is proven of the forces' stability is proven with that. The library's own is the mean
/// of 20 ms, 8 ms later, and damping by it another feel (ink up to 0.53 mm elsewhere in the
/// scenarios, instead of 0.02 mm).
///
/// Gravity is compensated by the library within each force command, so that it needs a write() each
/// tick, be it of zero; without one the device's watchdog brakes after 31 ms.
class DhdDevice final : public DriverDevice {
 public:
  static constexpr std::int64_t kRestNs = 500'000'000;
  /// After a fault the motors are not asked for again before this.
  static constexpr std::int64_t kRetryNs = 50'000'000;
  /// The state of the controller is asked for at each n-th read, and after a gap this long.
  static constexpr unsigned kStatusEvery = 2;
  static constexpr std::int64_t kGapNs = 5'000'000;

  /// `id` was opened with library->open(), and is closed with this. Nothing moves: the motors are
  /// braked.
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
  int cause_ = kCauseNone;           // while taken
  std::int64_t quiet_since_ns_ = 0;  // while taken: nothing was asked since
  std::optional<std::int64_t> failed_ns_;
  std::optional<DeviceFault> read_fault_, write_fault_;
  VelocityFilter velocity_;
  std::optional<std::int64_t> placed_ns_;  // time of its last place
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
