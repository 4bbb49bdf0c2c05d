#include "desktop/engine/pen_device.h"

#include <QCoreApplication>

#include "felt/devices/simulated/simulated_stylus.h"

namespace felt::desktop {
namespace {

/// Half the workspace, in mm: the device reaches every place of the sheet.
constexpr double kEndlessMm = 1e10;
constexpr auto kSimulated = "simulated:";

/// A stylus that exists as equations only, in a simulated hand; or, without motors, a pen that is
/// exactly where the hand aims.
class SimulatedPen final : public PenDevice {
 public:
  SimulatedPen(PenDeviceInfo info, const StylusPreset& preset, const SimulatedHand& hand)
      : info_(std::move(info)), stylus_(preset, hand), options_(script_options_for(preset, hand)) {}

  [[nodiscard]] const PenDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Device& device() noexcept override { return stylus_; }
  [[nodiscard]] HandInput* hand() noexcept override { return &stylus_; }
  [[nodiscard]] const HandScriptOptions& hand_options() const noexcept override { return options_; }

 private:
  PenDeviceInfo info_;
  SimulatedStylus stylus_;
  HandScriptOptions options_;
};

PenDeviceInfo info_of(const StylusPreset& preset) {
  const QString name = QString::fromUtf8(preset.name.data(), int(preset.name.size()));
  const QString label = QString::fromUtf8(preset.label.data(), int(preset.label.size()));
  if (!preset.capabilities.has_force()) {
    return {name, label,
            QCoreApplication::translate("PenDevice",
                                        "The ink is exactly where the pen is; forces are shown."),
            false};
  }
  return {kSimulated + name, QCoreApplication::translate("PenDevice", "Simulated: %1").arg(label),
          QCoreApplication::translate(
              "PenDevice", "A simulated stylus in a simulated hand; forces move the pen."),
          false};
}

}  // namespace

std::vector<PenDeviceInfo> pen_devices() {
  std::vector<PenDeviceInfo> devices;
  for (const StylusPreset& preset : stylus_presets()) devices.push_back(info_of(preset));
  return devices;
}

Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id) {
  for (const StylusPreset& known : stylus_presets()) {
    PenDeviceInfo info = info_of(known);
    if (info.id != id) continue;
    StylusPreset preset = known;
    Capabilities& can = preset.capabilities;
    can.workspace_min.x = can.workspace_min.y = -kEndlessMm;
    can.workspace_max.x = can.workspace_max.y = kEndlessMm;
    return std::make_unique<SimulatedPen>(std::move(info), preset, typical_hand());
  }
  return fail(ErrorCode::kNotFound, "there is no pen device \"" + id.toStdString() + "\"");
}

}  // namespace felt::desktop
