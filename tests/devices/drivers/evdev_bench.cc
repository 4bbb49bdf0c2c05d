#include "tests/devices/drivers/evdev_bench.h"

#include <utility>

#include "felt/devices/evdev/evdev_driver.h"
#include "tests/devices/drivers/evdev/fake_stick.h"

namespace felt {
namespace {

/// The device on its haptic thread, with a worker that is as fast as possible: it runs between any
/// two calls.
class ServedStick final : public DriverDevice {
 public:
  ServedStick(FakeStick& stick, std::unique_ptr<DriverDevice> device, std::int64_t now_ns)
      : stick_(stick), device_(std::move(device)), now_ns_(now_ns) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_->name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return device_->capabilities();
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override {
    return device_->descriptor();
  }
  [[nodiscard]] DeviceStatus status() noexcept override { return device_->status(); }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    stick_.set_haptic_thread(true);
    const auto pen = device_->read(now_ns);
    look();
    return pen;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    stick_.set_haptic_thread(true);
    const auto done = device_->write(force);
    look();
    return done;
  }
  void stop() noexcept override {
    stick_.set_haptic_thread(true);
    device_->stop();
    look();
  }
  void serve(std::int64_t now_ns) noexcept {
    now_ns_ = now_ns;
    look();
  }

 private:
  void look() noexcept {
    stick_.set_haptic_thread(false);
    dynamic_cast<EffectServed&>(*device_).serve(now_ns_);
  }

  FakeStick& stick_;
  std::unique_ptr<DriverDevice> device_;
  std::int64_t now_ns_;
};

class EvdevBench final : public DriverBench {
 public:
  explicit EvdevBench(std::vector<FaultWindow> faults) : stick_(std::move(faults)) {
    EvdevOptions options;
    options.system = &stick_.system();
    options.open = [this](const std::string& path) { return stick_.open(path); };
    options.has_thread = false;
    driver_ = make_evdev_driver(std::move(options));
    static_cast<void>(reconnect());
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "evdev"; }
  [[nodiscard]] DriverDevice* device() noexcept override { return device_.get(); }
  [[nodiscard]] PlaneCalibration plane() const noexcept override {
    return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
                                   {FakeStick::kMiddle.x, FakeStick::kMiddle.y, 0.0});
  }
  [[nodiscard]] HandInput& hand() noexcept override { return stick_.world().stylus(); }
  [[nodiscard]] FakeWorld& world() noexcept override { return stick_.world(); }

  void before_tick(std::int64_t now_ns) noexcept override {
    stick_.tick(now_ns);
    now_ns_ = now_ns;
    if (device_) device_->serve(now_ns);
  }

  /// A device that reports whole counts cannot report NaN or times. A report is a target position
  /// for the next 8 ms, so a jump becomes a fast movement, and a stick that reports nothing is a
  /// stick that nobody moves. It reports neither motor temperature nor the loss of its zero
  /// position. It reports that it refuses forces only when a force is requested (evdev_test.cc).
  [[nodiscard]] bool shows(InjectedFault fault) const noexcept override {
    if (is_of_a_service(fault)) return false;
    switch (fault) {
      case InjectedFault::kNotFinite:
      case InjectedFault::kInfinite:
      case InjectedFault::kTimeBackwards:
      case InjectedFault::kJump:
      case InjectedFault::kJumpOften:
      case InjectedFault::kSignFlip:
      case InjectedFault::kNoAnswer:
      case InjectedFault::kForcesOff:
      case InjectedFault::kWarmMotors:
      case InjectedFault::kUncalibrated:
        return false;
      default:
        return true;
    }
  }

  Result<void> reconnect() override {
    device_.reset();
    const std::vector<DeviceDescriptor> found = driver_->find();
    if (found.empty()) return fail(ErrorCode::kNotFound, "no stick is plugged in");
    Result<std::unique_ptr<DriverDevice>> opened = driver_->open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    device_ = std::make_unique<ServedStick>(stick_, *std::move(opened), now_ns_);
    return {};
  }

  [[nodiscard]] double largest_asked_n() const noexcept override {
    return stick_.largest_asked_n();
  }
  [[nodiscard]] std::string_view broken_rule() const noexcept override {
    return stick_.broken_rule();
  }
  /// The stick reports every 8 ms, receives forces that are 8 to 24 ms old, and renders them by
  /// effects that stay unchanged for 8 ms, so the hand moves differently. Transforming a selection
  /// gives the largest difference.
  [[nodiscard]] double tolerance_mm() const noexcept override { return 3.0; }
  [[nodiscard]] PenSample as_said(const PenSample& pen) const noexcept override {
    return FakeStick::as_said(pen);
  }
  /// A requested force is planned every 8 ms, is uploaded within 8 ms more, and can be refused only
  /// then. A plan is valid for 8 ms.
  [[nodiscard]] std::int64_t notice_ns() const noexcept override { return 3 * kServeNs; }
  [[nodiscard]] std::int64_t watchdog_ns() const noexcept override { return 100'000'000; }

 private:
  FakeStick stick_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<ServedStick> device_;
  std::int64_t now_ns_ = 0;
};

}  // namespace

std::unique_ptr<DriverBench> make_evdev_bench(std::vector<FaultWindow> faults) {
  return std::make_unique<EvdevBench>(std::move(faults));
}

}  // namespace felt
