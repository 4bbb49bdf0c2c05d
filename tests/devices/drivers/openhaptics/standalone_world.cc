#include "tests/devices/drivers/openhaptics/standalone_world.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "felt/devices/simulated/simulated_stylus.h"
#include "tests/devices/drivers/openhaptics/hd_world.h"

namespace felt {
namespace {

constexpr double kRoundS = 3.0;
constexpr double kRadiusMm = 20.0;
constexpr double kPressMm = -2.5;  // the hand's aim below the desk
constexpr double kLiftMm = 8.0;

bool draws_circles() {
  const char* hand = std::getenv("FAKE_LIBHD_HAND");
  return hand != nullptr && std::strcmp(hand, "circles") == 0;
}

// Sets the aim before each read: still, as a device test requires, or circles on the desk and above
// it.
class HeldStylus final : public Device {
 public:
  [[nodiscard]] std::string_view name() const noexcept override { return stylus_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return stylus_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    const double rounds = 1e-9 * static_cast<double>(now_ns) / kRoundS;
    const double angle = 2.0 * 3.141592653589793 * rounds;
    const Capabilities& device = stylus_.capabilities();
    Vec3 aim = 0.5 * (device.workspace_min + device.workspace_max);
    aim.z = kLiftMm;
    if (draws_) {
      aim.x += kRadiusMm * std::cos(angle);
      aim.y += kRadiusMm * std::sin(angle);
      if (static_cast<std::int64_t>(rounds) % 2 == 1) aim.z = kPressMm;
    }
    stylus_.aim(aim, {}, 0);
    return stylus_.read(now_ns);
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return stylus_.write(force);
  }
  void stop() noexcept override { stylus_.stop(); }

 private:
  bool draws_ = draws_circles();
  SimulatedStylus stylus_{*find_stylus_preset("touch")};
};

class HeldTouch final : public StandaloneWorld {
 public:
  [[nodiscard]] FakeHdModel model() const override {
    return hd_model(stylus_.capabilities(), world_.plane(), "Touch");
  }
  [[nodiscard]] FakeHdWorld world() override { return world_.world(); }

 private:
  HeldStylus stylus_;
  HdWorld world_{stylus_, hd_plane(stylus_.capabilities())};
};

}  // namespace

std::unique_ptr<StandaloneWorld> make_standalone_world() {
  return std::make_unique<HeldTouch>();
}

}  // namespace felt
