// The part of DhdDevice that the edit thread uses: set-up, homing, status.
#include <array>
#include <utility>

#include "felt/devices/forcedimension/dhd_device.h"

namespace felt::dhd {
namespace {

constexpr int kRestPoseMs = 8000;
constexpr int kTries = 3;

}  // namespace

DhdDevice::DhdDevice(std::shared_ptr<Library> library, Id id, DeviceDescriptor descriptor,
                     const SystemType& type, std::optional<double> pen_mass_kg)
    : library_(std::move(library)),
      api_(library_->api()),
      id_(id),
      descriptor_(std::move(descriptor)),
      type_(type),
      gate_(descriptor_.capabilities) {
  api_.stop(id_);
  set_up(pen_mass_kg);
  look_at_status();
  publish();
}

void DhdDevice::set_up(std::optional<double> pen_mass_kg) {
  std::string_view notice;
  if (api_.set_gravity_compensation == nullptr || api_.set_gravity_compensation(kOn, id_) < 0) {
    notice = "its gravity compensation is off";
  }
  if (pen_mass_kg &&
      (api_.set_effector_mass == nullptr || api_.set_effector_mass(*pen_mass_kg, id_) < 0)) {
    notice = "the mass of the pen could not be set";
  }
  // The watchdog acts when too much time has passed since the last force command. Controllers with
  // firmware before 3.0 do not have a watchdog. The device's guard against high speeds keeps the
  // maker's setting.
  bool is_watched = false;
  for (int i = 0; i < kTries && !is_watched && api_.set_watchdog != nullptr; ++i) {
    // Tries several times, because the expert mode is shared by the whole program: the tick of
    // another device may just have ended it.
    api_.enable_expert_mode();
    is_watched = api_.set_watchdog(kWatchdog31Ms, id_) >= 0;
    api_.disable_expert_mode();
  }
  unsigned char units = 0;
  if (is_watched && api_.get_watchdog != nullptr && api_.get_watchdog(&units, id_) >= 0) {
    is_watched = units > 0 && units <= kWatchdog31Ms;
  }
  if (!is_watched) notice = "it has no watchdog: if the program hangs, the last force stays on";
  status_.notice = ShortText(notice);
}

DeviceStatus DhdDevice::status() noexcept {
  published_.update();
  DeviceStatus status = published_.get();
  if (api_.get_com_freq != nullptr && status.fault != DeviceFault::kDisconnected) {
    const double khz = api_.get_com_freq(id_);
    if (khz > 0.0 && khz < 1e3) status.rate_hz = 1e3 * khz;
  }
  return status;
}

Homing DhdDevice::homing() noexcept {
  look_at_status();
  if (is_home_ || is_gone_) return Homing::kNone;
  return api_.has_drd() && api_.drd_is_supported(id_) ? Homing::kByItself : Homing::kRestPose;
}

std::string DhdDevice::homing_words() {
  switch (homing()) {
    case Homing::kByItself:
      return "The arm will move by itself for some seconds to find its home position. Take your "
             "hand off it, and clear everything out of its way.";
    case Homing::kRestPose:
      if (descriptor_.model == "falcon") {
        return "Push the knob slowly all the way in and pull it all the way out, until its lights "
               "change their colour.";
      }
      return "Bring the arm into its rest pose (pushed back as far as it goes, or its tip in the "
             "calibration pit) and hold it there until its light stops blinking.";
    default:
      return {};
  }
}

Result<void> DhdDevice::find_home() {
  const Homing way = homing();
  if (is_gone_) return fail(ErrorCode::kIo, descriptor_.label + " is no longer connected");
  if (way == Homing::kNone) return {};
  if (auto done = way == Homing::kByItself ? move_home() : wait_for_rest_pose(); !done) {
    return done;
  }
  failed_ns_.reset();
  read_fault_.reset();
  set_up({});  // the library's own homing may have changed the watchdog
  look_at_status();
  publish();
  if (is_home_) return {};
  return fail(ErrorCode::kIo,
              descriptor_.label +
                  " still does not know its position; switch it off and on, and find home again");
}

Result<void> DhdDevice::move_home() {
  const bool is_done = api_.drd_auto_init(id_) >= 0;
  const std::string words = is_done ? std::string() : library_->last_words();
  // The library holds the arm with a thread of its own until it is stopped.
  const bool is_free = api_.drd_stop(true, id_) >= 0;
  static_cast<void>(send({}));
  api_.stop(id_);
  motors_ = Motors::kBraked;
  if (is_done && is_free) return {};
  return fail(ErrorCode::kIo, descriptor_.label + " did not find home: " +
                                  (is_done ? library_->last_words() : words) +
                                  "; make sure that nothing is in the arm's way and its power "
                                  "supply is on, then try again");
}

Result<void> DhdDevice::wait_for_rest_pose() {
  if (api_.reset == nullptr) {
    return fail(ErrorCode::kUnsupported,
                "this library cannot find home; install the SDK's libdrd.so");
  }
  int done = api_.reset(id_);
  if (done >= 0 && api_.wait_for_reset != nullptr) done = api_.wait_for_reset(kRestPoseMs, id_);
  if (done >= 0) return {};
  return fail(ErrorCode::kIo, descriptor_.label +
                                  " did not detect its rest pose: " + library_->last_words() +
                                  "; hold the arm there until its light stops blinking, and try "
                                  "again");
}

}  // namespace felt::dhd
