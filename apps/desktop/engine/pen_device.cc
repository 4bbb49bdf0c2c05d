#include "desktop/engine/pen_device.h"

#include <QCoreApplication>
#include <QStandardPaths>
#include <algorithm>
#include <cstring>
#include <utility>

#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"
#include "felt/document/page.h"

namespace felt::desktop {
namespace {

/// Half the size of the workspace, in mm. It is so large that the device reaches every point of
/// the page.
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

/// Returns the ids of the drivers' devices that are open in any window.
std::vector<QString>& open_ids() {
  static std::vector<QString> ids;
  return ids;
}

/// Returns the short name that users know: "Touch" for "3D Systems Touch (Phantom Omni)".
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
        "PenDevice", "The ink follows the pen exactly. Forces are shown, not felt.");
    return info;
  }
  info.id = kSimulated + text_of(preset.name);
  // Product names are not translated.
  static_cast<void>(QT_TRANSLATE_NOOP("PenDevice", "Worst case: light, frictionless, coarse"));
  const QString label = QCoreApplication::translate("PenDevice", preset.label.data());
  info.label = QCoreApplication::translate("PenDevice", "Simulated: %1").arg(label);
  info.short_label = QCoreApplication::translate("PenDevice", "Simulated %1").arg(model_of(label));
  info.note = QCoreApplication::translate(
      "PenDevice",
      "Mouse or pen move a simulated hand that holds this stylus. Forces move the ink, so that you "
      "see what they would feel like.");
  return info;
}

/// Returns whether the list of devices contains the preset. Of the presets without forces, only the
/// tablet's is listed, because users who draw with mouse and tablet do not want to choose, and a
/// pen without pressure draws the same with either preset. A very heavy stylus is not listed,
/// because a quick press of the mouse would end before its pen has come down, and leave no ink.
bool is_offered(const StylusPreset& preset) {
  constexpr double kHeavyKg = 1.0;
  const bool is_light = preset.mechanics.mass_kg < kHeavyKg;
  return (preset.capabilities.has_force() && is_light) || preset.name == kTablet;
}

Result<std::unique_ptr<PenDevice>> open_simulated(const PenDeviceInfo& info, StylusPreset preset) {
  Capabilities& can = preset.capabilities;
  can.workspace_min.x = can.workspace_min.y = -kEndlessMm;
  can.workspace_max.x = can.workspace_max.y = kEndlessMm;
  return std::make_unique<PenDevice>(info, preset, typical_hand());
}

Result<std::unique_ptr<PenDevice>> open_of(const PenDriver& driver, const PenDeviceInfo& info,
                                           const Rect& page) {
  const Result<DeviceProfile> profile = profile_of(info.id);
  if (!profile) return tl::unexpected(profile.error());
  Result<std::unique_ptr<OpenDevice>> opened =
      driver.open(info.id, {.open = {.pen_begins_down = false}, .page = page});
  if (!opened) return tl::unexpected(opened.error());
  auto pen = std::make_unique<PenDevice>(info, *std::move(opened));
  pen->set_profile(*profile);
  return pen;
}

std::string profiles_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation).toStdString() +
         "/feltline/devices";
}

}  // namespace

PenDevice::PenDevice(PenDeviceInfo info, std::unique_ptr<OpenDevice> device)
    : info_(std::move(info)), device_(std::move(device)) {
  // Some drivers report more once the device is open.
  const DeviceDescriptor& opened = device_->descriptor();
  info_.capabilities = device_->device_capabilities();
  info_.moves_hand = info_.capabilities.has_force();
  if (!opened.serial.empty()) info_.serial = text_of(opened.serial);
  if (!opened.label.empty()) info_.label = text_of(opened.label);
  model_label_ = info_.label;
  open_ids().push_back(info_.id);
}

PenDevice::PenDevice(PenDeviceInfo info, const StylusPreset& preset, const SimulatedHand& hand)
    : info_(std::move(info)),
      stylus_(std::make_unique<SimulatedStylus>(preset, hand)),
      options_(script_options_for(preset, hand)),
      device_(std::make_unique<OpenDevice>(*stylus_)) {}

PenDevice::~PenDevice() {
  if (stylus_) return;
  const auto at = std::find(open_ids().begin(), open_ids().end(), info_.id);
  if (at != open_ids().end()) open_ids().erase(at);
}

void PenDevice::set_profile(const DeviceProfile& profile) {
  if (stylus_) return;
  const QString name = text_of(profile.name);
  info_.label = name.isEmpty() ? model_label_ : name;
  info_.short_label = name;
  device_->set_profile(profile);
}

bool PenDevice::is_open(const QString& id) {
  return std::find(open_ids().begin(), open_ids().end(), id) != open_ids().end();
}

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
    const bool is_listed = is_offered(preset) && preset.name != kTablet;  // the tablet is the first
    if (is_listed) devices.push_back(info_of(preset));
  }
  // The device that is the worst case for forces is listed last, because nobody should choose it
  // first.
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
  return open_pen_device(id, Page{}.area());
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
