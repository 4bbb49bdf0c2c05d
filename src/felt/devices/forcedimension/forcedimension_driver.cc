#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "felt/devices/forcedimension/dhd_device.h"
#include "felt/devices/forcedimension/dhd_doctor.h"
#include "felt/devices/forcedimension/dhd_library.h"
#include "felt/devices/forcedimension/dhd_models.h"
#include "felt/devices/forcedimension/forcedimension.h"
#include "felt/driver/device_models.h"

namespace felt {
namespace {

constexpr std::string_view kName = "forcedimension";
constexpr int kMaxDevices = 64;
constexpr int kLookAgainAfter = 5;
constexpr double kHeaviestPenKg = 0.5;

// Parses a mass such as "0.035". Returns nullopt if it is not plausible.
std::optional<double> mass_from(const std::optional<std::string>& text) {
  double kg = 0.0;
  if (!text) return std::nullopt;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), kg);
  if (error != std::errc() || end != text->data() + text->size()) return std::nullopt;
  return kg >= 0.0 && kg <= kHeaviestPenKg ? std::optional(kg) : std::nullopt;
}

std::string named_library(const ForceDimensionOptions& options, const SystemView& system) {
  if (!options.library.empty()) return options.library;
  return system.environment("FELT_FORCEDIMENSION_LIBRARY").value_or("");
}

// A device at an index of the library's list.
struct Listed {
  DeviceDescriptor descriptor;
  dhd::SystemType type;
};

Listed listed_as(const dhd::Identity& identity, const std::string& version) {
  Listed listed;
  listed.type = dhd::system_type_of(identity.type);
  DeviceDescriptor& d = listed.descriptor;
  d.driver = kName;
  d.model = listed.type.model;
  d.label = listed.type.label;
  if (d.label.empty()) {
    d.label = identity.name.empty()
                  ? "Force Dimension device of type " + std::to_string(identity.type)
                  : "Force Dimension " + identity.name;
  }
  d.version = version;
  const DeviceModel* model = find_device_model(d.model);
  d.capabilities = (model != nullptr ? *model : generic_device_model()).capabilities;
  if (identity.serial) d.serial = std::to_string(*identity.serial);
  d.id = std::string(kName) + ":" + (d.serial.empty() ? d.model : d.serial);
  return listed;
}

Listed listed_as_busy(const std::string& version) {
  Listed listed;
  DeviceDescriptor& d = listed.descriptor;
  d.id = std::string(kName) + ":busy";
  d.driver = kName;
  d.label = "Force Dimension device that another program uses";
  d.version = version;
  d.capabilities = generic_device_model().capabilities;
  return listed;
}

class ForceDimensionDriver final : public Driver {
 public:
  explicit ForceDimensionDriver(ForceDimensionOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return kName; }
  [[nodiscard]] std::string_view label() const noexcept override {
    return "Force Dimension and Novint Falcon";
  }
  std::vector<DeviceDescriptor> find() override;
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions& options) override;
  [[nodiscard]] PlaneCalibration default_plane(const DeviceDescriptor& device,
                                               const OpenOptions& options) const override;
  std::vector<Finding> diagnose(const SystemView& system) override {
    return dhd::diagnose(system, named_library(options_, system), last_refusal_,
                         library_refusal(system));
  }

 private:
  Result<void> load();
  // Returns the reason why an existing library is not used, or an empty string. Does this only if
  // `system` is this computer, because a library of another computer cannot be loaded.
  std::string library_refusal(const SystemView& system) {
    if (&system != &this_system()) return {};
    const auto loaded = load();
    return loaded || loaded.error().code != ErrorCode::kUnsupported ? "" : loaded.error().message;
  }
  void look();

  ForceDimensionOptions options_;
  std::shared_ptr<dhd::Library> library_;
  std::vector<Listed> listed_;  // by index in the library's list
  int counted_ = 0;             // number of devices when listed_ was made
  int passed_over_ = 0;
  std::uint64_t closings_ = 0;  // number of closings when listed_ was made
  std::string last_refusal_;
};

Result<void> ForceDimensionDriver::load() {
  if (library_ != nullptr) return {};
  const SystemView& system = this_system();
  auto library = dhd::Library::load(dhd::library_names(system, named_library(options_, system)));
  if (!library) return tl::unexpected(library.error());
  library_ = *std::move(library);
  return {};
}

// Opens each device briefly to identify it, unless it is open.
void ForceDimensionDriver::look() {
  closings_ = library_->closings();
  listed_.clear();
  last_refusal_.clear();
  const std::string version = library_->version();
  for (int i = 0; i < counted_; ++i) {
    const Result<dhd::Identity> identity = library_->identify(i);
    listed_.push_back(identity ? listed_as(*identity, version) : listed_as_busy(version));
    if (!identity) last_refusal_ = identity.error().message;
    // Older devices have no serial number, so the second device of a kind gets ":falcon-2".
    std::string& id = listed_.back().descriptor.id;
    const std::string first = id;
    const auto is_taken = [&] {
      return std::any_of(listed_.begin(), listed_.end() - 1,
                         [&](const Listed& other) { return other.descriptor.id == id; });
    };
    for (int n = 2; is_taken(); ++n) id = first + "-" + std::to_string(n);
  }
}

std::vector<DeviceDescriptor> ForceDimensionDriver::find() {
  if (!load()) return {};
  // Opening devices to identify them is expensive, so it is only done when their number has
  // changed, when one was closed, and from time to time while one of them cannot be opened.
  const int count = std::clamp(library_->count(), 0, kMaxDevices);
  if (count != counted_ || library_->closings() != closings_ ||
      (!last_refusal_.empty() && ++passed_over_ >= kLookAgainAfter)) {
    counted_ = count;
    passed_over_ = 0;
    look();
  }
  std::vector<DeviceDescriptor> found;
  found.reserve(listed_.size());
  for (const Listed& listed : listed_) found.push_back(listed.descriptor);
  return found;
}

Result<std::unique_ptr<DriverDevice>> ForceDimensionDriver::open(const DeviceDescriptor& device,
                                                                 const OpenOptions&) {
  if (auto loaded = load(); !loaded) {
    return fail(loaded.error().code, "Force Dimension's library: " + loaded.error().message);
  }
  // Identifies all devices again, because another device may have this index now.
  counted_ = std::clamp(library_->count(), 0, kMaxDevices);
  look();
  const auto at = std::find_if(listed_.begin(), listed_.end(), [&](const Listed& listed) {
    return listed.descriptor.id == device.id;
  });
  if (at == listed_.end()) {
    return fail(ErrorCode::kNotFound,
                "\"" + device.id + "\" is not connected" +
                    (last_refusal_.empty() ? "" : ", or could not be opened: " + last_refusal_) +
                    "; 'feltline devices' lists the connected devices");
  }
  const Result<dhd::Id> id = library_->open(static_cast<int>(at - listed_.begin()));
  if (!id) {
    return fail(ErrorCode::kIo, at->descriptor.label + " could not be opened: " +
                                    id.error().message + "; close other programs that use it");
  }
  const std::optional<double> mass_kg =
      options_.pen_mass_kg ? options_.pen_mass_kg
                           : mass_from(this_system().environment("FELT_FORCEDIMENSION_PEN_KG"));
  return std::make_unique<dhd::DhdDevice>(library_, *id, at->descriptor, at->type, mass_kg);
}

PlaneCalibration ForceDimensionDriver::default_plane(const DeviceDescriptor&,
                                                     const OpenOptions&) const {
  // The base stands upright behind the pen, and the page stands in front of it like an easel: right
  // is y, down is -z, and towards the hand is x. The device's frame is right-handed and the page's
  // is left-handed, so the map mirrors.
  return *PlaneCalibration::from({Vec3{0, 1, 0}, Vec3{0, 0, -1}, Vec3{1, 0, 0}}, {});
}

}  // namespace

std::unique_ptr<Driver> make_forcedimension_driver(ForceDimensionOptions options) {
  return std::make_unique<ForceDimensionDriver>(std::move(options));
}

}  // namespace felt
