#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/hand_script.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/driver/open_device.h"

namespace felt::desktop {

/// Setting: the id of the device that a person has chosen.
inline constexpr auto kPenDeviceKey = "devices/pen";
inline constexpr auto kPenDeviceDefault = "tablet";
/// Setting: what that device was called, for when it is not there.
inline constexpr auto kPenDeviceLabelKey = "devices/pen_label";

/// A device that can be chosen, for lists.
struct PenDeviceInfo {
  QString id;                ///< "tablet", "simulated:touch"; what the settings keep
  QString label;             ///< for people
  QString short_label = {};  ///< for the status line; empty: the label
  QString note;              ///< one sentence: what it is good for
  bool moves_hand = false;   ///< real motors: a person must switch the forces on
  /// It says where it is in a frame of its own: needs to be told where the drawing plane lies.
  bool has_own_frame = false;
  /// False: it cannot be looked for, only opening tells whether it is there.
  bool is_connected = true;
  QString serial = {};          ///< empty: unknown
  Capabilities capabilities{};  ///< as far as they are known while it is closed
};

/// A device in use: one that its user holds, or a simulated one in a simulated hand.
class PenDevice {
 public:
  /// Opened by a driver; `info` is what was known of it while it was closed.
  PenDevice(PenDeviceInfo info, std::unique_ptr<OpenDevice> device);
  PenDevice(PenDeviceInfo info, const StylusPreset& preset, const SimulatedHand& hand);
  PenDevice(const PenDevice&) = delete;
  PenDevice& operator=(const PenDevice&) = delete;
  ~PenDevice();

  [[nodiscard]] const PenDeviceInfo& info() const noexcept { return info_; }
  [[nodiscard]] OpenDevice& device() noexcept { return *device_; }
  /// The hand that mouse, tablet and keys move; null if the user holds the device.
  [[nodiscard]] HandInput* hand() noexcept { return stylus_.get(); }
  /// How that hand presses on it.
  [[nodiscard]] const HandScriptOptions& hand_options() const noexcept { return options_; }
  /// Changes name, plane and limits of the user's device, while no loop runs; does nothing for a
  /// simulated one.
  void set_profile(const DeviceProfile& profile);
  /// Returns true if a driver's device of this id is in use in any window.
  [[nodiscard]] static bool is_open(const QString& id);

 private:
  PenDeviceInfo info_;
  QString model_label_;  // without a name of the user
  std::unique_ptr<SimulatedStylus> stylus_;
  HandScriptOptions options_;
  std::unique_ptr<OpenDevice> device_;
};

/// A maker of devices: what a driver adds once, at the start of the program (DriverWatch).
struct PenDriver {
  /// What is there now. Quick: asked whenever a list is shown.
  std::function<std::vector<PenDeviceInfo>()> find;
  /// Opens one that it found. Error: says what to do.
  std::function<Result<std::unique_ptr<OpenDevice>>(const QString& id, DeviceSetup setup)> open;
};

/// Main thread, like all of these. Returns a number for remove_pen_driver.
int add_pen_driver(PenDriver driver);
void remove_pen_driver(int number);

/// All that can be chosen on this machine now: "tablet" (the pen is exactly where mouse or tablet
/// say, and forces are shown only), what drivers find, the simulated styluses.
std::vector<PenDeviceInfo> pen_devices();

/// Opens one; a driver's device keeps within what its person has set (profile_of), and one with a
/// frame of its own lies as they have shown, or as it usually does, around the middle of `page`.
/// Error: there is none of that id, it does not answer, or what is kept for it makes no sense; says
/// what to do.
Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id, const Rect& page);
/// Likewise, for a page as it is at first.
Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id);

/// The device that a person has chosen, if it is there now; else the one that is always there.
QString chosen_pen_device();

/// What is kept for a device, in a file of its own (device_profile.h) that the command line reads,
/// too. Error: names file, line and reason.
Result<DeviceProfile> profile_of(const QString& device_id);
Result<void> keep_profile(const DeviceProfile& profile);
/// Its file, for a person.
QString profile_path(const QString& device_id);
/// Where the drawing plane of a device lies; nothing where nobody has said so, or what is kept
/// makes no sense.
std::optional<PlaneCalibration> plane_of(const QString& device_id);
Result<void> keep_plane_of(const QString& device_id, const PlaneCalibration& calibration);

}  // namespace felt::desktop
