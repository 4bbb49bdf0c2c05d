#include "tests/devices/drivers/openhaptics_bench.h"

#include <array>
#include <utility>

#include "felt/devices/openhaptics/openhaptics_device.h"
#include "felt/devices/openhaptics/openhaptics_driver.h"
#include "tests/devices/drivers/openhaptics/fake_slots.h"
#include "tests/devices/drivers/openhaptics/hd_world.h"

namespace felt {
namespace {

struct Model {
  std::string_view preset;
  const char* type;  // the type that the device reports
};
constexpr std::array kModels{Model{"touch", "Touch"}, Model{"touch-x", "Geomagic Touch X"},
                             Model{"premium", "PHANToM Premium 1.5"}};

class OpenHapticsBench final : public DriverBench {
 public:
  explicit OpenHapticsBench(std::vector<FaultWindow> faults) : faults_(std::move(faults)) {
    plug_in(kModels[0]);
    static_cast<void>(reconnect());
  }
  ~OpenHapticsBench() override { close(); }

  [[nodiscard]] std::string_view name() const noexcept override { return "openhaptics"; }
  [[nodiscard]] DriverDevice* device() noexcept override { return device_.get(); }
  [[nodiscard]] PlaneCalibration plane() const noexcept override { return world_->hd.plane(); }
  [[nodiscard]] HandInput& hand() noexcept override { return world_->world.stylus(); }
  [[nodiscard]] FakeWorld& world() noexcept override { return world_->world; }

  // Between two of these calls, the test acts as the library's scheduler.
  void before_tick(std::int64_t now_ns) noexcept override {
    end_tick();
    fake_->open_tick(now_ns);
    tick_is_open_ = true;
    if (ticked_ != nullptr) ticked_->begin_tick();
  }

  /// The library does not report times.
  [[nodiscard]] bool shows(InjectedFault fault) const noexcept override {
    return fault != InjectedFault::kTimeBackwards && !is_of_a_service(fault);
  }

  Result<void> reconnect() override {
    close();
    const std::vector<DeviceDescriptor> found = driver_->find();
    if (found.empty()) return fail(ErrorCode::kNotFound, "the driver finds nothing");
    auto opened = driver_->open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    // The loop runs without a callback, because the test makes those calls.
    const auto nobody = [](void*) noexcept {};
    if (auto started = (*opened)->loop_host()->start_loop(nobody, nullptr); !started) {
      return started;
    }
    device_ = *std::move(opened);
    ticked_ = dynamic_cast<OpenHapticsDevice*>(device_.get());
    return {};
  }

  [[nodiscard]] double largest_asked_n() const noexcept override {
    return fake_->largest_asked_n();
  }
  [[nodiscard]] std::string_view broken_rule() const noexcept override {
    return fake_->broken_rule();
  }
  /// The rotation into the vendor's axes exchanges coordinates, and the shift rounds positions by
  /// some 1e-14 mm: occasionally the hand goes one step of the sensor (0.055 mm) further.
  [[nodiscard]] double tolerance_mm() const noexcept override { return 0.1; }

  [[nodiscard]] std::vector<std::string_view> other_models() const override {
    std::vector<std::string_view> names;
    for (std::size_t i = 1; i < kModels.size(); ++i) names.push_back(kModels[i].preset);
    return names;
  }
  Result<void> reconnect_as(std::string_view preset) override {
    for (const Model& model : kModels) {
      if (model.preset != preset) continue;
      close();
      plug_in(model);
      return reconnect();
    }
    return DriverBench::reconnect_as(preset);
  }

 private:
  struct World {
    World(const StylusPreset& preset, std::vector<FaultWindow> faults)
        : world(preset, std::move(faults)), hd(world.device(), hd_plane(preset.capabilities)) {}
    FakeWorld world;
    HdWorld hd;
  };

  void plug_in(const Model& model) {
    const StylusPreset& preset = *find_stylus_preset(model.preset);
    world_ = std::make_unique<World>(preset, faults_);
    const FakeHdModel said = hd_model(preset.capabilities, world_->hd.plane(), model.type);
    const FakeHdWorld behind = world_->hd.world();
    fake_->plug_in(&said, &behind);
  }
  void end_tick() noexcept {
    if (!std::exchange(tick_is_open_, false)) return;
    if (ticked_ != nullptr) ticked_->end_tick();
    fake_->close_tick();
  }
  void close() {
    end_tick();
    ticked_ = nullptr;
    device_.reset();
  }

  std::vector<FaultWindow> faults_;
  FakeSlot fake_;
  std::unique_ptr<World> world_;
  std::unique_ptr<Driver> driver_ =
      make_openhaptics_driver({.library = fake_.path(), .device = {}});
  std::unique_ptr<DriverDevice> device_;
  OpenHapticsDevice* ticked_ = nullptr;
  bool tick_is_open_ = false;
};

}  // namespace

std::unique_ptr<DriverBench> make_openhaptics_bench(std::vector<FaultWindow> faults) {
  return std::make_unique<OpenHapticsBench>(std::move(faults));
}

}  // namespace felt
