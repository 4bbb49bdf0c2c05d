#include "felt/devices/evdev/stick_device.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "felt/driver/device_models.h"

namespace felt {
namespace {

constexpr std::uint64_t kReportEvery = 32;  // reads between status updates if nothing else changes

/// Returns a text without allocation, because strerror() may allocate.
std::string_view words_of(int error) noexcept {
  switch (error) {
    case ENODEV:
      return "No such device (ENODEV)";
    case EIO:
      return "Input/output error (EIO)";
    case ENOSPC:
      return "No space left on device (ENOSPC): all its effect slots are in use";
    case EINVAL:
      return "Invalid argument (EINVAL): it does not support this effect";
    case EACCES:
      return "Permission denied (EACCES)";
    case EBUSY:
      return "Device or resource busy (EBUSY)";
    case EAGAIN:
      return "Resource temporarily unavailable (EAGAIN): it does not report its position";
    case EINTR:
      return "Interrupted (EINTR)";
    case ETIMEDOUT:
      return "Timed out (ETIMEDOUT)";
    default:
      return "The kernel refuses";
  }
}

constexpr bool means_gone(int error) noexcept {
  return error == ENODEV || error == ENXIO || error == EBADF;
}

}  // namespace

Capabilities capabilities_of(const StickKind& kind, double step_mm) noexcept {
  Capabilities can = find_device_model(kind.is_wheel ? "ff-wheel" : "ff-stick")->capabilities;
  // Limits the force to the strength of this device; never raises it above the figure in
  // device_models().
  can.max_force_n = std::min(can.max_force_n, kind.forces.full_force_n);
  can.max_stiffness_n_per_m =
      std::min(can.max_stiffness_n_per_m, 1e3 * ability_of(kind.forces).max_stiffness_n_per_mm);
  can.position_step_mm = step_mm;
  can.senses_pressure = true;
  return can;
}

StickDevice::StickDevice(std::unique_ptr<EvdevPort> port, const StickKind& kind,
                         const StickAxes& axes, DeviceDescriptor descriptor, bool has_thread)
    : port_(std::move(port)),
      kind_(kind),
      axes_(axes),
      descriptor_(std::move(descriptor)),
      gate_(descriptor_.capabilities),
      keeper_(*port_, kind_.forces, gate_.max_n()) {
  if (!kind_.is_known) {
    status_.notice = ShortText(
        "The strength of this device is unknown. It is treated as a strong one, so its forces may "
        "be too weak.");
  }
  statuses_.publish(status_);
  if (has_thread) thread_ = std::thread([this] { run(); });
}

StickDevice::~StickDevice() {
  is_over_.store(true);
  if (thread_.joinable()) thread_.join();
  keeper_.silence();
  keeper_.erase_all();
}

void StickDevice::run() noexcept {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  while (!is_over_.load()) {
    const auto passed = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - begin);
    serve(passed.count());
    std::this_thread::sleep_for(std::chrono::nanoseconds(kLookNs));
  }
}

void StickDevice::serve(std::int64_t now_ns) noexcept {
  keeper_.serve(now_ns);
  const std::uint32_t question = questions_.load(std::memory_order_acquire);
  if (question == answered_) return;
  const StickStand stand = ask_stick(*port_, kind_.layout);
  if (stand.error == EINTR) return;  // interrupted by a signal: asks again next time
  answered_ = question;
  answers_.publish({question, stand});
}

/// Reads the stick's events. After events were lost, sets the state that the worker has read
/// instead.
tl::expected<void, int> StickDevice::receive(std::int64_t now_ns) noexcept {
  answers_.update();
  const Answer& answer = answers_.get();
  if (has_asked_ && answer.question == questions_.load(std::memory_order_relaxed)) {
    has_asked_ = false;
    if (const auto taken = axes_.take(answer.stand, now_ns); !taken) return taken;
  }
  if (const auto received = axes_.listen(*port_, now_ns); !received) return received;
  if (axes_.needs_asking() && !std::exchange(has_asked_, true)) {
    questions_.fetch_add(1, std::memory_order_release);
  }
  return {};
}

DeviceStatus StickDevice::status() noexcept {
  statuses_.update();
  return statuses_.get();
}

tl::unexpected<DeviceFault> StickDevice::failed(DeviceFault fault, int error) noexcept {
  const bool is_new = status_.fault != fault;
  status_.fault = status_.last_fault = fault;
  status_.vendor_code = error;
  status_.vendor_words = error != 0 ? ShortText(words_of(error)) : ShortText(describe(fault));
  ++status_.faults;
  if (is_new || status_.faults % kReportEvery == 0) statuses_.publish(status_);
  return tl::unexpected(fault);
}

tl::expected<PenSample, DeviceFault> StickDevice::read(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  if (is_gone_) return failed(DeviceFault::kDisconnected, ENODEV);
  if (const auto received = receive(now_ns); !received) {
    is_gone_ = true;
    release();
    return failed(DeviceFault::kDisconnected, received.error());
  }
  if (axes_.is_stale(now_ns)) return failed(DeviceFault::kBadData, EAGAIN);
  pen_ = axes_.sample(now_ns);
  const bool was_read_fault = status_.fault == DeviceFault::kBadData;
  if (was_read_fault) status_.fault.reset();
  if (++status_.reads % kReportEvery == 0 || was_read_fault) statuses_.publish(status_);
  return pen_;
}

void StickDevice::remember(const Force& force) noexcept {
  if (count_ == kWindow) {
    std::move(x_.begin() + 1, x_.end(), x_.begin());
    std::move(y_.begin() + 1, y_.end(), y_.begin());
    --count_;
  }
  x_[count_] = {pen_.position.x, pen_.velocity.x, force.x};
  y_[count_] = {pen_.position.y, pen_.velocity.y, force.y};
  ++count_;
}

void StickDevice::plan() noexcept {
  const bool is_due = now_ns_ - planned_ns_ >= kServeNs || now_ns_ < planned_ns_;
  if (count_ > 1 && !is_due) return;
  planned_ns_ = now_ns_;
  const FitAbility can = ability_of(kind_.forces);
  const std::array<AxisFit, 2> fits{fit_axis(std::span(x_).first(count_), can),
                                    fit_axis(std::span(y_).first(count_), can)};
  keeper_.want(plan_effects(fits, kind_.forces, gate_.max_n()));
}

void StickDevice::release() noexcept {
  keeper_.silence();
  count_ = 0;
}

tl::expected<void, DeviceFault> StickDevice::write(const Force& force) noexcept {
  if (is_gone_) return failed(DeviceFault::kDisconnected, ENODEV);
  // The vertical force is dropped, because the device has no vertical axis. A force that is not
  // finite is passed on unchanged, so that the gate rejects it.
  const ForceGate::Passed passed =
      gate_.pass(is_finite(force) ? Force{force.x, force.y, 0.0} : force, now_ns_);
  if (!passed.was_finite) {
    release();
    return failed(DeviceFault::kBadData, 0);
  }
  if (passed.force == Force{}) {
    release();
  } else {
    remember(passed.force);
    plan();
  }
  const int error = keeper_.error();
  if (error == 0) {
    if (std::exchange(status_.fault, std::nullopt)) statuses_.publish(status_);
    return {};
  }
  is_gone_ = means_gone(error);
  return failed(is_gone_ ? DeviceFault::kDisconnected : DeviceFault::kForcesOff, error);
}

void StickDevice::stop() noexcept {
  release();
  gate_.release();
}

}  // namespace felt
