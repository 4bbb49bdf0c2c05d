#include "tests/devices/drivers/hapticmaster_bench.h"

#include <string>
#include <utility>

#include "felt/devices/hapticmaster/hapticmaster_driver.h"
#include "felt/driver/device_models.h"
#include "felt/driver/testing/fake_system.h"
#include "tests/devices/drivers/hapticmaster/fake_controller.h"

namespace felt {
namespace {

// The virtual mass in the bench is smaller than the 3 kg that the driver sets, because the
// simulated hand, which is a spring without a will of its own, would swing with such a mass for
// seconds.
constexpr double kMassKg = 0.12;

StylusPreset machine_preset() {
  StylusPreset preset{.name = "hapticmaster",
                      .label = "Moog HapticMASTER",
                      .source = "docs/design/devices.md#hapticmaster-protocol",
                      .mechanics = {.mass_kg = kMassKg, .friction_n = 0.05},
                      .capabilities = find_device_model("hapticmaster")->capabilities};
  preset.capabilities.workspace_min = {-10.0, -10.0, -80.0};
  preset.capabilities.workspace_max = {250.0, 250.0, 80.0};
  return preset;
}

// The page lies flat; x of the machine points towards the user, y to the right.
PlaneCalibration machine_plane(const StylusPreset& preset) {
  const Vec3 middle = 0.5 * (preset.capabilities.workspace_min + preset.capabilities.workspace_max);
  return *PlaneCalibration::from({Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, middle);
}

class HapticMasterBench final : public DriverBench {
 public:
  explicit HapticMasterBench(std::vector<FaultWindow> faults)
      : world_(machine_preset(), faults),
        controller_(world_, std::move(faults), machine_plane(world_.preset())) {
    system_.set_environment("FELT_HAPTICMASTER_ADDRESS", "192.168.0.25");
    HapticMasterOptions options;
    options.connect = [this](const std::string& host, std::uint16_t port, std::int64_t) {
      return controller_.connect(host, port);
    };
    options.system = &system_;
    driver_ = make_hapticmaster_driver(options);
    static_cast<void>(reconnect());
  }
  ~HapticMasterBench() override { device_.reset(); }

  [[nodiscard]] std::string_view name() const noexcept override { return "hapticmaster"; }
  [[nodiscard]] DriverDevice* device() noexcept override { return device_.get(); }
  [[nodiscard]] PlaneCalibration plane() const noexcept override {
    return machine_plane(world_.preset());
  }
  [[nodiscard]] HandInput& hand() noexcept override { return world_.stylus(); }
  [[nodiscard]] FakeWorld& world() noexcept override { return world_; }
  void before_tick(std::int64_t now_ns) noexcept override { controller_.tick(now_ns); }
  /// Its answers contain no times, buttons or temperatures, and seven decimals.
  [[nodiscard]] bool shows(InjectedFault fault) const noexcept override {
    switch (fault) {
      case InjectedFault::kTimeBackwards:
      case InjectedFault::kButtonBounce:
      case InjectedFault::kButtonStuck:
      case InjectedFault::kWarmMotors:
      case InjectedFault::kDenormal:
        return false;
      default:
        return true;
    }
  }
  Result<void> reconnect() override {
    device_.reset();
    const std::vector<DeviceDescriptor> found = driver_->find();
    if (found.empty()) return fail(ErrorCode::kNotFound, "no address");
    Result<std::unique_ptr<DriverDevice>> opened = driver_->open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    if (auto home = (*opened)->find_home(); !home) return home;
    device_ = *std::move(opened);
    return {};
  }
  [[nodiscard]] double largest_asked_n() const noexcept override {
    return controller_.largest_asked_n();
  }
  [[nodiscard]] std::string_view broken_rule() const noexcept override {
    return controller_.broken_rule();
  }
  [[nodiscard]] std::optional<Force> last_asked() const override {
    return plane().turn_to_page(controller_.newest_force());
  }
  /// Answers are rounded to 0.1 um, commands to a micronewton. Lines that are pulled, moved or
  /// snapped differ by 0.18 mm, because they depend on the exact point that the pen grips.
  [[nodiscard]] double tolerance_mm() const noexcept override { return 0.3; }
  [[nodiscard]] PenSample as_said(const PenSample& pen) const noexcept override {
    PenSample said = pen;
    said.buttons = 0;
    said.pressure.reset();
    return said;
  }
  /// The state is asked for in every second tick; an error comes with the next answers.
  [[nodiscard]] std::int64_t notice_ns() const noexcept override {
    return 2 * find_device_model("hapticmaster")->capabilities.period_ns;
  }
  /// The force stays off until the controller has been prompt for a second.
  [[nodiscard]] std::int64_t stays_off_ns(InjectedFault fault) const noexcept override {
    const bool is_late = is_of_a_service(fault) || fault == InjectedFault::kNoAnswer;
    return is_late ? 1'200'000'000 : 0;
  }
  [[nodiscard]] bool stands_still() const noexcept override { return controller_.stands_still(); }

 private:
  FakeSystem system_;
  FakeWorld world_;
  hapticmaster::FakeController controller_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<DriverDevice> device_;
};

}  // namespace

std::unique_ptr<DriverBench> make_hapticmaster_bench(std::vector<FaultWindow> faults) {
  return std::make_unique<HapticMasterBench>(std::move(faults));
}

}  // namespace felt
