#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/constants.h"
#include "felt/devices/hapticmaster/controller_address.h"
#include "felt/devices/hapticmaster/hapticmaster_device.h"
#include "felt/devices/hapticmaster/hapticmaster_driver.h"
#include "felt/driver/device_models.h"
#include "felt/driver/testing/fake_system.h"
#include "tests/devices/drivers/hapticmaster/fake_controller.h"

namespace felt::hapticmaster {

inline constexpr std::int64_t kTickNs = 4 * kMs;

/// Returns a preset with the same frame for page and device, and the mass that the driver sets.
inline StylusPreset desk_preset(double mass_kg) {
  StylusPreset preset{.name = "hapticmaster",
                      .label = "Moog HapticMASTER",
                      .source = "a test",
                      .mechanics = {.mass_kg = mass_kg},
                      .capabilities = find_device_model("hapticmaster")->capabilities};
  preset.capabilities.position_step_mm = 0.0;
  return preset;
}

/// The driver, a fake of the controller and a simulated machine, on a virtual clock with ticks of
/// kTickNs.
class Desk {
 public:
  explicit Desk(FakeControllerOptions with = {}, const std::vector<FaultWindow>& faults = {},
                double mass_kg = 0.3)
      : world(desk_preset(mass_kg), faults),
        controller(world, faults, PlaneCalibration(), std::move(with)) {
    controller.options().guard_watches_ticks = true;
    system.set_environment(kAddressVariable, "192.168.0.25");
    HapticMasterOptions options;
    options.connect = [this](const std::string& host, std::uint16_t port, std::int64_t) {
      return controller.connect(host, port);
    };
    options.system = &system;
    driver = make_hapticmaster_driver(options);
  }

  Result<void> open() {
    auto opened = driver->open(driver->find().at(0), {});
    if (!opened) return tl::unexpected(opened.error());
    device = *std::move(opened);
    return {};
  }
  bool open_at_home() { return open().has_value() && device->find_home().has_value(); }

  struct Ticked {
    tl::expected<PenSample, DeviceFault> read;
    tl::expected<void, DeviceFault> written;
  };
  /// Runs a tick. The next one comes `ns` later.
  Ticked tick(const Force& force = {}, std::int64_t ns = kTickNs) {
    controller.tick(now_ns);
    auto read = device->read(now_ns);
    auto written = device->write(force);
    now_ns += ns;
    return {read, written};
  }
  [[nodiscard]] bool is_off() const {
    return controller.state() == "off" && controller.effects() == 0 &&
           world.held_force() == Force{};
  }
  /// Runs as many ticks as a force needs to rise to this value.
  Ticked push(const Force& force) {
    for (int i = 0; i < 8; ++i) static_cast<void>(tick(force));
    return tick(force);
  }
  [[nodiscard]] double held_n() const { return norm(world.held_force()); }
  /// Returns the fault of the first read() that fails within this number of ticks.
  std::optional<DeviceFault> first_fault(int ticks, const Force& force = {1, 0, 0}) {
    for (int i = 0; i < ticks; ++i) {
      if (const auto read = tick(force).read; !read) return read.error();
    }
    return std::nullopt;
  }

  FakeSystem system;
  FakeWorld world;
  FakeController controller;
  std::unique_ptr<Driver> driver;
  std::unique_ptr<DriverDevice> device;
  std::int64_t now_ns = 0;
};

}  // namespace felt::hapticmaster
