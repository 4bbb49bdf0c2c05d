#include "felt/validate/simulated_subject.h"

#include <cmath>
#include <numbers>

namespace felt {
namespace {

constexpr double kAbovePageMm = 12.0;
constexpr double kCircleMm = 5.0;
constexpr double kPressMm = 2.0;                // depth below the surface while drawing
constexpr std::int64_t kReachNs = 500'000'000;  // time to reach the cable

}  // namespace

tl::expected<PenSample, DeviceFault> SimulatedSubject::Plug::read(std::int64_t now_ns) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (last_ns_ && watchdog_ns_ > 0 && now_ns - *last_ns_ > watchdog_ns_) {
    static_cast<void>(device_.read(*last_ns_ + watchdog_ns_));
    device_.stop();
  }
  last_ns_ = now_ns;
  return device_.read(now_ns);
}

tl::expected<void, DeviceFault> SimulatedSubject::Plug::write(const Force& force) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  return device_.write(force);
}

void SimulatedSubject::Plug::pull() noexcept {
  is_gone_ = true;
  device_.stop();
}

SimulatedSubject::SimulatedSubject(Device& device, HandInput& hand, DeviceDescriptor descriptor,
                                   const SimulatedSubjectOptions& options)
    : hand_(hand), descriptor_(std::move(descriptor)), plug_(device, options.watchdog_ns) {
  const Capabilities& can = device.capabilities();
  middle_ = 0.5 * (can.workspace_min + can.workspace_max);
  middle_.z = kAbovePageMm;
  before_tick(0);
}

Result<void> SimulatedSubject::open() {
  if (unplugged_) return fail(ErrorCode::kNotFound, "it is unplugged");
  plug_.plug_in();
  is_open_ = true;
  return {};
}

void SimulatedSubject::close() noexcept {
  if (is_open_) plug_.stop();
  is_open_ = false;
}

bool SimulatedSubject::does(PersonTask task, const std::string&) {
  if (task == PersonTask::kAgreeToForces || task == PersonTask::kFindHome) return true;
  task_ = task;
  since_ns_ = now_ns_;
  return true;
}

void SimulatedSubject::before_tick(std::int64_t now_ns) {
  now_ns_ = now_ns;
  const double t = 1e-9 * static_cast<double>(now_ns - since_ns_);
  const double turn = 2.0 * std::numbers::pi * t;
  Vec3 aim = middle_;
  if (task_ == PersonTask::kDrawCircles) {
    aim += kCircleMm * Vec3{std::cos(turn) - 1.0, std::sin(turn), 0.0};
  } else if (task_ == PersonTask::kDraw) {
    aim += kCircleMm * Vec3{std::cos(turn) - 1.0, std::sin(2.0 * turn), 0.0};
    aim.z = kPressMm * std::cos(0.5 * turn) + 0.3 * kPressMm;
  } else if (task_ == PersonTask::kUnplug && now_ns - since_ns_ > kReachNs && !unplugged_) {
    unplugged_ = true;
    plug_.pull();
  } else if (task_ == PersonTask::kReplug && now_ns - since_ns_ > kReachNs) {
    unplugged_ = false;
  }
  hand_.aim(aim, std::nullopt, 0);
}

}  // namespace felt
