#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/hand_script.h"
#include "felt/driver/device_profile.h"
#include "felt/driver/driver.h"
#include "felt/rt/device.h"

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
  /// Where its drawing plane usually lies, until a person has shown it.
  PlaneCalibration default_plane{};
};

/// A device in use, and what drives it where no person holds it.
class PenDevice {
 public:
  virtual ~PenDevice() = default;
  [[nodiscard]] virtual const PenDeviceInfo& info() const noexcept = 0;
  [[nodiscard]] virtual Device& device() noexcept = 0;
  /// The hand that mouse, tablet and keys lead; null where a person holds the device.
  [[nodiscard]] virtual HandInput* hand() noexcept = 0;
  /// How that hand presses on it.
  [[nodiscard]] virtual const HandScriptOptions& hand_options() const noexcept = 0;
  /// Through which device()'s places come from its own frame.
  [[nodiscard]] virtual PlaneCalibration calibration() const noexcept { return {}; }
  /// Seen through another profile from now on, and within its limits; while no loop runs. Nothing
  /// where no driver's device is in use.
  virtual void follow(const DeviceProfile& profile) { static_cast<void>(profile); }
  /// How it is, with its maker's words: DriverDevice::status().
  [[nodiscard]] virtual DeviceStatus status() noexcept { return {}; }
  /// Its pen touches, or lifts, since a key says so: DriverDevice::set_pen_down(). False: it knows
  /// by itself.
  virtual bool set_pen_down(bool is_down) noexcept {
    static_cast<void>(is_down);
    return false;
  }
  /// The maker's loop that must run it; null: ours does.
  [[nodiscard]] virtual LoopHost* loop_host() noexcept { return nullptr; }
  /// What it needs before it can be read, while no loop runs: DriverDevice::homing().
  [[nodiscard]] virtual Homing homing() noexcept { return Homing::kNone; }
  [[nodiscard]] virtual QString homing_words() { return {}; }
  /// Blocks, some seconds at most; any one thread while no loop runs.
  virtual Result<void> find_home() { return {}; }
};

/// A maker of devices: what a driver adds once, at the start of the program (DriverWatch).
struct PenDriver {
  /// What is there now. Quick: asked whenever a list is shown.
  std::function<std::vector<PenDeviceInfo>()> find;
  /// Opens one that it found, in the device's own frame. Error: says what to do.
  std::function<Result<std::unique_ptr<PenDevice>>(const QString& id, const OpenOptions& options)>
      open;
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
