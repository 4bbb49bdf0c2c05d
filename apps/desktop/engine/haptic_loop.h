#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "desktop/engine/pen_device.h"
#include "desktop/engine/tick_timer.h"
#include "felt/devices/simulated/pointer_hand.h"
#include "felt/haptics/safety/safety_limits.h"
#include "felt/rt/realtime_thread.h"
#include "felt/rt/servo.h"
#include "felt/session/event.h"

namespace felt::desktop {

/// The haptic loop of a Studio: the pen device, its servo and real-time thread, the simulated hand
/// that mouse and tablet lead, and the timer that says when samples may be read. It does not depend
/// on the drawing; the Studio publishes the forces of its session here and reads the samples.
///
/// If live, a real-time thread ticks the servo. `due` is emitted right after each tick while the
/// pen is near, after every fourth tick if it was moved a while ago, otherwise after every 16th; a
/// timer does this, because the real-time thread wakes no other thread. If no motors push, thread
/// and timer pause some seconds after the last event, until wake(). Qt's main thread only.
class HapticLoop : public QObject {
  Q_OBJECT

 public:
  struct Options {
    /// Id of a device of pen_devices(). If it does not open, the tablet is used.
    QString device;
    /// False: no thread and no timer; step() moves the time. For tests and pictures.
    bool live = true;
    /// Time from the last event to the pause of a live loop whose device has no motors.
    std::int64_t rest_ns = 3'000'000'000;
  };
  /// The activity of the pen, for schedule().
  enum class PenActivity {
    kNone,     ///< nothing: the loop may pause
    kGesture,  ///< a gesture is active above the surface
    kContact,  ///< the pen touches the surface
  };

  explicit HapticLoop(const Options& options, QObject* parent = nullptr);
  ~HapticLoop() override;

  // --- The device
  [[nodiscard]] PenDevice& device() noexcept { return *device_; }
  /// Returns the device as the session sees it, within the user's force limit.
  [[nodiscard]] UseDevice used_device() const;
  /// Replaces the device by one that is open and knows its position. Returns the previous one, at
  /// rest, or null if that is unresponsive, because then nothing can use it until Feltline is
  /// restarted. A gesture ends as if the pen had been lifted.
  std::unique_ptr<PenDevice> use_device(std::unique_ptr<PenDevice> device);
  /// Applies another profile to the device. The loop restarts without force, and if motors move the
  /// user's hand, forces are off.
  void set_profile(const DeviceProfile& profile);
  /// Returns the status of the device, and of its loop.
  [[nodiscard]] DeviceStatus device_status();
  /// Emits device_status_changed if the status changed. Checks at most every 20 ms.
  void check_device();
  /// Returns true if this device, in any loop, did not return from its vendor's call when its loop
  /// was to end. It is then disconnected, together with everything that the call may still use, and
  /// the tablet is used instead; unresponsive_text() says so to the user.
  [[nodiscard]] static bool is_unresponsive(const QString& device_id);
  [[nodiscard]] static QString unresponsive_text(const QString& device_label);

  // --- Forces
  /// Switches forces on or off. They start on if no motors move the user's hand.
  void set_forces(bool on);
  [[nodiscard]] bool forces_are_on() const noexcept { return forces_on_; }
  /// Master strength of all forces, 0..1, which multiplies what the force models ask for. It is
  /// kept when the device changes.
  void set_strength(double share);
  [[nodiscard]] double strength() const noexcept { return strength_; }
  /// Sets the largest force that the user wants to feel, 0..SafetyLimits::peak_force_n, in N. The
  /// loop restarts without force, and the session gets the limit with UseDevice, because the width
  /// follows the push within the limit (with_force_limit).
  void set_force_limit(double newton);
  [[nodiscard]] double force_limit() const noexcept { return force_limit_n_; }

  // --- The loop
  /// Starts the loop, without force. The Studio calls this after it has connected to the signals.
  void start();
  /// Stops the loop. Returns false if the device is unresponsive: then there is no servo any more,
  /// and the tablet is the device.
  bool stop();
  /// Ends the pause because the user or a program does something.
  void wake();
  /// Sets the forces of the next ticks. Also serves as the sign of life: without it the servo ends
  /// the force.
  void publish(const ForceModel& force);
  /// Calls `handle` with each sample since the last call, in order, on the clock of now_ns(), and
  /// emits ticked. Returns false if there were none.
  bool read_samples(const std::function<void(PenSample&)>& handle);
  /// Sets the timer for the next `due`.
  void schedule(bool has_samples, PenActivity activity);
  /// Advances the time by one tick. Requires that the loop is not live.
  void step();
  [[nodiscard]] bool is_live() const noexcept { return options_.live; }
  /// False while it is stopped or paused: then its servo's queues must not be used.
  [[nodiscard]] bool is_running() const noexcept { return is_running_; }
  /// Returns the newest tick.
  [[nodiscard]] const TickReport& tick() noexcept { return servo_->latest(); }
  [[nodiscard]] Servo& servo() noexcept { return *servo_; }
  /// Returns the thread, which measures the timing of the loop; null if not live.
  [[nodiscard]] RealtimeThread* thread() noexcept { return thread_.get(); }

  // --- Time
  /// Returns the time on the clock of the session, which goes on when the loop restarts.
  [[nodiscard]] std::int64_t now_ns() const noexcept;
  /// Returns when the next tick is due, on that clock; a period from now if not live.
  [[nodiscard]] std::int64_t next_tick_ns() const noexcept;
  /// Returns the time on that clock at which the servo's own clock was 0.
  [[nodiscard]] std::int64_t start_ns() const noexcept { return start_ns_; }

  // --- The simulated hand
  /// Moves the hand: Studio::point(). `device` is the device as the session sees it;
  /// `absent_pressure` is used if a hand does not sense pressure.
  void point(PointerEvent event, const SurfaceMaterial& surface, const Capabilities& device,
             double absent_pressure);
  /// Returns true if a pointer leads the hand; otherwise a script does, or the user holds the
  /// device.
  [[nodiscard]] bool is_pointed() const noexcept { return hand_ && last_point_ns_ != 0; }
  void set_mouse_pressure(MousePressure mouse);

 Q_SIGNALS:
  /// A loop starts or resumes: its servo's queues may be read now.
  void started();
  /// The loop stopped or paused: the last samples can be read now, and the servo may be destroyed
  /// afterwards. Emitted again if a paused loop stops.
  void stopped();
  /// Samples may wait to be read.
  void due();
  /// Every tick report that the main thread saw, in order, but not of every tick: for plots.
  void ticked(const felt::TickReport& report);
  /// Another device, or another profile of it, while no loop runs: used_device() is new.
  void device_replaced();
  /// The loop of another device runs.
  void device_changed();
  /// The faults or the notice of the device in use changed.
  void device_status_changed(const felt::DeviceStatus& status);
  void forces_changed(bool on);
  void strength_changed(double share);
  /// While no loop runs: used_device() is new.
  void force_limit_changed(double newton);
  /// A sentence for the status line.
  void refused(const QString& why);

 private:
  void restart_with_device();
  void disconnect_device(std::unique_ptr<RealtimeThread> thread);
  [[nodiscard]] bool may_pause(std::int64_t now, PenActivity activity) const;
  void pause();
  void set_timer(std::int64_t time_ns);

  const Options options_;
  std::unique_ptr<PenDevice> device_;
  std::unique_ptr<Servo> servo_;
  std::unique_ptr<RealtimeThread> thread_;
  std::unique_ptr<PointerHand> hand_;
  MousePressure mouse_pressure_ = MousePressure::kConstant;
  TickTimer timer_;
  bool is_running_ = false;
  bool forces_on_ = false;
  double strength_ = 1.0;
  double force_limit_n_ = SafetyLimits{}.peak_force_n;
  std::int64_t virtual_ns_ = 0;     // not live
  std::int64_t start_ns_ = 0;       // what now_ns() was when this loop started
  std::int64_t last_point_ns_ = 0;  // when a pointer last led the hand
  std::int64_t last_event_ns_ = 0;  // last wake()
  std::int64_t timer_ns_ = 0;       // when the timer fires
  int late_looks_ = 0;              // checks in a row for a tick that is late
  QString unresponsive_label_;      // of a device, until it was reported to the user
  std::string start_error_;         // why the loop does not run
  // What the signals reported last.
  SafetyState reported_safety_ = SafetyState::kOff;
  std::uint64_t reported_faults_ = 0;
  std::optional<DeviceFault> reported_fault_;
  ShortText reported_notice_;
  std::int64_t checked_device_ns_ = 0;
};

}  // namespace felt::desktop
