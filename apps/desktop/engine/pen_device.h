#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/hand_script.h"
#include "felt/rt/device.h"

namespace felt::desktop {

/// A device that can be chosen, for lists.
struct PenDeviceInfo {
  QString id;               ///< "tablet", "simulated:touch"; what the settings keep
  QString label;            ///< for people
  QString note;             ///< one sentence: what it is good for
  bool moves_hand = false;  ///< real motors: a person must switch the forces on
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
};

/// All that can be chosen on this machine now: "tablet" (the pen is exactly where mouse or tablet
/// say, and forces are shown only), the simulated styluses, and what drivers have found.
std::vector<PenDeviceInfo> pen_devices();

/// Opens one. Error: there is none of that id, or it does not answer; says what to do.
Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id);

}  // namespace felt::desktop
