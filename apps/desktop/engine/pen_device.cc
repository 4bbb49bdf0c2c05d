#include "desktop/engine/pen_device.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "desktop/engine/settings.h"
#include "felt/devices/calibrated/calibrated_device.h"
#include "felt/devices/simulated/simulated_stylus.h"

namespace felt::desktop {
namespace {

/// Half the workspace, in mm: the device reaches every place of the sheet.
constexpr double kEndlessMm = 1e10;
constexpr auto kTablet = "tablet";
constexpr auto kSimulated = "simulated:";
constexpr qsizetype kPlaneNumbers = 12;

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

/// A person's device with the drawing plane where that person has it.
class CalibratedPen final : public PenDevice {
 public:
  CalibratedPen(std::unique_ptr<PenDevice> pen, const PlaneCalibration& calibration)
      : pen_(std::move(pen)), device_(pen_->device(), calibration) {}

  [[nodiscard]] const PenDeviceInfo& info() const noexcept override { return pen_->info(); }
  [[nodiscard]] Device& device() noexcept override { return device_; }
  [[nodiscard]] HandInput* hand() noexcept override { return nullptr; }
  [[nodiscard]] const HandScriptOptions& hand_options() const noexcept override {
    return pen_->hand_options();
  }
  [[nodiscard]] PlaneCalibration calibration() const noexcept override {
    return device_.calibration();
  }

 private:
  std::unique_ptr<PenDevice> pen_;
  CalibratedDevice device_;
};

QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

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
    info.label = QCoreApplication::translate("PenDevice", "Pen or mouse, exact");
    info.note = QCoreApplication::translate(
        "PenDevice", "The ink is exactly where the pen is. Forces are shown, not felt.");
    return info;
  }
  info.id = kSimulated + text_of(preset.name);
  const QString label = text_of(preset.label);
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

Result<std::unique_ptr<PenDevice>> open_of(const PenDriver& driver, const PenDeviceInfo& info) {
  Result<std::unique_ptr<PenDevice>> opened = driver.open(info.id);
  if (!opened || !info.has_own_frame) return opened;
  const std::optional<PlaneCalibration> plane = plane_of(info.id);
  if (!plane) return opened;
  return std::make_unique<CalibratedPen>(*std::move(opened), *plane);
}

QString plane_key(const QString& device_id) {
  return QStringLiteral("devices/plane/") + device_id;
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

Result<std::unique_ptr<PenDevice>> open_pen_device(const QString& id) {
  for (const AddedDriver& added : drivers()) {
    for (const PenDeviceInfo& info : added.driver.find()) {
      if (info.id == id) return open_of(added.driver, info);
    }
  }
  for (const StylusPreset& preset : stylus_presets()) {
    const PenDeviceInfo info = info_of(preset);
    if (is_offered(preset) && info.id == id) return open_simulated(info, preset);
  }
  return fail(ErrorCode::kNotFound, "there is no pen device \"" + id.toStdString() +
                                        "\" now: is it plugged in and switched on?");
}

QString chosen_pen_device() {
  const QString fallback = QString::fromLatin1(kPenDeviceDefault);
  const QString chosen = Settings::the().text(QString::fromLatin1(kPenDeviceKey), fallback);
  const std::vector<PenDeviceInfo> devices = pen_devices();
  const bool is_there = std::any_of(devices.begin(), devices.end(),
                                    [&](const PenDeviceInfo& info) { return info.id == chosen; });
  return is_there ? chosen : fallback;
}

std::optional<PlaneCalibration> plane_of(const QString& device_id) {
  const QStringList words = Settings::the().text(plane_key(device_id)).split(QLatin1Char(' '));
  if (words.size() != kPlaneNumbers) return std::nullopt;
  std::array<Vec3, 4> v{};
  for (qsizetype i = 0; i < kPlaneNumbers; ++i) {
    bool ok = false;
    const double number = words[i].toDouble(&ok);
    if (!ok) return std::nullopt;
    Vec3& to = v[static_cast<std::size_t>(i / 3)];
    (i % 3 == 0 ? to.x : i % 3 == 1 ? to.y : to.z) = number;
  }
  return PlaneCalibration::from({v[0], v[1], v[2]}, v[3]);
}

void keep_plane_of(const QString& device_id, const PlaneCalibration& calibration) {
  QStringList words;
  const auto add = [&words](const Vec3& v) {
    for (const double number : {v.x, v.y, v.z}) words << QString::number(number, 'g', 17);
  };
  for (const Vec3& row : calibration.rows()) add(row);
  add(calibration.offset());
  Settings::the().set(plane_key(device_id), words.join(QLatin1Char(' ')));
}

}  // namespace felt::desktop
