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

/// The diagnosis of one vendor's driver on this machine.
struct DriverFindings {
  QString label;  ///< "3D Systems (OpenHaptics)"
  std::vector<Finding> findings;
};

/// Manages the drivers of real devices: finds the devices that are plugged in, and opens them
/// (PenDriver).
///
/// It searches for devices only while a `Watching` object exists: while a list of devices is shown,
/// or while the program waits for a lost device. Meanwhile, a search starts once a second, on a
/// separate thread, so that a slow library does not block a window. Each driver is used by only one
/// call at a time; opening a device therefore waits for a running call of its driver, but at most
/// kPatienceMs. If the library of a driver has not answered for `stuck_ms`, that driver is no
/// longer used, and the search continues without it. If a library hangs while the program closes a
/// device, that device is treated as disconnected, too (OpenDevice). Each process has one
/// DriverWatch, which is made before the first window. Use it in the main thread.
class DriverWatch : public QObject {
  Q_OBJECT

 public:
  static constexpr int kLookMs = 1000;
  static constexpr int kPatienceMs = 3000;
  static constexpr int kStuckMs = 60'000;  ///< longer than any homing

  explicit DriverWatch(std::vector<std::unique_ptr<Driver>> drivers, QObject* parent = nullptr,
                       int stuck_ms = kStuckMs);
  ~DriverWatch() override;
  /// Returns the DriverWatch of this process, or null.
  static DriverWatch* the() noexcept;

  /// Returns the force devices that the last search found.
  [[nodiscard]] const std::vector<PenDeviceInfo>& found() const noexcept { return found_; }
  /// Returns the ids and names of the cue devices that the last search found. A CuePlayer opens
  /// them.
  [[nodiscard]] const std::vector<std::pair<QString, QString>>& found_cues() const noexcept {
    return cues_;
  }
  [[nodiscard]] const PenDeviceInfo* find(const QString& id) const noexcept;
  /// Returns true if the id belongs to one of the drivers, even if that device is not plugged in.
  [[nodiscard]] bool knows(const QString& id) const noexcept;
  /// Returns true once the first search is finished.
  [[nodiscard]] bool has_looked() const noexcept { return has_looked_; }
  /// Starts one search now; `looked` is emitted when it ends.
  void look();
  /// Asks all drivers, on the search thread, what is connected and what is missing. Calls `answer`
  /// on the main thread, unless `asker` was destroyed meanwhile.
  void diagnose(QObject* asker, std::function<void(std::vector<DriverFindings>)> answer);

  /// Devices are searched for while at least one object of this class exists.
  class Watching {
   public:
    Watching();
    Watching(const Watching&) = delete;
    Watching& operator=(const Watching&) = delete;
    ~Watching();
  };

 Q_SIGNALS:
  /// Emitted when found() or found_cues() changed.
  void changed();
  /// Emitted when a search has ended, even if nothing changed.
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
  int pens_ = 0;  // the number that add_pen_driver returned
};

}  // namespace felt::desktop
