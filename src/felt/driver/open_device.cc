#include "felt/driver/open_device.h"

#include <utility>

#include "felt/driver/page_fit.h"
#include "felt/geometry/tilt.h"
#include "felt/rt/abandon.h"

namespace felt {
namespace {

PlaneCalibration on_page(const PlaneCalibration& plane, const Capabilities& device,
                         const std::optional<Rect>& page) {
  return page ? fit_to_page(plane, reach_of(plane, device), *page, 1.0) : plane;
}

}  // namespace

Result<std::unique_ptr<OpenDevice>> OpenDevice::open(Driver& driver, const DeviceDescriptor& found,
                                                     const DeviceSetup& setup) {
  Result<std::unique_ptr<DriverDevice>> opened = driver.open(found, setup.open);
  if (!opened) return tl::unexpected(opened.error());
  const PlaneCalibration plane = driver.default_plane((*opened)->descriptor(), setup.open);
  return std::make_unique<OpenDevice>(*std::move(opened), plane, setup);
}

OpenDevice::OpenDevice(std::unique_ptr<DriverDevice> device, const PlaneCalibration& default_plane,
                       const DeviceSetup& setup)
    : opened_(std::move(device)), device_(*opened_), driver_lock_(setup.driver_lock) {
  if (opened_->descriptor().has_own_frame) {
    default_plane_ = on_page(default_plane, device_.capabilities(), setup.page);
  }
  set_profile(setup.profile);
}

OpenDevice::OpenDevice(Device& device, const PlaneCalibration& plane)
    : device_(device), default_plane_(plane) {
  set_profile({});
}

OpenDevice::~OpenDevice() {
  if (!opened_ || !driver_lock_) return;
  const std::unique_lock lock(*driver_lock_, kClosePatience);
  // If the driver's library hangs in another call, closing would hang as well.
  if (lock.owns_lock()) {
    opened_.reset();
  } else {
    abandon(std::move(opened_));
  }
}

void OpenDevice::set_profile(DeviceProfile profile) {
  if (descriptor().has_own_frame) {
    // Another unit of the same model has another position and plane.
    forget_planes_of_another(profile, descriptor().serial);
    plane_ = profile.plane.value_or(default_plane_);
  }
  is_mapped_ = plane_ != PlaneCalibration();
  capabilities_ = plane_.to_page(limited_by(profile, device_.capabilities()));
}

void OpenDevice::map(PenSample& sample) const noexcept {
  if (!is_mapped_) return;
  sample.position = plane_.to_page(sample.position);
  sample.velocity = plane_.turn_to_page(sample.velocity);
}

tl::expected<PenSample, DeviceFault> OpenDevice::read(std::int64_t now_ns) noexcept {
  tl::expected<PenSample, DeviceFault> sample = device_.read(now_ns);
  if (!sample) return sample;
  map(*sample);
  if (const std::optional<Vec3> axis = device_.pen_axis()) {
    sample->tilt_deg = tilt_of_axis(plane_.turn_to_page(*axis));
  }
  return sample;
}

std::optional<PenSample> OpenDevice::between() noexcept {
  std::optional<PenSample> sample = device_.between();
  if (sample) map(*sample);
  return sample;
}

tl::expected<void, DeviceFault> OpenDevice::write(const Force& force) noexcept {
  return device_.write(is_mapped_ ? plane_.turn_to_device(force) : force);
}

std::optional<Force> OpenDevice::held_force() const noexcept {
  std::optional<Force> held = device_.held_force();
  if (held && is_mapped_) held = plane_.turn_to_page(*held);
  return held;
}

const DeviceDescriptor& OpenDevice::descriptor() const noexcept {
  static const DeviceDescriptor kNone;
  return opened_ ? opened_->descriptor() : kNone;
}

DeviceStatus OpenDevice::status() noexcept {
  return opened_ ? opened_->status() : DeviceStatus();
}

LoopHost* OpenDevice::loop_host() noexcept {
  return opened_ ? opened_->loop_host() : nullptr;
}

bool OpenDevice::set_pen_down(bool is_down) noexcept {
  return opened_ && opened_->set_pen_down(is_down);
}

Homing OpenDevice::homing() noexcept {
  return opened_ ? opened_->homing() : Homing::kNone;
}

std::string OpenDevice::homing_words() {
  return opened_ ? opened_->homing_words() : std::string();
}

Result<void> OpenDevice::find_home() {
  if (!opened_) return {};
  std::unique_lock<std::timed_mutex> lock;
  if (driver_lock_) lock = std::unique_lock(*driver_lock_);
  return opened_->find_home();
}

}  // namespace felt
