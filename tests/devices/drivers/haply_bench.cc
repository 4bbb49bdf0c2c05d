#include "tests/devices/drivers/haply_bench.h"

#include <utility>

#include "felt/devices/haply/haply_driver.h"
#include "felt/driver/device_models.h"
#include "felt/driver/testing/fake_system.h"
#include "tests/devices/drivers/haply/fake_service.h"

namespace felt {
namespace {

constexpr std::string_view kOtherModel = "minverse";

// Puts the origin of the service in the middle of the simulated pen's reach.
PlaneCalibration plane_over(const StylusPreset& preset) {
  const Vec3 middle = 0.5 * (preset.capabilities.workspace_min + preset.capabilities.workspace_max);
  return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, middle);
}

StylusPreset inverse_preset(std::string_view model) {
  StylusPreset preset = *find_stylus_preset("inverse3");
  if (model == preset.name) return preset;
  preset.name = kOtherModel;
  const Capabilities& device = find_device_model(model)->capabilities;
  const Vec3 reach = device.workspace_max - device.workspace_min;
  preset.capabilities = device;
  preset.capabilities.workspace_min = {-10.0, -10.0, -0.5 * reach.z};
  preset.capabilities.workspace_max = preset.capabilities.workspace_min + reach;
  return preset;
}

class HaplyBench final : public DriverBench {
 public:
  HaplyBench(std::string_view model, std::vector<FaultWindow> faults) : faults_(std::move(faults)) {
    plug_in(model);
    static_cast<void>(reconnect());
  }
  ~HaplyBench() override { device_.reset(); }

  [[nodiscard]] std::string_view name() const noexcept override { return "haply"; }
  [[nodiscard]] DriverDevice* device() noexcept override { return device_.get(); }
  [[nodiscard]] PlaneCalibration plane() const noexcept override {
    return plane_over(world_->preset());
  }
  [[nodiscard]] HandInput& hand() noexcept override { return world_->stylus(); }
  [[nodiscard]] FakeWorld& world() noexcept override { return *world_; }
  void before_tick(std::int64_t now_ns) noexcept override { service_->tick(now_ns); }
  /// Its messages contain neither times nor motor temperatures.
  [[nodiscard]] bool shows(InjectedFault fault) const noexcept override {
    return fault != InjectedFault::kTimeBackwards && fault != InjectedFault::kWarmMotors;
  }
  Result<void> reconnect() override {
    device_.reset();
    const std::vector<DeviceDescriptor> found = driver_->find();
    if (found.empty()) return fail(ErrorCode::kNotFound, "no device is found");
    Result<std::unique_ptr<DriverDevice>> opened = driver_->open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    device_ = *std::move(opened);
    return {};
  }
  [[nodiscard]] double largest_asked_n() const noexcept override {
    return service_->largest_asked_n();
  }
  [[nodiscard]] std::string_view broken_rule() const noexcept override {
    if (service_->ignored_forces() > 0) return "a force that the service does not understand";
    return service_->broken_rule();
  }
  /// A state is a period old when the driver reads it, so the plane pushes a period later: the pen
  /// touches down deeper, and its line begins wider (0.30 mm). Commands are in micronewtons.
  [[nodiscard]] double tolerance_mm() const noexcept override { return 0.4; }
  [[nodiscard]] std::optional<Force> last_asked() const override {
    return plane().turn_to_page(service_->newest_force());
  }
  [[nodiscard]] std::int64_t notice_ns() const noexcept override {
    return device_ ? device_->capabilities().period_ns : 1'000'000;
  }
  /// The force stays off until the service has been prompt for a second.
  [[nodiscard]] std::int64_t stays_off_ns(InjectedFault fault) const noexcept override {
    const bool is_late = is_of_a_service(fault) || fault == InjectedFault::kNoAnswer;
    return is_late ? 1'200'000'000 : 0;
  }
  [[nodiscard]] std::int64_t watchdog_ns() const noexcept override {
    return service_->options().watchdog_ns;
  }
  [[nodiscard]] bool stands_still() const noexcept override { return service_->stands_still(); }
  [[nodiscard]] std::vector<std::string_view> other_models() const override {
    return {kOtherModel};
  }
  Result<void> reconnect_as(std::string_view model) override {
    device_.reset();
    plug_in(model);
    return reconnect();
  }

 private:
  void plug_in(std::string_view model) {
    service_.reset();
    world_ = std::make_unique<FakeWorld>(inverse_preset(model), faults_);
    haply::FakeServiceOptions options;
    options.type = model;
    if (model == kOtherModel) options.device_id = "0777";
    service_ = std::make_unique<haply::FakeService>(*world_, faults_, plane_over(world_->preset()),
                                                    options);
    HaplyOptions haply;
    haply.connect = [this](const std::string& host, std::uint16_t port, std::int64_t) {
      return service_->connect(host, port);
    };
    haply.system = &system_;
    haply.seed = 1;
    driver_ = make_haply_driver(haply);
  }

  std::vector<FaultWindow> faults_;
  FakeSystem system_;
  std::unique_ptr<FakeWorld> world_;
  std::unique_ptr<haply::FakeService> service_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<DriverDevice> device_;
};

}  // namespace

std::unique_ptr<DriverBench> make_haply_bench(std::vector<FaultWindow> faults) {
  return std::make_unique<HaplyBench>("inverse3", std::move(faults));
}

}  // namespace felt
