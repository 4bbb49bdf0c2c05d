#include "felt/devices/pantograph/pantograph_driver.h"

#include <string>
#include <utility>

#include "felt/devices/pantograph/pantograph_device.h"
#include "felt/devices/pantograph/ports.h"
#include "felt/driver/device_models.h"

namespace felt {
namespace pantograph {
namespace {

DeviceDescriptor descriptor_of(const Port& port, const BoardModel& model) {
  DeviceDescriptor found;
  found.id = "pantograph:" + std::string(model.id) + ":" + port.name;
  found.driver = "pantograph";
  found.label = std::string(model.label);
  found.model = "2diy";
  found.is_connected = false;  // unknown until the board is opened
  found.capabilities = find_device_model("2diy")->capabilities;
  found.capabilities.workspace_min = model.reach_min;
  found.capabilities.workspace_max = model.reach_max;
  found.capabilities.delay_ticks = 2;  // angles are one period old when they are read
  return found;
}

class PantographDriver final : public Driver {
 public:
  explicit PantographDriver(PantographOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "pantograph"; }
  [[nodiscard]] std::string_view label() const noexcept override { return "Haply 2DIY"; }

  std::vector<DeviceDescriptor> find() override {
    std::vector<DeviceDescriptor> found;
    each([&](const Port& port, const BoardModel& model) {
      found.push_back(descriptor_of(port, model));
      return false;
    });
    return found;
  }

  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions& options) override {
    Result<std::unique_ptr<DriverDevice>> result =
        fail(ErrorCode::kNotFound, "There is no longer a port for \"" + device.id +
                                       "\". \"feltline doctor\" lists the ports.");
    each([&](const Port& port, const BoardModel& model) {
      const DeviceDescriptor one = descriptor_of(port, model);
      if (one.id == device.id) result = open_port(port, model, one, options);
      return one.id == device.id;
    });
    return result;
  }

  /// Returns the plane of motion, which lies on the desk.
  [[nodiscard]] PlaneCalibration default_plane(const DeviceDescriptor& device,
                                               const OpenOptions&) const override {
    const Capabilities& can = device.capabilities;
    const Vec3 middle = 0.5 * (can.workspace_min + can.workspace_max);
    return *PlaneCalibration::from({Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
                                   {middle.x, -middle.y, 0.0});
  }

  std::vector<Finding> diagnose(const SystemView& system) override { return examine(system); }

 private:
  /// Calls `visit` for each port and each possible version, until `visit` returns true.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const Port& port : find_ports(*options_.system)) {
      if (!options_.system->exists(port.path)) continue;
      for (const BoardModel& model : board_models()) {
        if (!port.model.empty() && port.model != model.id) continue;
        if (visit(port, model)) return;
      }
    }
  }

  Result<std::unique_ptr<DriverDevice>> open_port(const Port& port, const BoardModel& model,
                                                  const DeviceDescriptor& descriptor,
                                                  const OpenOptions& options) const {
    auto stream = options_.open(port.path);
    if (!stream) {
      return fail(stream.error().code, "The 2DIY could not be opened: " + stream.error().message +
                                           ". \"feltline doctor\" shows what to do.");
    }
    auto device =
        std::make_unique<PantographDevice>(*std::move(stream), model, descriptor, options);
    if (auto done = device->set_up(); !done) {
      return tl::unexpected(with_context(done.error(), port.path + ": "));
    }
    return device;
  }

  PantographOptions options_;
};

}  // namespace
}  // namespace pantograph

std::unique_ptr<Driver> make_pantograph_driver(PantographOptions options) {
  return std::make_unique<pantograph::PantographDriver>(std::move(options));
}

}  // namespace felt
