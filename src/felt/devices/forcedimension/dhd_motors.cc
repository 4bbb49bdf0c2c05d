// The part of DhdDevice for its motors: finds out who switched them off, and sends their forces.
#include "felt/devices/forcedimension/dhd_device.h"

namespace felt::dhd {
namespace {

constexpr double kSlowMmPerS = 100.0;

std::string_view words_of(int cause) noexcept {
  switch (cause) {
    case kCauseButton:
      return "forces are off: its force button";
    case kCauseVelocity:
      return "forces are off: it was moved too fast";
    case kCauseWatchdog:
      return "forces are off: its watchdog timed out";
    case kCauseUsb:
      return "forces are off: its USB cable";
    case kCauseDeadMan:
      return "forces are off: it is not being held";
    default:
      return "forces are off: no reason reported";
  }
}

bool is_a_persons(int cause) noexcept {
  return cause == kCauseButton || cause == kCauseDeadMan;
}

}  // namespace

void DhdDevice::look_at_motors(const std::array<int, kStatusRoom>& status) noexcept {
  const bool is_on = status[kStatusForce] != 0;
  const int cause = is_on ? kCauseNone : status[kStatusForceOffCause];
  if (motors_ == Motors::kTaken) {
    if (is_on) motors_ = Motors::kLive;  // safe, because only zero was sent meanwhile
    return;
  }
  if (is_on) return;
  // The device also reports motors that we braked as off. For braked motors, only a cause that
  // comes from the user (button, grip) is of interest.
  if (motors_ == Motors::kBraked && !is_a_persons(cause)) return;
  if (cause == kCauseSoftware) {  // by our own stop(), whose answer was lost
    motors_ = Motors::kBraked;
    return;
  }
  motors_ = Motors::kTaken;
  cause_ = cause;
  quiet_since_ns_ = now_ns_;
  gate_.release();
  write_failed(note(DeviceFault::kForcesOff, cause,
                    status[kStatusPower] == 0 ? "forces are off: no power" : words_of(cause)));
}

tl::expected<void, DeviceFault> DhdDevice::write(const Force& force) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!is_home_) {
    stop();
    return tl::unexpected(DeviceFault::kNotCalibrated);
  }
  const ForceGate::Passed passed = gate_.pass(force, now_ns_);
  const bool asks = !(force == Force{});
  if (motors_ == Motors::kTaken) {
    if (auto back = write_taken(asks); !back) return back;
  } else if (motors_ == Motors::kBraked) {
    if (auto on = write_braked(asks); !on || motors_ == Motors::kBraked) return on;
  }
  if (auto sent = send(passed.force); !sent) return write_failed(sent.error());
  if (!passed.was_finite) {
    return write_failed(
        note(DeviceFault::kBadData, 0, "was asked for a force that is not a number"));
  }
  write_fault_.reset();
  return {};
}

tl::expected<void, DeviceFault> DhdDevice::write_taken(bool asks) noexcept {
  if (asks) quiet_since_ns_ = now_ns_;
  if (may_take_back(asks)) {
    quiet_since_ns_ = now_ns_;
    if (auto on = enable(); !on) return write_failed(on.error());
    return {};  // the next status shows whether it worked
  }
  gate_.release();
  // Sends zero, so that no old force holds when the device enables its motors again.
  if (auto sent = send({}); !sent) return write_failed(sent.error());
  return tl::unexpected(DeviceFault::kForcesOff);
}

tl::expected<void, DeviceFault> DhdDevice::write_braked(bool asks) noexcept {
  const std::int64_t since_ns = now_ns_ - failed_ns_.value_or(now_ns_ - kRetryNs);
  if (since_ns < 0 || since_ns >= kRetryNs) {
    look_at_status();  // the user may have switched the motors off meanwhile
    if (motors_ == Motors::kTaken) return tl::unexpected(DeviceFault::kForcesOff);
    if (auto on = enable(); !on) return write_failed(on.error());
    return {};
  }
  // A request for zero force succeeds, because the motors give no force.
  gate_.release();
  if (asks) return tl::unexpected(write_fault_.value_or(DeviceFault::kForcesOff));
  return {};
}

void DhdDevice::stop() noexcept {
  gate_.release();
  if (motors_ == Motors::kBraked) return;
  static_cast<void>(send({}));
  // Reads the status before the motors are braked, because our own stop would hide why the device
  // switched them off. If the motors are not live, they are off already.
  if (motors_ == Motors::kLive) look_at_status();
  if (motors_ == Motors::kLive) brake();
}

void DhdDevice::brake() noexcept {
  gate_.release();
  static_cast<void>(send({}));
  if (api_.stop(id_) >= 0) motors_ = Motors::kBraked;
}

tl::expected<void, DeviceFault> DhdDevice::send(const Force& f) noexcept {
  int done = kFailed;
  if (type_.call == ForceCall::kForceTorqueAndGripper && api_.set_force_torque_gripper != nullptr) {
    done = api_.set_force_torque_gripper(f.x, f.y, f.z, 0.0, 0.0, 0.0, 0.0, id_);
  } else if (type_.call != ForceCall::kForce && api_.set_force_and_gripper != nullptr) {
    done = api_.set_force_and_gripper(f.x, f.y, f.z, 0.0, id_);
  } else {
    done = api_.set_force(f.x, f.y, f.z, id_);
  }
  if (done < 0) return tl::unexpected(vendor_fault());  // kMotorSaturated is not a fault
  return {};
}

// Enables forces, starting from zero, so that the controller's last force does not return.
tl::expected<void, DeviceFault> DhdDevice::enable() noexcept {
  if (auto sent = send({}); !sent) return sent;
  api_.enable_expert_mode();
  const bool done = api_.enable_force(kOn, id_) >= 0;
  const DeviceFault fault = done ? DeviceFault::kOther : vendor_fault();
  api_.disable_expert_mode();
  if (!done) return tl::unexpected(fault);
  motors_ = Motors::kLive;
  return {};
}

bool DhdDevice::may_take_back(bool asks) const noexcept {
  if (asks || is_a_persons(cause_)) return false;
  if (cause_ == kCauseWatchdog) return true;
  return now_ns_ - quiet_since_ns_ >= kRestNs && speed_mm_per_s_ < kSlowMmPerS;
}

}  // namespace felt::dhd
