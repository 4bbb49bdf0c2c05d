#include "felt/devices/haply/haply_driver.h"

#include <algorithm>
#include <random>
#include <string>
#include <utility>

#include "felt/devices/haply/haply_device.h"
#include "felt/devices/haply/haply_doctor.h"
#include "felt/devices/haply/service_address.h"
#include "felt/driver/device_models.h"

namespace felt {
namespace haply {
namespace {

constexpr std::int64_t kFindNs =
    100'000'000;  // maximum wait; an unresponsive service is tried only now and then
constexpr std::int64_t kOpenNs = 1'000'000'000;
constexpr int kFindsToSkip = 10;

std::string model_of(const std::string& type) {
  if (type == "inverse3x") return "inverse3";
  return find_device_model(type) != nullptr ? type : std::string();
}

std::string label_of(const std::string& type) {
  if (type == "inverse3") return "Haply Inverse3";
  if (type == "inverse3x") return "Haply Inverse3x";
  if (type == "minverse") return "Haply Minverse";
  return "Haply device (" + (type.empty() ? "of unknown kind" : type) + ")";
}

DeviceDescriptor descriptor_of(const InventoryDevice& device, const std::string& version) {
  DeviceDescriptor found;
  found.id = "haply:" + device.id;
  found.driver = "haply";
  found.label = label_of(device.type);
  found.model = model_of(device.type);
  found.serial = device.id;
  found.version = version.empty() ? std::string() : "Inverse Service " + version;
  if (!device.firmware.empty()) {
    found.version += (found.version.empty() ? "firmware " : ", firmware ") + device.firmware;
  }
  const DeviceModel* model = find_device_model(found.model);
  found.capabilities = (model != nullptr ? *model : generic_device_model()).capabilities;
  found.capabilities.delay_ticks = 2;  // a position is one period old when it is read (HaplyDevice)
  return found;
}

class HaplyDriver final : public Driver {
 public:
  explicit HaplyDriver(HaplyOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "haply"; }
  [[nodiscard]] std::string_view label() const noexcept override {
    return "Haply (Inverse3, Minverse)";
  }
  std::vector<DeviceDescriptor> find() override;
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions& options) override;
  /// Returns a page that lies flat on the desk.
  [[nodiscard]] PlaneCalibration default_plane(const DeviceDescriptor&,
                                               const OpenOptions&) const override {
    return *PlaneCalibration::from({Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}, {});
  }
  std::vector<Finding> diagnose(const SystemView& system) override {
    return examine(system, options_.connect, kOpenNs);
  }

 private:
  std::uint64_t seed() {
    if (options_.seed != 0) return options_.seed++;
    std::random_device random;
    return (std::uint64_t{random()} << 32) | random();
  }
  Result<std::unique_ptr<WebSocket>> open_socket(const Address& address) {
    auto stream = options_.connect(address.host, address.port, kOpenNs);
    if (!stream) return tl::unexpected(stream.error());
    return WebSocket::open(*std::move(stream), address.text(), seed(), kOpenNs);
  }
  std::string version_at(const Address& address) {
    const auto answer = http_get(options_.connect, address, "/version", kFindNs);
    return answer ? read_version(*answer) : std::string();
  }

  HaplyOptions options_;
  int finds_to_skip_ = 0;
  std::vector<DeviceDescriptor> last_found_;
};

std::vector<DeviceDescriptor> HaplyDriver::find() {
  if (finds_to_skip_ > 0) {
    --finds_to_skip_;
    return last_found_;
  }
  last_found_.clear();
  const ServiceAddress address = service_address(*options_.system);
  // HTTP opens no session, so open devices are not disturbed.
  const auto answer = http_get(options_.connect, address.control, "/devices", kFindNs);
  if (!answer) {
    if (answer.error().code == ErrorCode::kIo) finds_to_skip_ = kFindsToSkip;  // it is unresponsive
    return {};
  }
  const std::optional<Inventory> inventory = read_inventory(*answer);
  if (!inventory || inventory->devices.empty()) return {};
  const std::string version = version_at(address.control);
  for (const InventoryDevice& device : inventory->devices) {
    last_found_.push_back(descriptor_of(device, version));
  }
  return last_found_;
}

Result<std::unique_ptr<DriverDevice>> HaplyDriver::open(const DeviceDescriptor& device,
                                                        const OpenOptions&) {
  const ServiceAddress address = service_address(*options_.system);
  const std::string hint =
      " Is Haply's Inverse Service running? \"feltline doctor\" shows what is missing.";
  Connection made;
  const std::string version = version_at(address.control);
  made.version = version_number(version);
  auto control = open_socket(address.control);
  if (!control) {
    return fail(control.error().code,
                "The Inverse Service cannot be reached: " + control.error().message + "." + hint);
  }
  made.control = *std::move(control);
  const auto first = made.control->receive(kOpenNs);
  const std::optional<Inventory> inventory = first ? read_inventory(*first) : std::nullopt;
  if (!inventory) {
    return fail(ErrorCode::kInvalidData, "The Inverse Service at " + address.control.text() +
                                             " does not list its devices." + hint);
  }
  const auto found =
      std::find_if(inventory->devices.begin(), inventory->devices.end(),
                   [&](const InventoryDevice& one) { return "haply:" + one.id == device.id; });
  if (found == inventory->devices.end()) {
    return fail(ErrorCode::kNotFound, "The Inverse Service does not know a device \"" + device.id +
                                          "\". Is it plugged in and switched on?");
  }
  made.device = *found;
  made.descriptor = descriptor_of(*found, version);
  if (!inventory->grips.empty()) made.grip_id = inventory->grips.front();
  if (!made.control->send(first_command(found->id), kOpenNs) ||
      !made.control->receive(kOpenNs).has_value()) {
    return fail(ErrorCode::kIo, "The Inverse Service does not answer the first message." + hint);
  }
  if (auto events = open_socket(address.events)) made.events = *std::move(events);
  return std::make_unique<HaplyDevice>(std::move(made));
}

}  // namespace
}  // namespace haply

std::unique_ptr<Driver> make_haply_driver(HaplyOptions options) {
  return std::make_unique<haply::HaplyDriver>(std::move(options));
}

}  // namespace felt
