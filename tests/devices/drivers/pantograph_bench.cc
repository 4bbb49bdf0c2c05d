#include "tests/devices/drivers/pantograph_bench.h"

#include <string>
#include <utility>

#include "felt/devices/pantograph/pantograph_driver.h"
#include "felt/devices/simulated/held_body.h"
#include "felt/driver/device_models.h"
#include "felt/driver/testing/fake_system.h"
#include "tests/devices/drivers/pantograph/fake_board.h"

namespace felt {
namespace {

using pantograph::BoardModel;
using pantograph::FakeBoard;
using pantograph::find_board_model;

constexpr double kDownMm = -0.25, kUpMm = 0.25;

// Returns a preset with the board's reach as the page; above and below it moves the hand that holds
// a key.
StylusPreset preset_of(const BoardModel& model) {
  StylusPreset preset{.name = "2diy",
                      .label = "Haply 2DIY",
                      .source = "docs/design/devices.md#pantograph-board",
                      .mechanics = {.mass_kg = 0.06, .friction_n = 0.05},
                      .capabilities = find_device_model("2diy")->capabilities};
  Capabilities& can = preset.capabilities;
  can.sensed_axes = 3;
  can.workspace_min = {-10.0, -10.0, -30.0};
  can.workspace_max = can.workspace_min + (model.reach_max - model.reach_min) + Vec3{0, 0, 60};
  return preset;
}

// x to the left, y towards the user; the middle of the reach is in the middle of the preset's
// workspace.
PlaneCalibration plane_over(const StylusPreset& preset, const BoardModel& model) {
  const Vec3 page = 0.5 * (preset.capabilities.workspace_min + preset.capabilities.workspace_max);
  const Vec3 reach = 0.5 * (model.reach_min + model.reach_max);
  return *PlaneCalibration::from({Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
                                 {page.x + reach.x, page.y - reach.y, 0.0});
}

class PantographBench final : public DriverBench {
 public:
  explicit PantographBench(std::vector<FaultWindow> faults) : faults_(std::move(faults)) {
    plug_in("v1");
    static_cast<void>(reconnect());
  }
  ~PantographBench() override { device_.reset(); }

  [[nodiscard]] std::string_view name() const noexcept override { return "pantograph"; }
  [[nodiscard]] DriverDevice* device() noexcept override { return device_.get(); }
  [[nodiscard]] PlaneCalibration plane() const noexcept override {
    return plane_over(world_->preset(), *model_);
  }
  [[nodiscard]] HandInput& hand() noexcept override { return world_->stylus(); }
  [[nodiscard]] FakeWorld& world() noexcept override { return *world_; }
  /// The user holds the key down while the hand is in the plane.
  void before_tick(std::int64_t now_ns) noexcept override {
    board_->tick(now_ns);
    if (device_) device_->set_pen_down(world_->stylus().body().position().z < 0.0);
  }
  /// It reports two angles, but no heights, velocities, times, buttons, temperatures or brakes. Its
  /// encoders cannot lose their count while they have power.
  [[nodiscard]] bool shows(InjectedFault fault) const noexcept override {
    if (is_of_a_service(fault)) return false;
    switch (fault) {
      case InjectedFault::kInfinite:
      case InjectedFault::kStuckAxis:
      case InjectedFault::kTimeBackwards:
      case InjectedFault::kButtonBounce:
      case InjectedFault::kButtonStuck:
      case InjectedFault::kForcesOff:
      case InjectedFault::kWarmMotors:
      case InjectedFault::kUncalibrated:
      case InjectedFault::kDenormal:
        return false;
      default:
        return true;
    }
  }
  Result<void> reconnect() override {
    device_.reset();
    const std::vector<DeviceDescriptor> found = driver_->find();
    if (found.empty()) return fail(ErrorCode::kNotFound, "no port is found");
    Result<std::unique_ptr<DriverDevice>> opened = driver_->open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    if (auto home = (*opened)->find_home(); !home) return home;
    device_ = *std::move(opened);
    return {};
  }
  [[nodiscard]] double largest_asked_n() const noexcept override {
    return board_->largest_asked_n();
  }
  [[nodiscard]] std::string_view broken_rule() const noexcept override {
    return board_->broken_rule();
  }
  [[nodiscard]] std::optional<Force> last_asked() const override {
    return plane().turn_to_page(board_->newest_force());
  }
  /// Lines that are drawn, erased, widened and moved differ by 0.3 mm, because angles are a period
  /// old when they are read and come in counts of 0.02 to 0.04 mm. A line that is pulled
  /// (pull_end_and_home) differs by 0.89 mm, because the pull depends on the exact point that it
  /// grips; with finer encoders it is 0.17 mm.
  [[nodiscard]] double tolerance_mm() const noexcept override { return 0.95; }
  [[nodiscard]] PenSample as_said(const PenSample& pen) const noexcept override {
    PenSample said = pen;
    said.position.z = pen.position.z < 0.0 ? kDownMm : kUpMm;
    said.velocity.z = 0.0;
    said.buttons = 0;
    said.pressure.reset();
    return said;
  }
  [[nodiscard]] std::int64_t notice_ns() const noexcept override { return 1'000'000; }
  [[nodiscard]] std::vector<std::string_view> other_models() const override { return {"v3"}; }
  Result<void> reconnect_as(std::string_view model) override {
    device_.reset();
    plug_in(model);
    return reconnect();
  }

 private:
  void plug_in(std::string_view model) {
    board_.reset();
    model_ = find_board_model(model);
    world_ = std::make_unique<FakeWorld>(preset_of(*model_), faults_);
    board_ = std::make_unique<FakeBoard>(*world_, faults_, *model_, plane());
    system_.add_file("/dev/ttyACM0");
    system_.set_environment("FELT_PANTOGRAPH_PORT", "/dev/ttyACM0:" + std::string(model));
    PantographOptions options;
    options.open = [this](const std::string& path) { return board_->open(path); };
    options.system = &system_;
    driver_ = make_pantograph_driver(options);
  }

  std::vector<FaultWindow> faults_;
  FakeSystem system_;
  const BoardModel* model_ = nullptr;
  std::unique_ptr<FakeWorld> world_;
  std::unique_ptr<FakeBoard> board_;
  std::unique_ptr<Driver> driver_;
  std::unique_ptr<DriverDevice> device_;
};

}  // namespace

std::unique_ptr<DriverBench> make_pantograph_bench(std::vector<FaultWindow> faults) {
  return std::make_unique<PantographBench>(std::move(faults));
}

}  // namespace felt
