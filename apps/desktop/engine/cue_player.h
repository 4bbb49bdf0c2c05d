#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "desktop/engine/cue_thread.h"
#include "desktop/engine/studio.h"
#include "felt/driver/cue_device.h"
#include "felt/driver/driver.h"
#include "felt/session/cue_watch.h"

namespace felt::desktop {

/// Setting: the id of the cue device that the user has chosen, or empty (the default) if the user
/// has chosen none. The chosen device plays whenever it is connected.
inline constexpr auto kCueDeviceKey = "devices/cue";

/// A haptic pen, mouse, touchpad or game controller, as shown in lists.
struct CueDeviceInfo {
  QString id;     ///< stored in the setting
  QString label;  ///< for the user
};

/// Returns the devices that are connected now. Takes some ms. To choose a device, call
/// Settings::the().set(kCueDeviceKey, id).
std::vector<CueDeviceInfo> cue_devices();
/// Adds a driver to the drivers of make_drivers(), for tests. Returns a number for
/// remove_cue_driver().
int add_cue_driver(std::shared_ptr<Driver> driver);
void remove_cue_driver(int number);

/// Plays cues of a drawing on the chosen device: a hum while the pen rubs, and ticks when the pen
/// touches, when a tool grabs something and when an end snaps. Each window has one player, which
/// follows the setting. If the chosen device is not connected, the player searches for it every two
/// seconds; if the device does not open, the player retries at growing intervals. The strength of
/// the forces also scales the cues, and no cues are played while forces are off. Use this class in
/// Qt's main thread.
class CuePlayer : public QObject {
  Q_OBJECT

 public:
  explicit CuePlayer(Studio& studio, QObject* parent = nullptr);
  ~CuePlayer() override;

  /// Returns the id of the device that is open now, or an empty string.
  [[nodiscard]] QString in_use() const;
  /// Closes the present device. Then opens the device `id`, unless `id` is empty. Returns false if
  /// the device does not open; then `refused` says why. Does not change the setting.
  bool use(const QString& id);

 Q_SIGNALS:
  /// Emitted when a device was opened or closed.
  void changed();
  /// Reports a sentence for the status line.
  void refused(const QString& why);

 private:
  void follow_setting();
  void look_again();
  void forget_refusal();
  void take(const TickReport& tick);
  void fall_silent();
  void lose(int which);
  [[nodiscard]] CueFeel feel() const;

  Studio& studio_;
  std::unique_ptr<CueThread> player_;
  CueLaw law_;
  CueWatch watch_;
  std::int64_t last_look_ns_ = 0;
  bool is_silent_ = true;
  int opened_ = 0;  // number of devices opened so far
  QTimer idle_;     // single shot after the last tick: stops the hum
  QTimer again_;    // searches for a device that is missing or did not open
  struct {
    QString words;  // the last words that were emitted
    int tries = 0;
  } refusal_;
};

}  // namespace felt::desktop
