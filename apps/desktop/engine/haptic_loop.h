#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "desktop/engine/pen_device.h"
#include "desktop/engine/tick_timer.h"
#include "felt/devices/simulated/pointer_hand.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/rt/realtime_thread.h"
#include "felt/rt/servo.h"
#include "felt/session/event.h"

namespace felt::desktop {

/// The haptic loop of a Studio: the pen device, its servo and real-time thread, the simulated hand
/// that mouse and tablet move, and the timer that says when to read samples. The loop does not
/// depend on the drawing: the Studio publishes the forces of its session here and reads the
/// samples.
///
/// If the loop is live, a real-time thread ticks the servo, and a timer emits `due` shortly after a
/// tick, when samples can be read. The timer is needed because the real-time thread wakes no other
/// thread. The timer fires after every tick while the user holds a device, the pen touches, or the
/// pointer moved in the last 0.1 s. At other times it fires after every fourth tick, or after every
/// 16th tick if the pointer has not moved for 0.5 s. If mouse or tablet move a device without
/// forces, thread and timer pause some seconds after the last event, until wake(). Use this class
/// only in Qt's main thread.
class HapticLoop : public QObject {
  Q_OBJECT

 public:
  struct Options {
    /// Id of a device of pen_devices(). If that device does not open, the tablet is used.
    QString device;
    /// If false, no thread and no timer run; step() advances the time. For tests and pictures.
    bool live = true;
    /// Time from the last event until a live loop pauses. A loop with a device that has forces, or
    /// that the user holds, never pauses.
    std::int64_t rest_ns = 3'000'000'000;
    /// If true, `forces_read` reports the forces of every tick.
    bool reads_forces = false;
  };
  /// The activity of the pen, for schedule().
  enum class PenActivity {
    kNone,     ///< the pen does nothing: the loop may pause
    kGesture,  ///< a gesture is active above the surface
    kContact,  ///< the pen touches the surface
  };

  explicit HapticLoop(const Options& options, QObject* parent = nullptr);
  ~HapticLoop() override;

  // --- The device
  [[nodiscard]] PenDevice& device() noexcept { return *device_; }
  /// Returns the device for the session, with the user's force limit.
  [[nodiscard]] UseDevice used_device() const;
  /// Replaces the device by another, which must be open and must know its position. Returns the
  /// previous device, at rest. Returns null if the previous device is unresponsive; then nothing
  /// can use it until Feltline is restarted. A gesture in progress ends as if the pen had been
  /// lifted.
  std::unique_ptr<PenDevice> use_device(std::unique_ptr<PenDevice> device);
  /// Applies another profile to the device. The loop restarts without force. If motors move the
  /// user's hand, forces are switched off.
  void set_profile(const DeviceProfile& profile);
  /// Returns the status of the device and of its loop.
  [[nodiscard]] DeviceStatus device_status();
  /// Emits device_status_changed if the status changed. Checks at most every 20 ms.
  void check_device();
  /// Returns true if a call into the vendor's library for this device did not return, so that a
  /// loop of this process had to end without waiting for it. Such a device is abandoned, together
  /// with all objects that the call may still use, and the tablet is used instead;
  /// unresponsive_text() explains this to the user.
  [[nodiscard]] static bool is_unresponsive(const QString& device_id);
  [[nodiscard]] static QString unresponsive_text(const QString& device_label);

  // --- Forces
  /// Switches forces on or off. When a loop starts, forces are on only if no motors move the user's
  /// hand.
  void set_forces(bool on);
  [[nodiscard]] bool forces_are_on() const noexcept { return forces_on_; }
  /// Sets the master strength of all forces, 0..1, which multiplies the forces of the force
  /// models. It is kept when the device changes.
  void set_strength(double share);
  [[nodiscard]] double strength() const noexcept { return strength_; }
  /// Sets the largest force that the user wants to feel, 0..SafetyLimits::peak_force_n, in N. The
  /// loop restarts without force. The session gets the limit by a UseDevice event, because the
  /// width of lines depends on the ratio of the pen's force to the limit (with_force_limit).
  void set_force_limit(double newton);
  [[nodiscard]] double force_limit() const noexcept { return force_limit_n_; }

  // --- The loop
  /// Starts the loop, without force. The Studio calls this after it has connected to the signals.
  void start();
  /// Stops the loop. Returns false if the device is unresponsive; then the servo no longer exists,
  /// and the tablet is the device.
  bool stop();
  /// Ends the pause. Call it when the user or a program does something.
  void wake();
  /// Sets the forces of the next ticks. Must be called regularly, because the servo switches the
  /// force off if the calls stop. `kept` is what the force points to, if it is not kept otherwise;
  /// it is released when no tick can use the force any more.
  void publish(const ForceModel& force, const std::shared_ptr<const void>& kept = {});
  /// Calls `handle` with each sample since the last call, in order and with times on the clock of
  /// now_ns(), and emits ticked. Returns false if no samples were waiting.
  bool read_samples(const std::function<void(PenSample&)>& handle);
  /// Sets the timer for the next `due`.
  void schedule(bool has_samples, PenActivity activity);
  /// Advances the time by one tick. Requires that the loop is not live.
  void step();
  [[nodiscard]] bool is_live() const noexcept { return options_.live; }
  /// Returns false while the loop is stopped or paused. The servo's queues must then not be used.
  [[nodiscard]] bool is_running() const noexcept { return is_running_; }
  /// Returns the newest tick.
  [[nodiscard]] const TickReport& tick() noexcept { return servo_->latest(); }
  [[nodiscard]] Servo& servo() noexcept { return *servo_; }
  /// Returns the thread, which measures the timing of the loop; null if the loop is not live.
  [[nodiscard]] RealtimeThread* thread() noexcept { return thread_.get(); }

  // --- Time
  /// Returns the time on the clock of the session, which continues when the loop restarts.
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  /// Returns the time at which the next tick is due, on the clock of now_ns(). If the loop is not
  /// live, this is one period from now.
  [[nodiscard]] std::int64_t next_tick_ns() const noexcept;
  /// Returns the time on the clock of now_ns() at which the servo's own clock was 0.
  [[nodiscard]] std::int64_t start_ns() const noexcept { return start_ns_; }

  // --- The simulated hand
  /// Moves the simulated hand as Studio::point() describes. `device` are the capabilities that the
  /// session uses; `absent_pressure` is the pressure if the pointer does not report one.
  void point(PointerEvent event, const SurfaceMaterial& surface, const Capabilities& device,
             double absent_pressure);
  /// Returns true if a pointer has moved the hand. Returns false if only a script has moved it, or
  /// if the user holds the device.
  [[nodiscard]] bool is_pointed() const noexcept { return hand_ && last_point_ns_ != 0; }
  void set_mouse_pressure(MousePressure mouse);

 Q_SIGNALS:
  /// Emitted when a loop starts or resumes. The servo's queues may be read from now on.
  void started();
  /// Emitted when the loop stopped or paused. The last samples can be read now; afterwards the
  /// servo may be destroyed. Emitted again if a paused loop stops.
  void stopped();
  /// Emitted when samples may be waiting.
  void due();
  /// Emitted for plots, in order, with each tick report that the main thread reads. The main thread
  /// does not read the report of every tick.
  void ticked(const felt::TickReport& report);
  /// Emitted for recorders, in order, with the forces of each tick, if Options::reads_forces is
  /// set. The time is on the clock of now_ns(). The sample of the tick may be reported earlier or
  /// later.
  void forces_read(const felt::TickForces& forces);
  /// Emitted while no loop runs, after the device or its profile was replaced. used_device()
  /// returns the new device.
  void device_replaced();
  /// Emitted when the loop runs again, with another device.
  void device_changed();
  /// Emitted when the faults or the notice of the device in use changed.
  void device_status_changed(const felt::DeviceStatus& status);
  void forces_changed(bool on);
  void strength_changed(double share);
  /// Emitted while no loop runs. used_device() contains the new limit.
  void force_limit_changed(double newton);
  /// Reports a sentence for the status line.
  void refused(const QString& why);

 private:
  void restart_with_device();
  void release_unused();
  void read_forces();
  void disconnect_device(std::unique_ptr<RealtimeThread> thread);
  [[nodiscard]] bool may_pause(std::int64_t now, PenActivity activity) const;
  void pause();
  void set_timer(std::int64_t time_ns);

  const Options options_;
  std::unique_ptr<PenDevice> device_;
  // What forces of the servo point to, and the number of the last of these forces.
  struct Kept {
    std::shared_ptr<const void> object;
    std::uint64_t number = 0;
  };
  std::vector<Kept> kept_;  // must outlive the servo and the thread
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<RealtimeThread> thread_;
  std::unique_ptr<PointerHand> hand_;
  MousePressure mouse_pressure_ = MousePressure::kConstant;
  TickTimer timer_;
  bool is_running_ = false;
  bool forces_on_ = false;
  double strength_ = 1.0;
  double force_limit_n_ = SafetyLimits{}.peak_force_n;
  std::int64_t virtual_ns_ = 0;     // the present time of a loop that is not live
  std::int64_t start_ns_ = 0;       // value of now_ns() when this loop started
  std::int64_t last_point_ns_ = 0;  // when a pointer last moved the hand
  std::int64_t last_event_ns_ = 0;  // time of the last wake()
  std::int64_t timer_ns_ = 0;       // when the timer fires
  int late_looks_ = 0;              // number of consecutive checks for a tick that is late
  QString unresponsive_label_;      // label of an unresponsive device that was not yet reported to
                                    // the user
  std::string start_error_;         // the reason why the loop did not start; empty if it did
  // The values that the signals reported last.
  SafetyState reported_safety_ = SafetyState::kOff;
  std::uint64_t reported_faults_ = 0;
  std::optional<DeviceFault> reported_fault_;
  ShortText reported_notice_;
  std::int64_t checked_device_ns_ = 0;
};

}  // namespace felt::desktop
