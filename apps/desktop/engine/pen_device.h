#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/driver/open_device.h"

namespace felt::desktop {

/// Setting: the id of the device that the user has chosen.
inline constexpr auto kPenDeviceKey = "devices/pen";
inline constexpr auto kPenDeviceDefault = "tablet";
/// Setting: the label of that device, used while it is not connected.
inline constexpr auto kPenDeviceLabelKey = "devices/pen_label";

/// A device that can be chosen, as shown in lists.
struct PenDeviceInfo {
  QString id;                ///< "tablet", "simulated:touch"; stored in the settings
  QString label;             ///< for the user
  QString short_label = {};  ///< for the status line; if empty, the label is used
  QString note;              ///< one sentence on its use
  bool moves_hand = false;   ///< true if the device has real motors: the user must switch the
                             ///< forces on
  /// True if the device reports its position in its own coordinate frame, so that the position of
  /// the drawing plane must be calibrated.
  bool has_own_frame = false;
  /// False if the program must open the device to find out whether it is connected.
  bool is_connected = true;
  QString serial = {};          ///< empty if the serial number is unknown
  Capabilities capabilities{};  ///< as far as they are known before the device is opened
};

/// A device in use: either a real device that the user holds, or a simulated device in a simulated
/// hand.
class PenDevice {
 public:
  /// `device` was opened by a driver; `info` is the description from before the device was opened.
  PenDevice(PenDeviceInfo info, std::unique_ptr<OpenDevice> device);
  PenDevice(PenDeviceInfo info, const StylusPreset& preset, const SimulatedHand& hand);
  PenDevice(const PenDevice&) = delete;
  PenDevice& operator=(const PenDevice&) = delete;
  ~PenDevice();

  [[nodiscard]] const PenDeviceInfo& info() const noexcept { return info_; }
  [[nodiscard]] OpenDevice& device() noexcept { return *device_; }
  /// Returns the hand that mouse, tablet and keys move; null if the user holds the device.
  [[nodiscard]] HandInput* hand() noexcept { return stylus_.get(); }
  /// Returns how the simulated hand presses on the device.
  [[nodiscard]] const HandScriptOptions& hand_options() const noexcept { return options_; }
  /// Changes name, plane and limits of a device that the user holds. Requires that no loop runs.
  /// Does nothing for a simulated device.
  void set_profile(const DeviceProfile& profile);
  /// Returns true if any window uses a device with this id that a driver opened.
  [[nodiscard]] static bool is_open(const QString& id);

 private:
  PenDeviceInfo info_;
  QString model_label_;  // without the user's own name
  std::unique_ptr<SimulatedStylus> stylus_;
  HandScriptOptions options_;
  std::unique_ptr<OpenDevice> device_;
};

/// A source of devices, added once when the program starts (DriverWatch).
struct PenDriver {
  /// Returns the devices that are connected now. Must be quick, because it is called whenever a
  /// list is shown.
  std::function<std::vector<PenDeviceInfo>()> find;
  /// Opens a device that `find` returned. The error says what to do.
  std::function<Result<std::unique_ptr<OpenDevice>>(const QString& id, DeviceSetup setup)> open;
};

/// Adds a driver. Returns a number for remove_pen_driver. Call all functions here in the main
/// thread.
int add_pen_driver(PenDriver driver);
void remove_pen_driver(int number);

/// Returns all devices that can be chosen on this machine now: "tablet", the devices that drivers
/// find, and the simulated styluses. With the device "tablet", the pen is exactly at the position
/// that mouse or tablet report, and forces are only shown on the screen.
std::vector<PenDeviceInfo> pen_devices();

/// Opens a device. A driver's device respects the user's limits (profile_of). A device with its own
/// frame uses the plane that the user calibrated, or otherwise its default plane around the middle
/// of `page`. Fails if no device has that id, if the device does not answer, or if its stored
/// profile is invalid; the error says what to do.
Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id, const Rect& page);
/// Does the same, with the page of a new drawing as `page`.
Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id);

/// Returns the device that the user has chosen if it is connected; otherwise "tablet", which is
/// always available.
QString chosen_pen_device();

/// Reads the profile of a device from its own file (device_profile.h), which the command line tool
/// also reads. The error names file, line and reason.
Result<DeviceProfile> profile_of(const QString& device_id);
Result<void> keep_profile(const DeviceProfile& profile);
/// Returns the path of the device's profile, as shown to the user.
QString profile_path(const QString& device_id);
/// Returns the drawing plane of a device, or nullopt if it was not calibrated or the stored plane
/// is invalid.
std::optional<PlaneCalibration> plane_of(const QString& device_id);
Result<void> keep_plane_of(const QString& device_id, const PlaneCalibration& calibration);

}  // namespace felt::desktop
