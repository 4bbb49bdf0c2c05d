#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/driver/device_profile.h"
#include "felt/driver/driver.h"
#include "felt/driver/plane_calibration.h"
#include "felt/geometry/rect.h"
#include "felt/rt/device.h"

namespace felt {

/// Options for opening a driver's device.
struct DeviceSetup {
  OpenOptions open = {};
  /// The user's settings; if they were made with another device of the same model, their planes are
  /// ignored.
  DeviceProfile profile = {};
  /// If the user has not set a plane, the driver's default plane is moved so that the centre of the
  /// reachable area is the centre of this page. Without a page the default plane is used unchanged.
  std::optional<Rect> page = {};
  /// A mutex for a driver that other threads also use. OpenDevice locks it during homing and while
  /// it closes the device.
  std::shared_ptr<std::timed_mutex> driver_lock = {};
};

/// An open device, with positions in the frame of the page and forces within the limits that the
/// user has set. The servo, the window, the command line and the device test use every device
/// through an OpenDevice.
///
/// Positions and velocities are mapped from the device's frame into the frame of the page; forces
/// are mapped back by the inverse rotation. So a movement along +z lifts the pen off the surface,
/// however the plane is tilted. Pressure, buttons, times and faults pass unchanged. If the device
/// reports the axis of the pen, read() computes the tilt as the angle between this axis and the
/// normal of the surface. Otherwise it keeps the tilt that the device reports.
///
/// read(), between(), write(), held_force() and stop() are used on the thread that Device requires,
/// and are real-time safe if the same functions of the device are. set_pen_down() may be called
/// from any thread. All other functions are used on the edit thread.
class OpenDevice final : public Device {
 public:
  /// Longest time that the destructor waits for the driver. If the driver has not returned by then,
  /// the device is abandoned (felt/rt/abandon.h).
  static constexpr std::chrono::seconds kClosePatience{3};

  /// Opens a device that the driver has found. Fails under the same conditions as Driver::open().
  static Result<std::unique_ptr<OpenDevice>> open(Driver& driver, const DeviceDescriptor& found,
                                                  const DeviceSetup& setup);
  /// Takes ownership of a device that its driver has opened. `default_plane` is the result of
  /// Driver::default_plane().
  OpenDevice(std::unique_ptr<DriverDevice> device, const PlaneCalibration& default_plane,
             const DeviceSetup& setup);
  /// Uses a device without a driver. `device` must outlive this.
  explicit OpenDevice(Device& device, const PlaneCalibration& plane = {});
  ~OpenDevice() override;

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  /// Returns the device's capabilities in the frame of the page, within the user's limits.
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  std::optional<PenSample> between() noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  [[nodiscard]] std::optional<Force> held_force() const noexcept override;
  [[nodiscard]] bool is_arm() const noexcept override { return device_.is_arm(); }
  void stop() noexcept override { device_.stop(); }

  /// Returns the mapping from the device's frame to the page's frame. It is the identity if the
  /// device already reports positions in the frame of the page.
  [[nodiscard]] const PlaneCalibration& plane() const noexcept { return plane_; }
  /// Returns the plane that is used until the user has set one.
  [[nodiscard]] const PlaneCalibration& default_plane() const noexcept { return default_plane_; }
  /// Returns the capabilities in the device's own frame, without the user's limits.
  [[nodiscard]] const Capabilities& device_capabilities() const noexcept {
    return device_.capabilities();
  }
  /// Sets the plane and the user's limits from a profile. Requires that no loop runs.
  void set_profile(DeviceProfile profile);

  // The same functions as in DriverDevice. If the device has no driver, they return the defaults of
  // DriverDevice.
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept;
  [[nodiscard]] DeviceStatus status() noexcept;
  [[nodiscard]] LoopHost* loop_host() noexcept;
  bool set_pen_down(bool is_down) noexcept;
  [[nodiscard]] Homing homing() noexcept;
  [[nodiscard]] std::string homing_words();
  Result<void> find_home();

 private:
  void map(PenSample& sample) const noexcept;

  std::unique_ptr<DriverDevice> opened_;  // null if the device has no driver
  Device& device_;
  std::shared_ptr<std::timed_mutex> driver_lock_;
  PlaneCalibration default_plane_;
  PlaneCalibration plane_;
  bool is_mapped_ = false;  // plane_ is not the identity
  Capabilities capabilities_;
};

}  // namespace felt
