#include "desktop/engine/pen_device.h"

#include <QCoreApplication>
#include <QStandardPaths>
#include <algorithm>
#include <cstring>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/document/sheet_page.h"
#include "felt/driver/calibrated_device.h"

namespace felt::desktop {
namespace {

/// Half the workspace, in mm: the device reaches every place of the sheet.
constexpr double kEndlessMm = 1e10;
constexpr auto kTablet = "tablet";
constexpr auto kSimulated = "simulated:";

struct AddedDriver {
  int number;
  PenDriver driver;
};

std::vector<AddedDriver>& drivers() {
  static std::vector<AddedDriver> added;
  return added;
}

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

/// A person's device with the drawing plane where that person has it, and with their limits. One
/// without a frame of its own has no plane to be set: where it says it is, it is.
class CalibratedPen final : public PenDevice {
 public:
  CalibratedPen(std::unique_ptr<PenDevice> pen, const DeviceProfile& profile,
                const PlaneCalibration& usual)
      : pen_(std::move(pen)), usual_(usual) {
    take(profile);
  }

  [[nodiscard]] const PenDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] Device& device() noexcept override { return *device_; }
  [[nodiscard]] HandInput* hand() noexcept override { return nullptr; }
  [[nodiscard]] const HandScriptOptions& hand_options() const noexcept override {
    return pen_->hand_options();
  }
  [[nodiscard]] PlaneCalibration calibration() const noexcept override {
    return device_->calibration();
  }
  void follow(const DeviceProfile& profile) override { take(profile); }
  [[nodiscard]] DeviceStatus status() noexcept override { return pen_->status(); }
  bool set_pen_down(bool is_down) noexcept override { return pen_->set_pen_down(is_down); }
  [[nodiscard]] LoopHost* loop_host() noexcept override { return pen_->loop_host(); }
  [[nodiscard]] Homing homing() noexcept override { return pen_->homing(); }
  [[nodiscard]] QString homing_words() override { return pen_->homing_words(); }
  Result<void> find_home() override { return pen_->find_home(); }

 private:
  void take(const DeviceProfile& profile) {
    info_ = pen_->info();
    if (!profile.name.empty()) info_.label = info_.short_label = text_of(profile.name);
    DeviceProfile ours = profile;
    if (info_.has_own_frame) {
      // Another one of its kind stands somewhere else, and pushes like this one.
      forget_planes_of_another(ours, info_.serial.toStdString());
    } else {
      ours.plane.reset();
    }
    device_.emplace(pen_->device(), ours, usual_);
  }

  std::unique_ptr<PenDevice> pen_;
  PenDeviceInfo info_;
  PlaneCalibration usual_;
  std::optional<CalibratedDevice> device_;  // always there
};

/// "3D Systems Touch (Phantom Omni)" is "Touch" to those who have one.
QString model_of(QString label) {
  label = label.section(QLatin1String(" ("), 0, 0).section(QLatin1Char(':'), 0, 0);
  for (const char* maker : {"3D Systems ", "Novint ", "Force Dimension ", "Haply "}) {
    if (label.startsWith(QLatin1String(maker))) label.remove(0, qsizetype(std::strlen(maker)));
  }
  return label;
}

PenDeviceInfo info_of(const StylusPreset& preset) {
  PenDeviceInfo info;
  info.capabilities = preset.capabilities;
  if (!preset.capabilities.has_force()) {
    info.id = text_of(preset.name);
    info.label = QCoreApplication::translate("PenDevice", "Mouse or pen, without forces");
    info.short_label = QCoreApplication::translate("PenDevice", "Mouse or pen");
    info.note = QCoreApplication::translate(
        "PenDevice", "The ink is exactly where the pen is. Forces are shown, not felt.");
    return info;
  }
  info.id = kSimulated + text_of(preset.name);
  // Names of products stay as they are.
  static_cast<void>(QT_TRANSLATE_NOOP("PenDevice", "Worst case: light, frictionless, coarse"));
  const QString label = QCoreApplication::translate("PenDevice", preset.label.data());
  info.label = QCoreApplication::translate("PenDevice", "Simulated: %1").arg(label);
  info.short_label = QCoreApplication::translate("PenDevice", "Simulated %1").arg(model_of(label));
  info.note = QCoreApplication::translate(
      "PenDevice",
      "Mouse or pen lead a simulated hand that holds this stylus. Forces move the ink, so that you "
      "see what it would feel like.");
  return info;
}

/// Of mouse and tablet only one is offered: whoever draws with both does not want to choose, and a
/// pen without pressure draws the same with either.
bool is_offered(const StylusPreset& preset) {
  return preset.capabilities.has_force() || preset.name == kTablet;
}

Result<std::unique_ptr<PenDevice>> open_simulated(const PenDeviceInfo& info, StylusPreset preset) {
  Capabilities& can = preset.capabilities;
  can.workspace_min.x = can.workspace_min.y = -kEndlessMm;
  can.workspace_max.x = can.workspace_max.y = kEndlessMm;
  return std::make_unique<SimulatedPen>(info, preset, typical_hand());
}

Result<std::unique_ptr<PenDevice>> open_of(const PenDriver& driver, const PenDeviceInfo& info,
                                           const Rect& page) {
  const Result<DeviceProfile> profile = profile_of(info.id);
  if (!profile) return tl::unexpected(profile.error());
  Result<std::unique_ptr<PenDevice>> opened = driver.open(info.id, {.pen_begins_down = false});
  if (!opened) return opened;
  const PenDeviceInfo& now = (*opened)->info();
  const PlaneCalibration usual =
      now.has_own_frame
          ? fit_to_page(now.default_plane,
                        reach_of(now.default_plane, (*opened)->device().capabilities()), page, 1.0)
          : PlaneCalibration{};
  return std::make_unique<CalibratedPen>(*std::move(opened), *profile, usual);
}

std::string profiles_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation).toStdString() +
         "/feltline/devices";
}

}  // namespace

int add_pen_driver(PenDriver driver) {
  static int number = 0;
  drivers().push_back({++number, std::move(driver)});
  return number;
}

void remove_pen_driver(int number) {
  std::erase_if(drivers(), [number](const AddedDriver& added) { return added.number == number; });
}

std::vector<PenDeviceInfo> pen_devices() {
  std::vector<PenDeviceInfo> devices{info_of(*find_stylus_preset(kTablet))};
  for (const AddedDriver& added : drivers()) {
    for (PenDeviceInfo& info : added.driver.find()) devices.push_back(std::move(info));
  }
  for (const StylusPreset& preset : stylus_presets()) {
    if (preset.capabilities.has_force()) devices.push_back(info_of(preset));
  }
  // The one that is there to be hard on forces is nobody's first choice.
  std::stable_partition(devices.begin(), devices.end(), [](const PenDeviceInfo& info) {
    return info.id != QLatin1String("simulated:worst");
  });
  return devices;
}

Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id, const Rect& page) {
  for (const AddedDriver& added : drivers()) {
    for (const PenDeviceInfo& info : added.driver.find()) {
      if (info.id == id) return open_of(added.driver, info, page);
    }
  }
  for (const StylusPreset& preset : stylus_presets()) {
    const PenDeviceInfo info = info_of(preset);
    if (is_offered(preset) && info.id == id) return open_simulated(info, preset);
  }
  return fail(ErrorCode::kNotFound, "there is no pen device \"" + id.toStdString() +
                                        "\" now: is it plugged in and switched on?");
}

Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id) {
  return open_pen_device(id, SheetPage{}.area());
}

QString chosen_pen_device() {
  const QString fallback = QString::fromLatin1(kPenDeviceDefault);
  const QString chosen = Settings::the().text(QString::fromLatin1(kPenDeviceKey), fallback);
  const std::vector<PenDeviceInfo> devices = pen_devices();
  const bool is_there = std::any_of(devices.begin(), devices.end(),
                                    [&](const PenDeviceInfo& info) { return info.id == chosen; });
  return is_there ? chosen : fallback;
}

Result<DeviceProfile> profile_of(const QString& device_id) {
  return load_device_profile(profiles_folder(), device_id.toStdString());
}

Result<void> keep_profile(const DeviceProfile& profile) {
  return save_device_profile(profiles_folder(), profile);
}

QString profile_path(const QString& device_id) {
  return QString::fromStdString(device_profile_path(profiles_folder(), device_id.toStdString()));
}

std::optional<PlaneCalibration> plane_of(const QString& device_id) {
  const Result<DeviceProfile> profile = profile_of(device_id);
  return profile ? profile->plane : std::nullopt;
}

Result<void> keep_plane_of(const QString& device_id, const PlaneCalibration& calibration) {
  Result<DeviceProfile> profile = profile_of(device_id);
  if (!profile) return tl::unexpected(profile.error());
  profile->plane = calibration;
  return keep_profile(*profile);
}

}  // namespace felt::desktop
