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

/// Manages the device of a window: opens the device that the user chooses, and homes it if needed.
/// If the device fails, reports the fault, lets the user continue to draw, and reconnects the
/// device later.
///
/// A device that can no longer be read is closed: the gesture is ended and committed, mouse and
/// tablet replace the device, and the program waits until the device is plugged in again. After
/// that, the device is used again automatically as soon as the user is not drawing. If the device
/// needs homing, or can be found only by opening it, the user must press a button instead. After a
/// reconnection, forces are off until the user switches them on, and rise from zero. A device that
/// can be read but refuses forces stays in use.
class DeviceCare : public QObject {
  Q_OBJECT

 public:
  static constexpr int kCalmMs = 200;  ///< interval at which the program checks whether the pen
                                       ///< is lifted
  /// Delay before a fault that may clear itself is handled. A machine that is not ready any more
  /// needs up to half a second until it has confirmed that it is off; meanwhile it must be read.
  static constexpr int kPatienceMs = 700;

  /// Manages the device of this studio; `notice` shows the messages.
  DeviceCare(Studio& studio, DeviceNotice& notice, QWidget* window);
  ~DeviceCare() override;

  /// Opens the device that the user has chosen, homes it, and stores the choice. Returns false if
  /// that fails; then the previous device stays in use, and the notice says why. `parent` is the
  /// parent of the dialogs.
  bool use(const QString& id, QWidget* parent);
  /// Returns the user's name for the device, or the vendor's if the user gave it no name.
  [[nodiscard]] QString name_of(const QString& id) const;
  /// Returns the id of the device that the program waits for; empty if it does not wait.
  [[nodiscard]] const QString& waits_for() const noexcept { return waits_for_; }

 Q_SIGNALS:
  void waiting_changed();

 private:
  void receive();
  void release(DeviceFault fault, const DeviceStatus& status);
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
  bool has_failed_ = false;  // the device failed or did not open: do not retry until it has
                             // been unplugged
  QElapsedTimer since_back_;
  QTimer calm_;
  QTimer patience_;
  std::optional<DeviceFault> said_;
  ShortText said_notice_;
  std::uint64_t reads_ = 0;  // number of reads when the fault occurred
};

}  // namespace felt::desktop
