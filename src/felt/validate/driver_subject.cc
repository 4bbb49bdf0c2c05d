#include "felt/validate/driver_subject.h"

#include <utility>

namespace felt {

DriverSubject::DriverSubject(Driver& driver, DeviceDescriptor found, const OpenOptions& options,
                             DeviceProfile profile)
    : driver_(driver),
      found_(std::move(found)),
      was_seen_(found_.is_connected),
      options_(options),
      profile_(std::move(profile)) {}

const DeviceDescriptor& DriverSubject::descriptor() const noexcept {
  return open_ ? open_->descriptor() : found_;
}

Result<void> DriverSubject::open() {
  close();
  Result<std::unique_ptr<DriverDevice>> opened = driver_.open(found_, options_);
  if (!opened) return tl::unexpected(opened.error());
  open_ = *std::move(opened);
  // What it says of itself once it is open counts.
  const DeviceDescriptor& now = open_->descriptor();
  forget_planes_of_another(profile_, now.serial);
  calibrated_.emplace(*open_,
                      profile_.plane ? *profile_.plane : driver_.default_plane(now, options_));
  return {};
}

void DriverSubject::close() noexcept {
  calibrated_.reset();
  open_.reset();
}

Device* DriverSubject::device() noexcept {
  if (!open_) return nullptr;
  return open_->descriptor().has_own_frame ? static_cast<Device*>(&*calibrated_) : open_.get();
}

LoopHost* DriverSubject::loop_host() noexcept {
  return open_ ? open_->loop_host() : nullptr;
}

Homing DriverSubject::homing() noexcept {
  return open_ ? open_->homing() : Homing::kNone;
}

std::string DriverSubject::homing_words() {
  return open_ ? open_->homing_words() : std::string();
}

Result<void> DriverSubject::find_home() {
  return open_ ? open_->find_home() : fail(ErrorCode::kNotFound, found_.id + " is not open");
}

bool DriverSubject::is_connected() {
  for (const DeviceDescriptor& device : driver_.find()) {
    if (device.id == found_.id) return device.is_connected || !was_seen_;
  }
  return false;
}

std::string DriverSubject::vendor_words() {
  return open_ ? std::string(open_->status().vendor_words.view()) : std::string();
}

}  // namespace felt
