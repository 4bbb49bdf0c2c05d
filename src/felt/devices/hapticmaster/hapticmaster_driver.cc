#include "felt/devices/hapticmaster/hapticmaster_driver.h"

#include <string>
#include <utility>

#include "felt/base/constants.h"
#include "felt/devices/hapticmaster/controller_address.h"
#include "felt/devices/hapticmaster/hapticmaster_device.h"
#include "felt/driver/device_models.h"

namespace felt {
namespace hapticmaster {
namespace {

constexpr std::int64_t kOpenNs = kSecond;

DeviceDescriptor descriptor_of(const NetAddress& address) {
  DeviceDescriptor found;
  found.id = "hapticmaster:" + address.text();
  found.driver = "hapticmaster";
  found.label = "Moog HapticMASTER";
  found.model = "hapticmaster";
  found.is_connected = false;  // unknown until it is opened
  found.capabilities = find_device_model("hapticmaster")->capabilities;
  return found;
}

class HapticMasterDriver final : public Driver {
 public:
  explicit HapticMasterDriver(HapticMasterOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "hapticmaster"; }
  [[nodiscard]] std::string_view label() const noexcept override { return "Moog HapticMASTER"; }

  /// Does not connect, because connections could disturb the controller.
  std::vector<DeviceDescriptor> find() override {
    const std::optional<NetAddress> address = controller_address(*options_.system);
    if (!address) return {};
    return {descriptor_of(*address)};
  }

  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions& options) override;

  /// Returns a page that lies flat before the machine, in the middle of the reach.
  [[nodiscard]] PlaneCalibration default_plane(const DeviceDescriptor& device,
                                               const OpenOptions&) const override {
    const Capabilities& can = device.capabilities;
    const Vec3 middle = 0.5 * (can.workspace_min + can.workspace_max);
    return *PlaneCalibration::from({Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}},
                                   {-middle.y, -middle.x, -middle.z});
  }

  std::vector<Finding> diagnose(const SystemView& system) override {
    return examine(system, options_.connect, kOpenNs);
  }

 private:
  HapticMasterOptions options_;
};

Result<Vec3> ask_vector(ControllerLink& link, std::string_view text) {
  const Result<std::string> answer = ask_controller(link, text);
  if (!answer) return tl::unexpected(answer.error());
  const std::optional<Vec3> read = read_vector(*answer);
  if (read) return *read;
  return fail(ErrorCode::kInvalidData,
              "The controller answers \"" + std::string(text) + "\": " + *answer);
}

// Checks that a HapticMASTER answers in the form that this driver expects, and asks for its
// workspace. Nothing moves.
Result<Sector> ask_sector(ControllerLink& link) {
  if (auto state = ask_controller(link, "get state"); !state) {
    return tl::unexpected(state.error());
  }
  const Result<Vec3> r = ask_vector(link, "get workspace_r");
  if (!r) return tl::unexpected(r.error());
  const Result<Vec3> phi = ask_vector(link, "get workspace_phi");
  if (!phi) return tl::unexpected(phi.error());
  const Result<Vec3> z = ask_vector(link, "get workspace_z");
  if (!z) return tl::unexpected(z.error());
  return Sector{*r, *phi, *z};
}

Result<std::unique_ptr<DriverDevice>> HapticMasterDriver::open(const DeviceDescriptor& device,
                                                               const OpenOptions&) {
  const std::string hint = " \"feltline doctor\" shows what to do.";
  const std::optional<NetAddress> address = controller_address(*options_.system);
  if (!address || descriptor_of(*address).id != device.id) {
    return fail(ErrorCode::kNotFound,
                std::string(kAddressVariable) + " no longer names \"" + device.id + "\"." + hint);
  }
  const Connect connect = [make = options_.connect, to = *address] {
    return make(to.host, to.port, kOpenNs);
  };
  auto stream = connect();
  if (!stream) {
    return fail(stream.error().code, "The controller of the HapticMASTER cannot be reached: " +
                                         stream.error().message + "." + hint);
  }
  auto link = std::make_unique<ControllerLink>(*std::move(stream));
  const Result<Sector> sector = ask_sector(*link);
  if (!sector) return tl::unexpected(with_context(sector.error(), address->text()));
  const std::optional<Box> box = inner_box(*sector);
  if (!box) {
    return fail(ErrorCode::kInvalidData, address->text() +
                                             ": the controller reports an impossible workspace. "
                                             "Feltline needs its limits to be safe.");
  }
  DeviceDescriptor opened = descriptor_of(*address);
  opened.capabilities.workspace_min = box->min_mm;
  opened.capabilities.workspace_max = box->max_mm;
  return std::make_unique<HapticMasterDevice>(std::move(link), connect, *sector, std::move(opened));
}

}  // namespace
}  // namespace hapticmaster

std::unique_ptr<Driver> make_hapticmaster_driver(HapticMasterOptions options) {
  return std::make_unique<hapticmaster::HapticMasterDriver>(std::move(options));
}

}  // namespace felt
