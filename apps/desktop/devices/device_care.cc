#include "desktop/devices/device_care.h"

#include <QApplication>
#include <algorithm>
#include <utility>

#include "desktop/devices/homing_dialog.h"
#include "desktop/engine/device_words.h"
#include "desktop/engine/settings.h"
#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

/// A device that fails again within kSteadyMs after an automatic reconnection is not reconnected
/// again.
constexpr qint64 kSteadyMs = 5000;

/// Returns true if, after this fault, the pen cannot be read or its position is unknown.
bool ends_reading(DeviceFault fault) {
  return fault == DeviceFault::kDisconnected;
}

bool takes_no_force(DeviceFault fault) {
  return fault == DeviceFault::kForcesOff || fault == DeviceFault::kOverheated;
}

}  // namespace

DeviceCare::DeviceCare(Studio& studio, DeviceNotice& notice, QWidget* window)
    : QObject(window), studio_(studio), notice_(&notice), window_(window) {
  calm_.setInterval(kCalmMs);
  patience_.setSingleShot(true);
  patience_.setInterval(kPatienceMs);
  connect(&calm_, &QTimer::timeout, this, &DeviceCare::come_back);
  connect(&patience_, &QTimer::timeout, this, [this] {
    const DeviceStatus status = studio_.loop().device_status();
    if (!status.fault) return;
    if (status.reads == reads_) return release(*status.fault, status);
    say_no_force(*status.fault, status);
  });
  // Queued, because the signal may be emitted while painting, when a device must not be replaced.
  connect(&studio_.loop(), &HapticLoop::device_status_changed, this, &DeviceCare::receive,
          Qt::QueuedConnection);
  connect(&studio_.loop(), &HapticLoop::device_changed, this, [this] {
    patience_.stop();
    said_.reset();
  });
  connect(&studio_.loop(), &HapticLoop::forces_changed, this, [this](bool on) {
    said_.reset();
    if (on && notice_ && studio_.loop().device().info().moves_hand) notice_->hide();
  });
  DriverWatch* watch = DriverWatch::the();
  if (!watch) return;
  connect(watch, &DriverWatch::looked, this, &DeviceCare::look);
  const QString chosen = Settings::the().text(QString::fromLatin1(kPenDeviceKey));
  if (watch->knows(chosen) && chosen != studio_.loop().device().info().id) wait_for(chosen);
}

DeviceCare::~DeviceCare() = default;

bool DeviceCare::use(const QString& id, QWidget* parent) {
  const DriverWatch* watch = DriverWatch::the();
  const bool is_of_driver = watch && watch->knows(id);
  if (id != studio_.loop().device().info().id) {
    if (is_of_driver ? !open(id, parent, true) : !studio_.use_device(id)) return false;
  }
  stop_waiting();
  Settings::the().set(QString::fromLatin1(kPenDeviceKey), id);
  Settings::the().set(QString::fromLatin1(kPenDeviceLabelKey),
                      studio_.loop().device().info().label);
  return true;
}

/// Handles the present status, because the status in the signal may be outdated.
void DeviceCare::receive() {
  const DeviceStatus status = studio_.loop().device_status();
  if (status.fault && ends_reading(*status.fault)) return release(*status.fault, status);
  if (status.fault && !takes_no_force(*status.fault)) {
    if (patience_.isActive()) return;
    reads_ = status.reads;
    return patience_.start();
  }
  patience_.stop();
  // While forces are off, the device does not refuse any, so the status no longer contains the
  // fault. Therefore the last fault is checked.
  if (status.last_fault && takes_no_force(*status.last_fault)) {
    say_no_force(*status.last_fault, status);
  }
  if (!status.fault) say_notice(status);
}

/// Shows each notice once, such as a flat battery or a service that has stopped sending events.
void DeviceCare::say_notice(const DeviceStatus& status) {
  if (std::exchange(said_notice_, status.notice) == status.notice || status.notice.empty()) return;
  const PenDeviceInfo info = studio_.loop().device().info();
  std::vector<DeviceMessage::Button> buttons;
  if (info.moves_hand && !studio_.loop().forces_are_on()) buttons.push_back(forces_button());
  say(tr("Message from %1: %2").arg(info.label, text_of(status.notice.view())), {},
      std::move(buttons), false);
}

void DeviceCare::release(DeviceFault fault, const DeviceStatus& status) {
  const PenDeviceInfo info = studio_.loop().device().info();
  if (studio_.loop().device().hand()) return;  // a simulated device cannot be plugged in again
  const DeviceWords words = words_for(fault, info.label, status, false);
  // Ends the gesture as if the pen had been lifted, and closes the device.
  if (!studio_.use_device(QString::fromLatin1(kPenDeviceDefault))) return;
  if (HapticLoop::is_unresponsive(info.id)) {
    return say(HapticLoop::unresponsive_text(info.label), words.details, {}, true);
  }
  const bool is_unsteady = since_back_.isValid() && since_back_.elapsed() < kSteadyMs;
  wait_for(info.id);
  has_failed_ = is_unsteady || fault != DeviceFault::kDisconnected;
  QString text = words.what + QLatin1Char(' ');
  // The reason may be urgent, for example a machine that did not switch off.
  if (fault == DeviceFault::kNotCalibrated && !words.details.isEmpty()) {
    text += words.details + QLatin1Char(' ');
  }
  text += words.to_do;
  std::vector<DeviceMessage::Button> buttons;
  if (fault == DeviceFault::kNotCalibrated) {
    buttons.push_back(use_button(tr("Find its &home position…"), info.id));
  } else if (has_failed_ || !info.is_connected) {
    buttons.push_back(use_button(tr("&Use it again"), info.id));
  } else {
    text +=
        QLatin1Char(' ') + tr("When you connect it again it is used again, with its forces off.");
  }
  say(text, words.details, std::move(buttons), true);
}

void DeviceCare::say_no_force(DeviceFault fault, const DeviceStatus& status) {
  if (std::exchange(said_, fault) == fault) return;
  const DeviceWords words = words_for(fault, studio_.loop().device().info().label, status, true);
  say(words.what + QLatin1Char(' ') + words.to_do, words.details, {forces_button()}, true);
}

void DeviceCare::wait_for(const QString& id) {
  waits_for_ = id;
  has_failed_ = false;
  if (DriverWatch::the()) watching_ = std::make_unique<DriverWatch::Watching>();
  Q_EMIT waiting_changed();
}

void DeviceCare::stop_waiting() {
  calm_.stop();
  watching_.reset();
  if (!std::exchange(waits_for_, QString()).isEmpty()) Q_EMIT waiting_changed();
}

void DeviceCare::look() {
  if (waits_for_.isEmpty()) return;
  const PenDeviceInfo* seen = DriverWatch::the()->find(waits_for_);
  // When the device was unplugged, an earlier failure no longer counts.
  if (!seen) has_failed_ = false;
  if (!seen || !seen->is_connected || has_failed_ || PenDevice::is_open(waits_for_)) {
    return calm_.stop();
  }
  if (!calm_.isActive()) calm_.start();
}

bool DeviceCare::is_calm() const {
  return !studio_.session().gesture_in_progress() && !in_contact(studio_.pen().sample) &&
         QGuiApplication::mouseButtons() == Qt::NoButton && !QApplication::activeModalWidget();
}

void DeviceCare::come_back() {
  if (!is_calm()) return;
  calm_.stop();
  if (open(waits_for_, nullptr, false)) since_back_.start();
}

bool DeviceCare::open(const QString& id, QWidget* parent, bool may_ask) {
  const QString name = name_of(id);
  if (HapticLoop::is_unresponsive(id)) {
    if (may_ask) say(HapticLoop::unresponsive_text(name), {}, {}, true);
    return false;
  }
  if (PenDevice::is_open(id)) {
    if (may_ask) say(tr("%1 is in use in another window.").arg(name), {}, {}, true);
    return false;
  }
  if (may_ask) QApplication::setOverrideCursor(Qt::WaitCursor);
  Result<std::unique_ptr<PenDevice>> device = open_pen_device(id, studio_.page().area());
  if (may_ask) QApplication::restoreOverrideCursor();
  if (!device) {
    has_failed_ = true;
    say(tr("%1 cannot be opened.").arg(name), text_of(device.error()),
        {use_button(tr("&Try again"), id)}, true);
    return false;
  }
  if ((*device)->device().homing() != Homing::kNone && !may_ask) {
    has_failed_ = true;
    say(tr("%1 is connected. It must find its home position before you can use it.").arg(name), {},
        {use_button(tr("Find its &home position…"), id)}, false);
    return false;
  }
  if (!HomingDialog::bring_home(**device, parent ? parent : window_.data())) return false;
  const bool moves_hand = (*device)->info().moves_hand;
  const DeviceStatus status = (*device)->device().status();
  studio_.loop().use_device(*std::move(device));
  stop_waiting();
  said_notice_ = {};
  if (moves_hand) {
    said_notice_ = status.notice;
    say(tr("%1 is in use. Its forces are off until you switch them on.").arg(name),
        text_of(status.notice.view()), {forces_button()}, false);
  }
  say_notice(status);
  return true;
}

void DeviceCare::say(const QString& text, const QString& details,
                     std::vector<DeviceMessage::Button> buttons, bool is_fault) {
  if (notice_) notice_->say({is_fault, text, details, std::move(buttons)});
}

DeviceMessage::Button DeviceCare::use_button(const QString& text, const QString& id) {
  return {text, [this, id] { use(id, window_); }};
}

DeviceMessage::Button DeviceCare::forces_button() {
  return {tr("Switch &forces on"), [this] { studio_.loop().set_forces(true); }};
}

QString DeviceCare::name_of(const QString& id) const {
  const Result<DeviceProfile> profile = profile_of(id);
  if (profile && !profile->name.empty()) return QString::fromStdString(profile->name);
  const DriverWatch* watch = DriverWatch::the();
  const PenDeviceInfo* info = watch ? watch->find(id) : nullptr;
  if (info) return info->label;
  const Settings& settings = Settings::the();
  const bool is_chosen = settings.text(QString::fromLatin1(kPenDeviceKey)) == id;
  const QString label =
      is_chosen ? settings.text(QString::fromLatin1(kPenDeviceLabelKey)) : QString();
  return label.isEmpty() ? id : label;
}

}  // namespace felt::desktop
