// The device of a studio and its loop: how they begin and end, and how the device is doing.
#include <algorithm>
#include <cmath>
#include <utility>

#include "desktop/engine/studio.h"

#include "felt/rt/abandon.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kStatusNs = 20'000'000;  // between two looks at the device's state

/// Of devices that hung, over all windows.
std::vector<QString>& given_up_ids() {
  static std::vector<QString> ids;
  return ids;
}

}  // namespace

/// The device as the session knows it, within the user's limit.
UseDevice Studio::used_device() const {
  return {with_force_limit(device_->device().capabilities(), force_limit_n_)};
}

void Studio::start_loop() {
  OpenDevice& device = device_->device();
  ServoOptions options;
  options.period_ns = device.capabilities().period_ns;
  options.limits = limits_for(device.capabilities(), force_limit_n_);
  clock_start_ns_ = now_ns();
  servo_ = std::make_unique<Servo>(device, options);
  servo_->set_strength(strength_);
  servo_->set_session_offset(clock_start_ns_);
  last_event_ns_ = clock_start_ns_;
  hand_.reset();
  if (HandInput* hand = device_->hand()) {
    hand_ = std::make_unique<PointerHand>(*hand, device_->hand_options(), mouse_pressure_);
  }
  publish();
  if (listener_.loop) listener_.loop(servo_.get(), clock_start_ns_);
  if (options_.live) {
    thread_ = std::make_unique<RealtimeThread>(
        *servo_, RealtimeOptions{.lock_memory = device_->info().moves_hand}, device.loop_host());
    start_error_.clear();
    if (const Result<void> started = thread_->start(); !started) {
      start_error_ = started.error().message;
      Q_EMIT refused(QString::fromStdString(started.error().message));
    }
  }
  set_forces(!device_->info().moves_hand);
}

/// False: the device hangs, and with it its loop. Then both are given up, and another device stands
/// in; the servo is gone.
bool Studio::stop_loop() {
  std::unique_ptr<RealtimeThread> hanging;
  std::optional<std::int64_t> end_ns;
  if (thread_) {
    const bool has_stopped = thread_->stop();
    end_ns = now_ns();  // after its last tick
    if (!has_stopped) hanging = std::move(thread_);
    thread_.reset();
  }
  if (listener_.loop) listener_.loop(nullptr, 0);
  drain();
  clock_start_ns_ = end_ns.value_or(clock_start_ns_);  // after the last samples of that loop
  if (!hanging) return true;
  give_up(std::move(hanging));
  return false;
}

void Studio::give_up(std::unique_ptr<RealtimeThread> loop) {
  given_up_label_ = device_->info().label;
  given_up_ids().push_back(device_->info().id);
  hand_.reset();
  abandon(std::move(loop), std::move(servo_), std::move(device_));
  device_ = *open_pen_device(QString::fromLatin1(kPenDeviceDefault));  // is always there
}

bool Studio::is_given_up(const QString& device_id) {
  return std::find(given_up_ids().begin(), given_up_ids().end(), device_id) != given_up_ids().end();
}

QString Studio::given_up_words(const QString& device_label) {
  return tr("%1 hangs in its maker's software and was given up. The drawing is kept. Start "
            "Feltline "
            "anew to use it again.")
      .arg(device_label);
}

bool Studio::use_device(const QString& id) {
  Result<std::unique_ptr<PenDevice>> device = open_pen_device(id, page_.area());
  if (!device) {
    Q_EMIT refused(QString::fromStdString(device.error().message));
    return false;
  }
  use_device(*std::move(device));
  return true;
}

std::unique_ptr<PenDevice> Studio::use_device(std::unique_ptr<PenDevice> device) {
  const bool has_ended = stop_loop();
  servo_.reset();  // it knows the one that goes
  device_.swap(device);
  begin_with_device();
  return has_ended ? std::move(device) : nullptr;
}

void Studio::follow(const DeviceProfile& profile) {
  const bool has_ended = stop_loop();
  servo_.reset();
  if (has_ended) device_->set_profile(profile);
  begin_with_device();
}

/// The rest of a change of devices.
void Studio::begin_with_device() {
  told_faults_ = 0;
  told_fault_.reset();
  told_notice_ = device_->device().status().notice;  // whoever opened it has shown this one
  static_cast<void>(session_->apply({event_time_ns(), used_device()}));
  pen_ = {};
  start_loop();
  tell();
  Q_EMIT device_changed();
  if (!given_up_label_.isEmpty()) {
    Q_EMIT refused(given_up_words(std::exchange(given_up_label_, {})));
  }
}

DeviceStatus Studio::device_status() {
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

/// Twenty milliseconds apart: quick enough for an eye, and no work worth naming.
void Studio::look_at_device() {
  const std::int64_t now = now_ns();
  if (now - looked_at_device_ns_ < kStatusNs && now >= looked_at_device_ns_) return;
  looked_at_device_ns_ = now;
  const DeviceStatus status = device_status();
  const bool is_other = status.faults != told_faults_ || status.fault != told_fault_ ||
                        !(status.notice == told_notice_);
  told_faults_ = status.faults;
  told_fault_ = status.fault;
  told_notice_ = status.notice;
  if (is_other) Q_EMIT device_status_changed(status);
}

void Studio::set_force_limit(double newton) {
  if (std::isnan(newton)) return;
  newton = std::clamp(newton, 0.0, SafetyLimits{}.peak_force_n);
  if (std::exchange(force_limit_n_, newton) == newton) return;
  if (!stop_loop()) return begin_with_device();
  // After a fault only a person switches them on again: one that the last samples told, and one
  // that nobody has heard of yet.
  const bool may_be_on = forces_on_ && servo_->latest().safety.state != SafetyState::kLatched;
  static_cast<void>(session_->apply({event_time_ns(), used_device()}));
  start_loop();
  set_forces(may_be_on);
  tell();
}

}  // namespace felt::desktop
