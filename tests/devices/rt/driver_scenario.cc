#include "tests/devices/rt/driver_scenario.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/force_model.h"

namespace felt::rt_test {
namespace {

// The driver has written its first forces by this time.
constexpr std::int64_t kWarmUpNs = 1500 * kMs;
constexpr std::int64_t kFirstFaultNs = 1600 * kMs, kFaultNs = 50 * kMs, kNextFaultNs = 1100 * kMs;

std::vector<FaultWindow> one_after_the_other(const BenchMaker& make) {
  const auto shown = make({});
  std::vector<FaultWindow> faults;
  std::int64_t at_ns = kFirstFaultNs;
  for (const InjectedFault fault : injected_faults()) {
    if (!shown->shows(fault)) continue;
    faults.push_back({fault, at_ns, at_ns + kFaultNs, 20.0});
    at_ns += kNextFaultNs;
  }
  return faults;
}

// The device in the frame of the surface. Records whether the device must be opened or homed again.
class DriverInTick final : public Device {
 public:
  DriverInTick(DriverDevice& device, const PlaneCalibration& plane) : device_(device, plane) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return device_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    auto sample = device_.read(now_ns);
    is_gone_ = !sample && (sample.error() == DeviceFault::kDisconnected ||
                           sample.error() == DeviceFault::kNotCalibrated);
    return sample;
  }
  std::optional<PenSample> between() noexcept override { return device_.between(); }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return device_.write(force);
  }
  [[nodiscard]] std::optional<Force> held_force() const noexcept override {
    return device_.held_force();
  }
  [[nodiscard]] bool is_arm() const noexcept override { return device_.is_arm(); }
  void stop() noexcept override { device_.stop(); }
  [[nodiscard]] bool is_gone() const noexcept { return is_gone_; }

 private:
  OpenDevice device_;
  bool is_gone_ = false;
};

class DriverSession final : public Session {
 public:
  DriverSession(const BenchMaker& make, bool with_faults) {
    std::vector<FaultWindow> faults;
    if (with_faults) faults = one_after_the_other(make);
    if (with_faults) ends_ns_ = faults.back().until_ns + kNextFaultNs;
    bench_ = make(std::move(faults));
    const Capabilities& space = bench_->world().preset().capabilities;
    middle_ = 0.5 * (space.workspace_min + space.workspace_max);
    const Vec3 size = space.workspace_max - space.workspace_min;
    radius_mm_ = std::min(15.0, 0.25 * std::min(size.x, size.y));
    connect();
  }

  Servo& servo() override { return *servo_; }
  [[nodiscard]] int warm_up_ticks() const override {
    return static_cast<int>(kWarmUpNs / servo_->options().period_ns);
  }
  [[nodiscard]] int min_ticks() const override {
    return static_cast<int>(ends_ns_ / servo_->options().period_ns);
  }
  void edit(int tick, std::int64_t now_ns) override {
    const double t_s = 1e-9 * static_cast<double>(now_ns);
    // A disconnected device can be opened again some time after the fault.
    if (device_->is_gone() && (now_ns - kFirstFaultNs) % kNextFaultNs > 2 * kFaultNs &&
        bench_->reconnect()) {
      connect();
    }
    bench_->hand().aim({middle_.x + radius_mm_ * std::sin(5.0 * t_s),
                        middle_.y + radius_mm_ * std::cos(7.0 * t_s), -3.0 * std::sin(6.0 * t_s)},
                       {}, tick % 512 == 0 ? 1 : 0);
    servo_->heartbeat(now_ns);
    if (tick % 300 == 0) servo_->arm();  // re-arms after a fault
    PenSample sample;
    while (servo_->for_edit().pop(sample)) {
    }
    while (servo_->for_autosave().pop(sample)) {
    }
    bench_->before_tick(now_ns);
  }

 private:
  void connect() {
    device_.emplace(*bench_->device(), bench_->plane());
    const Capabilities& can = device_->capabilities();
    servo_ = std::make_unique<Servo>(
        *device_, ServoOptions{.period_ns = can.period_ns, .limits = limits_for(can)});
    // Adds an attracting well, because planar devices cannot render the surface.
    servo_->publish(ForceModel(Compose(make_surface_force(surface_materials()[0], media()[0], can),
                                       SnapWells(Point{middle_.x, middle_.y}))));
    servo_->arm();
  }

  std::int64_t ends_ns_ = 0;  // some time after the end of the last fault
  std::unique_ptr<DriverBench> bench_;
  Vec3 middle_;
  double radius_mm_ = 15.0;
  std::optional<DriverInTick> device_;
  std::unique_ptr<Servo> servo_;
};

}  // namespace

std::unique_ptr<Session> make_driver_session(std::string_view bench, bool with_faults) {
  return make_driver_session(
      [bench](std::vector<FaultWindow> faults) {
        return make_driver_bench(bench, std::move(faults));
      },
      with_faults);
}

std::unique_ptr<Session> make_driver_session(const BenchMaker& make, bool with_faults) {
  return std::make_unique<DriverSession>(make, with_faults);
}

}  // namespace felt::rt_test
