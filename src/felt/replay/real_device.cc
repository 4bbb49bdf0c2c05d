#include "felt/replay/real_device.h"

namespace felt {
namespace {

std::string choice_of(const std::vector<std::unique_ptr<Driver>>& drivers) {
  std::string names;
  for (const auto& driver : drivers) {
    for (const DeviceDescriptor& device : driver->find()) {
      if (device.kind == DeviceKind::kForce) names += (names.empty() ? "" : ", ") + device.id;
    }
  }
  return names;
}

Result<DeviceProfile> profile_of(const DeviceDescriptor& device) {
  const Result<std::string> folder = device_profiles_folder();
  if (!folder) return DeviceProfile{.device_id = device.id};
  return load_device_profile(*folder, device.id);
}

}  // namespace

Result<RealDevice> find_real_device(const std::vector<std::unique_ptr<Driver>>& drivers,
                                    const std::string& id) {
  Driver* const driver = driver_of(drivers, id);
  if (driver == nullptr) {
    const std::string choice = choice_of(drivers);
    return fail(ErrorCode::kNotFound,
                "there is no device '" + id + "'; " +
                    (choice.empty() ? "no force device is connected ('feltline devices' lists all "
                                      "devices, including simulated ones)"
                                    : "connected: " + choice));
  }
  std::vector<DeviceDescriptor> found = driver->find();
  const bool is_any = id == driver->name();
  for (DeviceDescriptor& device : found) {
    if (device.id != id && !(is_any && found.size() == 1)) continue;
    if (device.kind != DeviceKind::kForce) {
      return fail(ErrorCode::kUnsupported,
                  "'" + device.id + "' plays cues and cannot produce forces");
    }
    Result<DeviceProfile> profile = profile_of(device);
    if (!profile) return tl::unexpected(profile.error());
    return RealDevice{driver, std::move(device), *std::move(profile)};
  }
  return fail(ErrorCode::kNotFound, "'" + id + "' is not connected: 'feltline doctor " +
                                        std::string(driver->name()) + "' shows what is missing");
}

}  // namespace felt
