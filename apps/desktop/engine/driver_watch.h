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

/// The findings of one vendor's driver on this machine.
struct DriverFindings {
  QString label;  ///< "3D Systems (OpenHaptics)"
  std::vector<Finding> findings;
};

/// The drivers of real devices. Finds the devices that are plugged in, and opens them (PenDriver).
///
/// Looks for devices only while a `Watching` exists (a list is shown, or a device was lost):
/// once a second, on its own thread, so that a slow library blocks no window. Drivers are used by
/// one call at a time; opening waits for a running search, at most kPatienceMs. A driver whose
/// library has not answered for `stuck_ms` is no longer used, and the search continues without it;
/// a device whose library hangs when it is closed is disconnected as well (OpenDevice). One per
/// process, made before the first window. Main thread.
class DriverWatch : public QObject {
  Q_OBJECT

 public:
  static constexpr int kLookMs = 1000;
  static constexpr int kPatienceMs = 3000;
  static constexpr int kStuckMs = 60'000;  ///< longer than any homing takes

  explicit DriverWatch(std::vector<std::unique_ptr<Driver>> drivers, QObject* parent = nullptr,
                       int stuck_ms = kStuckMs);
  ~DriverWatch() override;
  /// Returns the one of this process, or null.
  static DriverWatch* the() noexcept;

  /// Returns the force devices that the last search found.
  [[nodiscard]] const std::vector<PenDeviceInfo>& found() const noexcept { return found_; }
  /// Returns the ids and names of the devices that play waveforms, from the last search
  /// (cue_player.h opens them).
  [[nodiscard]] const std::vector<std::pair<QString, QString>>& found_cues() const noexcept {
    return cues_;
  }
  [[nodiscard]] const PenDeviceInfo* find(const QString& id) const noexcept;
  /// Returns true if one of its drivers makes devices with such ids, plugged in or not.
  [[nodiscard]] bool knows(const QString& id) const noexcept;
  /// Returns true once the first search is finished.
  [[nodiscard]] bool has_looked() const noexcept { return has_looked_; }
  /// Starts one search now; `looked` reports its end.
  void look();
  /// Asks all drivers, on the search thread, what is connected and what is missing. Calls `answer`
  /// on the main thread, unless `asker` is gone by then.
  void diagnose(QObject* asker, std::function<void(std::vector<DriverFindings>)> answer);

  /// Devices are searched for while one of these exists.
  class Watching {
   public:
    Watching();
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;
    ~Watching();
  };

 Q_SIGNALS:
  /// found() or found_cues() changed.
  void changed();
  /// A search has ended, with or without a change.
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
  int pens_ = 0;  // returned by add_pen_driver
};

}  // namespace felt::desktop
