#include "felt/replay/live_loop.h"

#include <optional>
#include <utility>

#include "felt/driver/page_fit.h"
#include "felt/rt/abandon.h"

namespace felt {
namespace {

/// What a person has shown; else the driver's usual plane, with the whole reach on the page.
PlaneCalibration plane_of(const std::optional<PlaneCalibration>& shown, const RealDevice& device,
                          const DriverDevice& open, const Rect& page) {
  if (shown) return *shown;
  const PlaneCalibration usual = device.driver->default_plane(open.descriptor(), OpenOptions());
  return fit_to_page(usual, reach_of(usual, open.capabilities()), page, 1.0);
}

Result<void> find_home(DriverDevice& device, const LiveLoop::MayMove& may_move) {
  if (device.homing() == Homing::kNone) return {};
  if (may_move && !may_move(device.homing_words())) {
    return fail(ErrorCode::kUnsupported, device.descriptor().id +
                                             ": it must find its home first, and nobody agreed "
                                             "to that");
  }
  return device.find_home();
}

}  // namespace

LiveLoop::LiveLoop(std::unique_ptr<DriverDevice> device, const DeviceProfile& profile,
                   const PlaneCalibration& plane, double force_limit_n)
    : device_(std::move(device)),
      calibrated_(std::make_unique<CalibratedDevice>(*device_, profile, plane)) {
  ServoOptions options;
  options.period_ns = capabilities().period_ns;
  options.limits = limits_for(capabilities(), force_limit_n);
  servo_ = std::make_unique<Servo>(*calibrated_, options);
  thread_ = std::make_unique<RealtimeThread>(*servo_, RealtimeOptions(), device_->loop_host());
}

Result<std::unique_ptr<LiveLoop>> LiveLoop::start(const RealDevice& device, const Rect& page,
                                                  double force_limit_n, const MayMove& may_move) {
  Result<std::unique_ptr<DriverDevice>> opened = device.driver->open(device.found, OpenOptions());
  if (!opened) return tl::unexpected(opened.error());
  if (Result<void> home = find_home(**opened, may_move); !home) return tl::unexpected(home.error());
  const DeviceDescriptor& now = (*opened)->descriptor();
  DeviceProfile profile = device.profile;
  forget_planes_of_another(profile, now.serial);  // known now that it is open
  const auto shown = std::exchange(profile.plane, std::nullopt);
  const PlaneCalibration plane =
      now.has_own_frame ? plane_of(shown, device, **opened, page) : PlaneCalibration();
  std::unique_ptr<LiveLoop> loop(new LiveLoop(*std::move(opened), profile, plane, force_limit_n));
  loop->servo_->heartbeat(loop->thread_->now_ns());
  if (Result<void> started = loop->thread_->start(); !started) {
    return tl::unexpected(started.error());
  }
  return loop;
}

Result<void> LiveLoop::go_on() {
  servo_->heartbeat(thread_->now_ns());
  servo_->disarm();
  return thread_->start();
}

LiveLoop::~LiveLoop() {
  static_cast<void>(stop());
}

bool LiveLoop::stop() noexcept {
  if (!thread_) return false;
  if (thread_->stop()) return true;
  abandon(std::move(thread_), std::move(servo_), std::move(calibrated_), std::move(device_));
  return false;
}

}  // namespace felt
