#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "desktop/engine/cue_thread.h"
#include "desktop/engine/cue_watch.h"
#include "desktop/engine/studio.h"
#include "felt/driver/cue_device.h"
#include "felt/driver/driver.h"

namespace felt::desktop {

/// Setting: the id of the cue device that a person has chosen; empty: none, as at first. Once
/// chosen it plays whenever it is there.
inline constexpr auto kCueDeviceKey = "devices/cue";

/// A haptic pen, mouse, touchpad or game controller, for lists.
struct CueDeviceInfo {
  QString id;     ///< what the setting keeps
  QString label;  ///< for people
};

/// Those that are there now. Some ms. To choose one: Settings::the().set(kCueDeviceKey, id).
std::vector<CueDeviceInfo> cue_devices();
/// Another driver to look at, beside those of make_drivers(): for tests. The number undoes it.
int add_cue_driver(std::shared_ptr<Driver> driver);
void remove_cue_driver(int number);

/// Lets the chosen cue device follow a drawing: humming while the pen rubs, ticks when it touches,
/// when a tool takes hold, when an end snaps. One per window. Follows the setting, and looks for a
/// chosen device that is not there every two seconds, for one that does not open more and more
/// seldom. Silent while forces are switched off, and as
/// much weaker as they are. Qt's main thread.
class CuePlayer : public QObject {
  Q_OBJECT

 public:
  explicit CuePlayer(Studio& studio, QObject* parent = nullptr);
  ~CuePlayer() override;

  /// What plays now; empty: nothing.
  [[nodiscard]] QString in_use() const;
  /// Opens it, closing what was open; empty closes. False: it does not open; `refused` says why.
  /// Does not change the setting.
  bool use(const QString& id);

 Q_SIGNALS:
  /// Another one plays, or none.
  void changed();
  /// A sentence for the status line.
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
  int opened_ = 0;  // devices so far
  QTimer idle_;     // no tick for a while: whoever hums stops
  QTimer again_;    // looks for what is not there, or did not open
  struct {
    QString words;  // that were said
    int tries = 0;
  } refusal_;
};

}  // namespace felt::desktop
