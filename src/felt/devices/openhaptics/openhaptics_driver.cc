#include "felt/devices/openhaptics/openhaptics_driver.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <utility>

#include "felt/devices/openhaptics/hd_library.h"
#include "felt/devices/openhaptics/openhaptics_device.h"
#include "felt/devices/openhaptics/openhaptics_doctor.h"
#include "felt/devices/openhaptics/openhaptics_models.h"
#include "felt/driver/input_nodes.h"

namespace felt {
namespace {

constexpr std::string_view kName = "openhaptics";
constexpr std::string_view kLibraryVariable = "FELT_OPENHAPTICS_LIBRARY";
constexpr std::string_view kDeviceVariable = "FELT_OPENHAPTICS_DEVICE";
constexpr std::string_view kDefaultId = "openhaptics:default";
constexpr unsigned long kRateHz = 1000;

// The library's own protections of the hand. They are switched on, because another program may have
// switched them off.
constexpr std::array kProtections{
    hd::capability::kMaxForceClamping,     hd::capability::kForceRamping,
    hd::capability::kSoftwareForceLimit,   hd::capability::kOneFrameLimit,
    hd::parameter::kSoftwareVelocityLimit, hd::parameter::kSoftwareImpulseLimit};

std::string name_in(std::string_view id) {
  return std::string(id.substr(std::min(id.size(), kName.size() + 1)));
}

std::string text_of(const HdFunctions& call, hd::Enum what) {
  const char* text = call.get_string(what);
  return text != nullptr ? shown_name(std::string_view(text, strnlen(text, 256))) : std::string();
}

void forget_errors(const HdFunctions& call) {
  drain_errors(call, 64, [](const hd::ErrorInfo&) {});
}

HdLimits limits_of(const HdFunctions& call) {
  HdLimits said;
  call.get_doubles(hd::parameter::kMaxForce, &said.max_force_n);
  call.get_doubles(hd::parameter::kMaxContinuousForce, &said.continuous_force_n);
  call.get_doubles(hd::parameter::kMaxStiffness, &said.max_stiffness_n_per_mm);
  call.get_doubles(hd::parameter::kMaxDamping, &said.max_damping_n_s_per_mm);
  call.get_doubles(hd::parameter::kUsableWorkspace, said.usable_mm);
  call.get_integers(hd::parameter::kUpdateRate, &said.update_rate_hz);
  forget_errors(call);  // older libraries do not have all of these
  return said;
}

class OpenHapticsDriver final : public Driver {
 public:
  explicit OpenHapticsDriver(OpenHapticsOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return kName; }
  [[nodiscard]] std::string_view label() const noexcept override {
    return "3D Systems (OpenHaptics)";
  }

  std::vector<DeviceDescriptor> find() override {
    if (!load()) return {};
    std::vector<DeviceDescriptor> found{closed(std::string(kDefaultId))};
    for (const std::string& name : configured_devices(this_system())) {
      if (!is_usual(name)) found.push_back(closed(std::string(kName) + ":" + name));
    }
    return found;
  }

  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions&) override {
    auto library = load();
    if (!library) {
      return fail(library.error().code,
                  "OpenHaptics, the library of 3D Systems, is missing: " + library.error().message +
                      ". \"feltline doctor\" shows what to do");
    }
    if (!(*library)->take()) {
      return fail(ErrorCode::kUnsupported,
                  "another OpenHaptics device is already open in this program, and that library "
                  "supports only one at a time: close the other one first");
    }
    auto opened = open_with(*library, device);
    if (!opened) (*library)->give_back();
    return opened;
  }

  [[nodiscard]] PlaneCalibration default_plane(const DeviceDescriptor& device,
                                               const OpenOptions&) const override {
    return openhaptics_plane(device.capabilities);
  }

  std::vector<Finding> diagnose(const SystemView& system) override {
    return diagnose_openhaptics(system, library_names(system), refusal(system));
  }

 private:
  static bool is_usual(std::string_view name) {
    return name == "Default Device" || name == "Default PHANToM" || name == "default";
  }

  [[nodiscard]] std::string setting(const std::string& own, std::string_view variable,
                                    const SystemView& system) const {
    return own.empty() ? system.environment(variable).value_or("") : own;
  }
  [[nodiscard]] std::vector<std::string> library_names(const SystemView& system) const {
    const std::string named = setting(options_.library, kLibraryVariable, system);
    return named.empty() ? openhaptics_library_names() : std::vector<std::string>{named};
  }

  // Returns the reason why an existing library is not used, or an empty string. Does this only if
  // `system` is this computer, because a library of another one cannot be loaded.
  std::string refusal(const SystemView& system) {
    if (&system != &this_system()) return {};
    const auto loaded = load();
    return loaded || loaded.error().code != ErrorCode::kUnsupported ? "" : loaded.error().message;
  }

  Result<std::shared_ptr<HdLibrary>> load() {
    if (library_) return library_;
    auto loaded = HdLibrary::load(library_names(this_system()));
    if (loaded) library_ = *loaded;
    return loaded;
  }

  // Returns the description of a closed device, with the values that it reported when it was last
  // open.
  [[nodiscard]] DeviceDescriptor closed(std::string id) const {
    DeviceDescriptor device;
    if (const auto known = known_.find(id); known != known_.end()) {
      device = known->second;
    } else {
      device.label = id == kDefaultId ? "3D Systems device" : "3D Systems \"" + name_in(id) + "\"";
      device.capabilities = generic_device_model().capabilities;
      device.driver = kName;
      device.id = std::move(id);
    }
    const bool is_open = library_ && library_->is_taken() && device.id == open_id_;
    device.is_connected = is_open || touch_is_on_usb(this_system());
    return device;
  }

  // Returns the names to try. The maker's name for "the first device" differs between drivers, so
  // several are tried.
  [[nodiscard]] std::vector<std::optional<std::string>> names_for(std::string_view id) const {
    if (id != kDefaultId) return {name_in(id)};
    std::vector<std::optional<std::string>> names{std::nullopt, "Default PHANToM",
                                                  "Default Device"};
    const std::string own = setting(options_.device, kDeviceVariable, this_system());
    if (!own.empty()) names.emplace_back(own);
    return names;
  }

  Result<std::unique_ptr<DriverDevice>> open_with(const std::shared_ptr<HdLibrary>& library,
                                                  const DeviceDescriptor& device) {
    const PlainNumbers plain;
    const HdFunctions& call = library->call();
    forget_errors(call);
    std::string tried;
    for (const std::optional<std::string>& name : names_for(device.id)) {
      const hd::Handle handle = call.init_device(name ? name->c_str() : nullptr);
      const std::string words = drained_words(call);
      if (handle != hd::kNoHandle && words.empty()) {
        return std::make_unique<OpenHapticsDevice>(library, handle, prepared(call, device));
      }
      if (handle != hd::kNoHandle) call.disable_device(handle);
      forget_errors(call);
      tried += (tried.empty() ? "" : "; ") + (name ? "\"" + *name + "\"" : "the first device") +
               ": " + (words.empty() ? "no device" : words);
    }
    return fail(ErrorCode::kNotFound,
                "no device by 3D Systems could be opened (" + tried +
                    "). Make sure that it is plugged in and switched on, and that no other program "
                    "uses it. \"feltline doctor\" shows more");
  }

  DeviceDescriptor prepared(const HdFunctions& call, DeviceDescriptor device) {
    const std::string type = text_of(call, hd::parameter::kModelType);
    const DeviceModel& model = openhaptics_model(type);
    device.driver = kName;
    device.model = model.id;
    device.label =
        &model == &generic_device_model() && !type.empty() ? type : std::string(model.label);
    device.serial = text_of(call, hd::parameter::kSerialNumber);
    device.version = text_of(call, hd::parameter::kVersion);
    device.is_connected = true;
    device.has_own_frame = true;
    for (const hd::Enum protection : kProtections) {
      if (call.is_enabled(protection) == hd::kFalse) call.enable(protection);
    }
    call.set_scheduler_rate(kRateHz);
    forget_errors(call);  // it is not an error if it cannot be set
    device.capabilities = openhaptics_capabilities(model.capabilities, limits_of(call));
    open_id_ = device.id;
    known_[device.id] = device;
    return device;
  }

  OpenHapticsOptions options_;
  std::shared_ptr<HdLibrary> library_;
  std::map<std::string, DeviceDescriptor, std::less<>> known_;  // as reported while open
  std::string open_id_;                                         // the newest one
};

}  // namespace

std::unique_ptr<Driver> make_openhaptics_driver(OpenHapticsOptions options) {
  return std::make_unique<OpenHapticsDriver>(std::move(options));
}

std::vector<std::string> openhaptics_library_names() {
  return {"libHD.so", "libHD.so.3.4", "libHD.so.3.0"};
}

}  // namespace felt
