#include "desktop/engine/haptic_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "felt/rt/abandon.h"

namespace felt::desktop {
namespace {

// Number of ticks between two emissions of `due`.
constexpr int kNear = 1;
constexpr int kFar = 4;
constexpr int kResting = 16;
constexpr std::int64_t kAfterTickNs = 60'000;     // delay after which the tick is usually finished
constexpr int kMaxLateLooks = 4;                  // after kMaxLateLooks checks, wait for the next
                                                  // tick
constexpr std::int64_t kNearNs = 100'000'000;     // for this time after the pointer moved, every
                                                  // tick is read
constexpr std::int64_t kRestingNs = 500'000'000;  // after this time without motion, only every 16th
                                                  // tick is read
constexpr std::int64_t kStatusNs = 20'000'000;    // quick enough for the eye, and negligible work

/// Returns the ids of unresponsive devices of all windows.
std::vector<QString>& unresponsive_ids() {
  static std::vector<QString> ids;
  return ids;
}

std::unique_ptr<PenDevice> open_or_tablet(const QString& id) {
  Result<std::unique_ptr<PenDevice>> device = open_pen_device(id);
  if (!device) device = open_pen_device(QString::fromLatin1(kPenDeviceDefault));
  return *std::move(device);  // opening the tablet never fails
}

}  // namespace

HapticLoop::HapticLoop(const Options& options, QObject* parent)
    : QObject(parent), options_(options), device_(open_or_tablet(options.device)) {
  connect(&timer_, &TickTimer::due, this, &HapticLoop::due);
}

HapticLoop::~HapticLoop() {
  stop();
}

// --- The device

UseDevice HapticLoop::used_device() const {
  return {with_force_limit(device_->device().capabilities(), force_limit_n_)};
}

std::unique_ptr<PenDevice> HapticLoop::use_device(std::unique_ptr<PenDevice> device) {
  const bool has_stopped = stop();
  servo_.reset();  // the servo refers to the old device
  device_.swap(device);
  restart_with_device();
  return has_stopped ? std::move(device) : nullptr;
}

void HapticLoop::set_profile(const DeviceProfile& profile) {
  const bool has_stopped = stop();
  servo_.reset();
  if (has_stopped) device_->set_profile(profile);
  restart_with_device();
}

void HapticLoop::restart_with_device() {
  reported_faults_ = 0;
  reported_fault_.reset();
  reported_notice_ =
      device_->device().status().notice;  // the code that opened the device has shown this notice
  Q_EMIT device_replaced();
  start();
  Q_EMIT device_changed();
  if (unresponsive_label_.isEmpty()) return;
  Q_EMIT refused(unresponsive_text(std::exchange(unresponsive_label_, {})));
}

void HapticLoop::disconnect_device(std::unique_ptr<RealtimeThread> thread) {
  unresponsive_label_ = device_->info().label;
  unresponsive_ids().push_back(device_->info().id);
  hand_.reset();
  abandon(std::move(thread), std::move(servo_), std::move(device_),
          std::make_unique<std::vector<Kept>>(std::exchange(kept_, {})));
  device_ = open_or_tablet(QString::fromLatin1(kPenDeviceDefault));
}

bool HapticLoop::is_unresponsive(const QString& device_id) {
  const std::vector<QString>& ids = unresponsive_ids();
  return std::find(ids.begin(), ids.end(), device_id) != ids.end();
}

QString HapticLoop::unresponsive_text(const QString& device_label) {
  return tr("%1 stopped responding and was disconnected. Your drawing is safe. Restart Feltline to "
            "use it again.")
      .arg(device_label);
}

DeviceStatus HapticLoop::device_status() {
  DeviceStatus status = device_->device().status();
  if (!thread_ || status.fault) return status;
  if (!start_error_.empty()) {
    status.vendor_words = ShortText(start_error_);
  } else if (!thread_->status().is_silent) {
    return status;
  }
  status.fault = status.last_fault = DeviceFault::kOther;
  return status;
}

void HapticLoop::check_device() {
  const std::int64_t now = now_ns();
  if (now - checked_device_ns_ < kStatusNs && now >= checked_device_ns_) return;
  checked_device_ns_ = now;
  const DeviceStatus status = device_status();
  const bool is_other = status.faults != reported_faults_ || status.fault != reported_fault_ ||
                        !(status.notice == reported_notice_);
  reported_faults_ = status.faults;
  reported_fault_ = status.fault;
  reported_notice_ = status.notice;
  if (is_other) Q_EMIT device_status_changed(status);
}

// --- Forces

void HapticLoop::set_forces(bool on) {
  wake();
  if (on) {
    servo_->arm();
  } else {
    servo_->disarm();
  }
  if (std::exchange(forces_on_, on) != on) Q_EMIT forces_changed(on);
}

void HapticLoop::set_strength(double share) {
  if (std::isnan(share)) return;
  share = std::clamp(share, 0.0, 1.0);
  servo_->set_strength(share);
  if (std::exchange(strength_, share) != share) Q_EMIT strength_changed(share);
}

void HapticLoop::set_force_limit(double newton) {
  if (std::isnan(newton)) return;
  newton = std::clamp(newton, 0.0, SafetyLimits{}.peak_force_n);
  if (std::exchange(force_limit_n_, newton) == newton) return;
  if (!stop()) return restart_with_device();
  // After a fault only the user may switch forces on again. This includes a fault that the last
  // samples reported but that was not shown yet.
  const bool may_be_on = forces_on_ && servo_->latest().safety.state != SafetyState::kLatched;
  Q_EMIT force_limit_changed(newton);
  start();
  set_forces(may_be_on);
}

// --- The loop

void HapticLoop::start() {
  OpenDevice& device = device_->device();
  ServoOptions options;
  options.period_ns = device.capabilities().period_ns;
  options.limits = limits_for(device.capabilities(), force_limit_n_);
  options.queues_forces = options_.reads_forces;
  start_ns_ = now_ns();
  servo_ = std::make_unique<Servo>(device, options);
  kept_.clear();  // of the servo before
  servo_->set_strength(strength_);
  servo_->set_session_offset(start_ns_);
  last_event_ns_ = start_ns_;
  hand_.reset();
  if (HandInput* hand = device_->hand()) {
    hand_ = std::make_unique<PointerHand>(*hand, device_->hand_options(), mouse_pressure_);
  }
  is_running_ = true;
  Q_EMIT started();
  if (options_.live) {
    thread_ = std::make_unique<RealtimeThread>(
        *servo_, RealtimeOptions{.lock_memory = device_->info().moves_hand}, device.loop_host());
    start_error_.clear();
    if (const Result<void> begun = thread_->start(); !begun) {
      start_error_ = begun.error().message;
      Q_EMIT refused(QString::fromStdString(start_error_));
    }
  }
  set_forces(!device_->info().moves_hand);
}

bool HapticLoop::stop() {
  std::unique_ptr<RealtimeThread> hanging;
  std::optional<std::int64_t> end_ns;
  if (thread_) {
    const bool has_stopped = thread_->stop();
    end_ns = now_ns();  // the time after its last tick
    if (!has_stopped) hanging = std::move(thread_);
    thread_.reset();
  }
  is_running_ = false;
  Q_EMIT stopped();
  start_ns_ = end_ns.value_or(start_ns_);  // later than the last samples of the previous loop
  if (!hanging) return true;
  disconnect_device(std::move(hanging));
  return false;
}

void HapticLoop::wake() {
  last_event_ns_ = now_ns();
  if (!thread_ || !thread_->is_paused()) return;
  is_running_ = true;
  Q_EMIT started();  // emitted first, so that the next publish() comes in time for the servo
  thread_->resume();
  set_timer(next_tick_ns() + kAfterTickNs);
}

void HapticLoop::pause() {
  timer_.stop();
  if (thread_->is_paused()) return;
  thread_->pause();
  is_running_ = false;
  Q_EMIT stopped();
}

/// Returns true if the loop may pause: there was no event for rest_ns, no gesture is in progress,
/// and the device cannot move by itself, because it has neither motors nor a simulated body.
bool HapticLoop::may_pause(std::int64_t now, PenActivity activity) const {
  return thread_ && hand_ && !device_->device().capabilities().has_force() &&
         now - last_event_ns_ > options_.rest_ns && activity == PenActivity::kNone;
}

void HapticLoop::publish(const ForceModel& force, const std::shared_ptr<const void>& kept) {
  const std::uint64_t number = servo_->publish(force);
  if (kept && (kept_.empty() || kept_.back().object != kept)) kept_.push_back({kept});
  if (kept) kept_.back().number = number;
  release_unused();
  servo_->heartbeat(now_ns() - start_ns_);
}

void HapticLoop::release_unused() {
  const std::uint64_t oldest = servo_->oldest_in_use();
  std::erase_if(kept_, [oldest](const Kept& kept) { return kept.number < oldest; });
}

void HapticLoop::read_forces() {
  Servo::ForceRing* ring = servo_->for_recorder();
  if (!ring) return;
  std::array<TickForces, 256> batch;
  for (std::size_t n = 0; (n = ring->pop(batch)) > 0;) {
    for (TickForces& forces : std::span(batch).first(n)) {
      forces.time_ns += start_ns_;
      Q_EMIT forces_read(forces);
    }
  }
}

bool HapticLoop::read_samples(const std::function<void(PenSample&)>& handle) {
  if (!servo_) return false;
  std::array<PenSample, 256> batch;
  bool any = false;
  for (std::size_t n = 0; (n = servo_->for_edit().pop(batch)) > 0; any = true) {
    for (PenSample& sample : std::span(batch).first(n)) {
      sample.time_ns += start_ns_;
      handle(sample);
    }
  }
  read_forces();
  // A device that fails delivers no samples, but the change of the safety state must still be
  // reported.
  const TickReport& tick = servo_->latest();
  const bool is_other = std::exchange(reported_safety_, tick.safety.state) != tick.safety.state;
  if (any || is_other) Q_EMIT ticked(tick);
  return any;
}

/// Sets the timer to a time right after a tick, so that a sample is handled some hundred
/// microseconds after the device was read. If no samples have arrived because a tick is late, the
/// next check comes soon.
void HapticLoop::schedule(bool has_samples, PenActivity activity) {
  if (!options_.live) return;
  const std::int64_t now = now_ns();
  if (may_pause(now, activity)) return pause();
  const std::int64_t rest_ns = now - last_point_ns_;
  const bool is_near = rest_ns < kNearNs || activity == PenActivity::kContact || !hand_;
  const int ticks = is_near ? kNear : rest_ns < kRestingNs ? kFar : kResting;
  late_looks_ = has_samples || !is_near ? 0 : late_looks_ + 1;
  if (late_looks_ > 0 && late_looks_ <= kMaxLateLooks) return set_timer(now + kAfterTickNs);
  set_timer(next_tick_ns() + (ticks - 1) * servo_->options().period_ns + kAfterTickNs);
}

void HapticLoop::set_timer(std::int64_t time_ns) {
  timer_ns_ = time_ns;
  timer_.start(time_ns - now_ns());
}

void HapticLoop::step() {
  if (options_.live) return;
  virtual_ns_ += servo_->options().period_ns;
  servo_->step(virtual_ns_ - start_ns_);
}

// --- Time

std::int64_t HapticLoop::now_ns() const noexcept {
  if (!options_.live) return virtual_ns_;
  return start_ns_ + (thread_ ? thread_->now_ns() : 0);
}

std::int64_t HapticLoop::next_tick_ns() const noexcept {
  const std::int64_t now = now_ns(), period_ns = servo_->options().period_ns;
  if (!thread_) return now + period_ns;
  const std::int64_t first_ns = start_ns_ + thread_->first_due_ns();
  return now < first_ns ? first_ns : now + period_ns - (now - first_ns) % period_ns;
}

// --- The simulated hand

void HapticLoop::point(PointerEvent event, const SurfaceMaterial& surface,
                       const Capabilities& device, double absent_pressure) {
  wake();
  last_point_ns_ = now_ns();
  event.time_ns -= start_ns_;
  if (hand_) {
    hand_->set_surface(surface, device);
    hand_->set_absent_pressure(absent_pressure);
    hand_->point(event);
  }
  if (options_.live) set_timer(std::min(timer_ns_, next_tick_ns() + kAfterTickNs));
}

void HapticLoop::set_mouse_pressure(MousePressure mouse) {
  mouse_pressure_ = mouse;
  if (hand_) hand_->set_mouse(mouse);
}

}  // namespace felt::desktop
