#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "desktop/engine/pen_device.h"
#include "felt/driver/driver.h"

namespace felt::desktop {

/// What one maker's driver says about this machine.
struct DriverFindings {
  QString label;  ///< "3D Systems (OpenHaptics)"
  std::vector<Finding> findings;
};

/// The drivers of real devices, as a maker of pens: knows what is plugged in, and opens it.
///
/// Nothing is looked for but while somebody wants to know (`Watching`: a list is shown, a lost
/// device is waited for), once a second then, on a thread of its own: a library that takes its time
/// holds up no window. Drivers are asked one thing at a time; opening waits for a look that is
/// under way, kPatienceMs at most. A driver whose library has not answered for `stuck_ms` is given
/// up, and the others are looked at without it; so is its device, when it is closed (OpenDevice).
/// One per process, made before the first window. Main thread.
class DriverWatch : public QObject {
  Q_OBJECT

 public:
  static constexpr int kLookMs = 1000;
  static constexpr int kPatienceMs = 3000;
  static constexpr int kStuckMs = 60'000;  ///< longer than any way home takes

  explicit DriverWatch(std::vector<std::unique_ptr<Driver>> drivers, QObject* parent = nullptr,
                       int stuck_ms = kStuckMs);
  ~DriverWatch() override;
  /// The one there is, or null.
  static DriverWatch* the() noexcept;

  /// The force devices, as of the last look.
  [[nodiscard]] const std::vector<PenDeviceInfo>& found() const noexcept { return found_; }
  /// The ids and names of what plays waveforms, likewise (cue_player.h opens them).
  [[nodiscard]] const std::vector<std::pair<QString, QString>>& found_cues() const noexcept {
    return cues_;
  }
  [[nodiscard]] const PenDeviceInfo* find(const QString& id) const noexcept;
  /// One of its drivers makes devices with such ids, plugged in or not.
  [[nodiscard]] bool knows(const QString& id) const noexcept;
  /// True once it has been looked for the first time.
  [[nodiscard]] bool has_looked() const noexcept { return has_looked_; }
  /// Looks now, once; `looked` follows.
  void look();
  /// Asks all drivers what is there and what is missing, on its thread; answers on the main one,
  /// unless `asker` is gone by then.
  void diagnose(QObject* asker, std::function<void(std::vector<DriverFindings>)> answer);

  /// While one of these lives, devices are looked for.
  class Watching {
   public:
    Watching();
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;
    ~Watching();
  };

 Q_SIGNALS:
  /// found() or found_cues() is not what it was.
  void changed();
  /// A look is over, whatever it saw.
  void looked();

 private:
  struct Slot;
  struct Looking;

  Result<std::unique_ptr<OpenDevice>> open(const QString& id, DeviceSetup setup);
  [[nodiscard]] std::shared_ptr<Slot> slot_of(const QString& id) const noexcept;
  void take(std::vector<DeviceDescriptor> found);
  void set_pace();
  void begin_looking();
  void give_up_looking();

  std::vector<std::shared_ptr<Slot>> slots_;
  std::vector<DeviceDescriptor> descriptors_;
  std::vector<PenDeviceInfo> found_;
  std::vector<std::pair<QString, QString>> cues_;
  std::unique_ptr<QThreadPool> looker_;
  std::shared_ptr<Looking> looking_;
  QElapsedTimer since_look_;
  int stuck_ms_;
  QTimer timer_;
  bool is_looking_ = false;
  bool has_looked_ = false;
  int pens_ = 0;  // number of add_pen_driver
};

}  // namespace felt::desktop
