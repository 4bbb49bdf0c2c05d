#include "felt/validate/driver_subject.h"

#include <utility>

namespace felt {

DriverSubject::DriverSubject(Driver& driver, DeviceDescriptor found, const OpenOptions& options,
                             DeviceProfile profile)
    : driver_(driver),
      found_(std::move(found)),
      was_seen_(found_.is_connected),
      setup_{.open = options, .profile = std::move(profile)} {
  setup_.profile.force_limit_n.reset();
  setup_.profile.stiffness_cap_n_per_m.reset();
}

const DeviceDescriptor& DriverSubject::descriptor() const noexcept {
  return device_ ? device_->descriptor() : found_;
}

Result<void> DriverSubject::open() {
  close();
  Result<std::unique_ptr<OpenDevice>> opened = OpenDevice::open(driver_, found_, setup_);
  if (!opened) return tl::unexpected(opened.error());
  device_ = *std::move(opened);
  return {};
}

bool DriverSubject::is_connected() {
  for (const DeviceDescriptor& device : driver_.find()) {
    if (device.id == found_.id) return device.is_connected || !was_seen_;
  }
  return false;
}

}  // namespace felt
