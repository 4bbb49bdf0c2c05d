#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/calibrated/plane_calibration.h"
#include "felt/devices/simulated/hand_script.h"
#include "felt/rt/device.h"

namespace felt::desktop {

/// Setting: the id of the device that a person has chosen.
inline constexpr auto kPenDeviceKey = "devices/pen";
inline constexpr auto kPenDeviceDefault = "tablet";

/// A device that can be chosen, for lists.
struct PenDeviceInfo {
  QString id;                ///< "tablet", "simulated:touch"; what the settings keep
  QString label;             ///< for people
  QString short_label = {};  ///< for the status line; empty: the label
  QString note;              ///< one sentence: what it is good for
  bool moves_hand = false;   ///< real motors: a person must switch the forces on
  /// It says where it is in a frame of its own: needs to be told where the drawing plane lies.
  bool has_own_frame = false;
  Capabilities capabilities{};  ///< as far as they are known while it is closed
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
};

/// A maker of devices: what a driver adds once, at the start of the program.
struct PenDriver {
  /// What is there now. Quick: asked whenever a list is shown.
  std::function<std::vector<PenDeviceInfo>()> find;
  /// Opens one that it found, in the device's own frame. Error: says what to do.
  std::function<Result<std::unique_ptr<PenDevice>>(const QString& id)> open;
};

/// Main thread, like all of these. Returns a number for remove_pen_driver.
int add_pen_driver(PenDriver driver);
void remove_pen_driver(int number);

/// All that can be chosen on this machine now: "tablet" (the pen is exactly where mouse or tablet
/// say, and forces are shown only), what drivers find, the simulated styluses.
std::vector<PenDeviceInfo> pen_devices();

/// Opens one; a device with a frame of its own is seen through its calibration, if it has one.
/// Error: there is none of that id, or it does not answer; says what to do.
Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id);

/// The device that a person has chosen, if it is there now; else the one that is always there.
QString chosen_pen_device();

/// Where the drawing plane of a device lies, as kept in the settings; nothing where nobody has said
/// so, or what is kept makes no sense.
std::optional<PlaneCalibration> plane_of(const QString& device_id);
void keep_plane_of(const QString& device_id, const PlaneCalibration& calibration);

}  // namespace felt::desktop
