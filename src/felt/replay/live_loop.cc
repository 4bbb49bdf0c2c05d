#include "felt/replay/live_loop.h"

#include <utility>

#include "felt/rt/abandon.h"

namespace felt {
namespace {

Result<void> find_home(OpenDevice& device, const LiveLoop::MayMove& may_move) {
  if (device.homing() == Homing::kNone) return {};
  if (may_move && !may_move(device.homing_words())) {
    return fail(ErrorCode::kUnsupported,
                device.descriptor().id +
                    ": it must find its home position first, which needs your consent");
  }
  return device.find_home();
}

}  // namespace

LiveLoop::LiveLoop(std::unique_ptr<OpenDevice> device, double force_limit_n)
    : device_(std::move(device)) {
  ServoOptions options;
  options.period_ns = device_->capabilities().period_ns;
  options.limits = limits_for(device_->capabilities(), force_limit_n);
  servo_ = std::make_unique<Servo>(*device_, options);
  thread_ = std::make_unique<RealtimeThread>(*servo_, RealtimeOptions(), device_->loop_host());
}

Result<std::unique_ptr<LiveLoop>> LiveLoop::start(const RealDevice& device, const Rect& page,
                                                  double force_limit_n, const MayMove& may_move) {
  Result<std::unique_ptr<OpenDevice>> opened =
      OpenDevice::open(*device.driver, device.found, {.profile = device.profile, .page = page});
  if (!opened) return tl::unexpected(opened.error());
  if (Result<void> home = find_home(**opened, may_move); !home) return tl::unexpected(home.error());
  std::unique_ptr<LiveLoop> loop(new LiveLoop(*std::move(opened), force_limit_n));
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
  abandon(std::move(thread_), std::move(servo_), std::move(device_));
  return false;
}

}  // namespace felt
