#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>

#include "desktop/devices/device_notice.h"
#include "desktop/engine/driver_watch.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Looks after the device of a window: uses what a person chooses, with all that it needs first;
/// when it fails lets them draw on, says what happened, and brings it back.
///
/// A device that cannot be read any more is let go: what was being drawn is kept as it was up to
/// then, mouse and tablet draw from there on, and the device is waited for. When it is plugged in
/// again it is used again by itself, once nothing is being drawn, provided that nobody must do
/// anything for it: forces are off then until a person switches them on, and begin from zero. Where
/// it must find its home first, or cannot be looked for without opening it, a button does it. A
/// device that only takes no force stays in use.
class DeviceCare : public QObject {
  Q_OBJECT

 public:
  static constexpr int kCalmMs = 200;      ///< between looks whether the pen is up
  static constexpr int kPatienceMs = 500;  ///< a fault that may pass is waited out

  /// Of this window; `notice` is where it says what happens.
  DeviceCare(Studio& studio, DeviceNotice& notice, QWidget* window);
  ~DeviceCare() override;

  /// A person wants this device: opens it, brings it home, keeps the choice. False: not now; what
  /// is in use stays, and the notice says why. `parent` is for dialogs.
  bool use(const QString& id, QWidget* parent);
  /// As its person calls it, else its maker.
  [[nodiscard]] QString name_of(const QString& id) const;
  /// The device that is waited for; empty: none.
  [[nodiscard]] const QString& waits_for() const noexcept { return waits_for_; }

 Q_SIGNALS:
  void waiting_changed();

 private:
  void hear();
  void let_go(DeviceFault fault, const DeviceStatus& status);
  void say_no_force(DeviceFault fault, const DeviceStatus& status);
  void say_notice(const DeviceStatus& status);
  void wait_for(const QString& id);
  void stop_waiting();
  void look();
  void come_back();
  bool open(const QString& id, QWidget* parent, bool may_ask);
  void say(const QString& text, const QString& details, std::vector<DeviceMessage::Button> buttons,
           bool is_fault);
  [[nodiscard]] bool is_calm() const;
  [[nodiscard]] DeviceMessage::Button use_button(const QString& text, const QString& id);
  [[nodiscard]] DeviceMessage::Button forces_button();

  Studio& studio_;
  QPointer<DeviceNotice> notice_;
  QPointer<QWidget> window_;
  std::unique_ptr<DriverWatch::Watching> watching_;
  QString waits_for_;
  bool has_failed_ = false;  // it did not open: not by itself again before it was unplugged
  QElapsedTimer since_back_;
  QTimer calm_;
  QTimer patience_;
  std::optional<DeviceFault> said_;
  ShortText said_notice_;
  std::uint64_t reads_ = 0;  // when the fault came
};

}  // namespace felt::desktop
