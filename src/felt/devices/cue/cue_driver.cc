#include "felt/devices/cue/cue_driver.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "felt/devices/cue/evdev_cues.h"
#include "felt/devices/cue/hid_haptics.h"
#include "felt/devices/cue/hidpp_mouse.h"
#include "felt/driver/cue_device.h"
#include "felt/driver/input_nodes.h"
#include "felt/driver/machine_checks.h"

namespace felt {
namespace {

constexpr std::uint16_t kLogitech = 0x046D;
constexpr std::uint16_t kMouseProduct = 0xB042;     // MX Master 4, over Bluetooth
constexpr std::uint16_t kReceiverProduct = 0xC548;  // Bolt
constexpr KernelVersion kKnowsTouchpads{6, 18};

enum class CueRoute : std::uint8_t { kHid, kMouse, kReceiver, kHapticPad, kRumble };

struct FoundCues {
  CueRoute route = CueRoute::kHid;
  std::string path, id, label, serial;
  std::string rule;  ///< a udev rule that would let the user open the device
};

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::optional<HapticReports> reports_of(const HidrawNode& node) {
  const Result<HidDescriptor> descriptor = read_hid_descriptor(bytes_of(node.descriptor));
  return descriptor ? HapticReports::find(*descriptor) : std::nullopt;
}

/// Returns true if the node accepts HID++ messages. A mouse has several nodes, and only one of them
/// does.
bool speaks_hidpp(const HidrawNode& node) {
  const Result<HidDescriptor> descriptor = read_hid_descriptor(bytes_of(node.descriptor));
  return descriptor && descriptor->report_bytes(HidReportKind::kOutput, HidppMouse::kLongReport) ==
                           HidppMouse::kBytes;
}

/// Returns a udev rule that matches the kernel's name of the HID device, because that name exists
/// on every bus.
std::string hidraw_rule(const HidrawNode& node) {
  std::string both = vendor_and_product(node.vendor, node.product);
  std::transform(both.begin(), both.end(), both.begin(), [](char c) {
    return c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return "KERNEL==\"hidraw*\", KERNELS==\"*:" + both + ".*\", TAG+=\"uaccess\"\n";
}

std::string event_rule(const InputNode& node) {
  const std::string both = vendor_and_product(node.vendor, node.product);
  return "KERNEL==\"event*\", SUBSYSTEM==\"input\", ATTRS{id/vendor}==\"" + both.substr(0, 4) +
         "\", ATTRS{id/product}==\"" + both.substr(5) + "\", TAG+=\"uaccess\"\n";
}

bool is_haptic_pad(const InputNode& node) {
  return node.effects[evdev::kFfHaptic];
}

/// Returns true if the kernel's own driver plays waveforms on this device. We then use the kernel's
/// driver instead of raw reports.
bool is_the_kernels(const HidrawNode& node, const std::vector<InputNode>& inputs) {
  return !node.hid.empty() &&
         std::any_of(inputs.begin(), inputs.end(), [&](const InputNode& input) {
           return input.hid == node.hid && is_haptic_pad(input);
         });
}

class Finder {
 public:
  explicit Finder(const SystemView& system) : inputs_(input_nodes(system)) {
    for (const HidrawNode& node : hidraw_nodes(system)) look_at(node);
    for (const InputNode& node : inputs_) look_at(node);
  }

  std::vector<FoundCues> found;
  bool pad_waits_for_kernel = false;  ///< a haptic touchpad that the kernel does not drive

 private:
  void look_at(const HidrawNode& node) {
    if (node.vendor == kLogitech &&
        (node.product == kMouseProduct || node.product == kReceiverProduct)) {
      if (!speaks_hidpp(node)) return;
      const bool is_receiver = node.product == kReceiverProduct;
      add(is_receiver ? CueRoute::kReceiver : CueRoute::kMouse, node.path, "hidpp", node.vendor,
          node.product, node.unique,
          is_receiver ? "Logitech Bolt receiver (MX Master 4)" : "Logitech MX Master 4",
          hidraw_rule(node));
      return;
    }
    const std::optional<HapticReports> reports = reports_of(node);
    if (!reports || is_the_kernels(node, inputs_)) return;
    if (reports->is_touchpad()) {
      // A touchpad plays its own clicks when it is pressed, so we use a touchpad only if the kernel
      // drives its waveforms.
      pad_waits_for_kernel = true;
      return;
    }
    const std::string name = node.name.empty() ? std::string() : " (" + node.name + ")";
    add(CueRoute::kHid, node.path, "hid", node.vendor, node.product, node.unique,
        "Haptic " + std::string(reports->kind()) + name, hidraw_rule(node));
  }

  void look_at(const InputNode& node) {
    const bool pushes = node.effects[evdev::kFfConstant] || node.effects[evdev::kFfSpring];
    if (is_haptic_pad(node)) {
      add(CueRoute::kHapticPad, node.path, "pad", node.vendor, node.product, node.unique,
          node.name.empty() ? "Haptic touchpad" : node.name, event_rule(node));
    } else if (node.effects[evdev::kFfRumble] && !pushes) {
      add(CueRoute::kRumble, node.path, "rumble", node.vendor, node.product, node.unique,
          (node.name.empty() ? "Game controller" : node.name) + " (rumble)", event_rule(node));
    }
  }

  void add(CueRoute route, const std::string& path, const std::string& kind, std::uint16_t vendor,
           std::uint16_t product, const std::string& serial, const std::string& label,
           const std::string& rule) {
    std::string id = "cue:" + kind + "-" + vendor_and_product(vendor, product);
    if (!serial.empty()) id += "-" + serial;
    const auto same = std::count_if(found.begin(), found.end(), [&](const FoundCues& other) {
      return other.id == id || other.id.starts_with(id + "#");
    });
    if (same > 0) id += "#" + std::to_string(same + 1);
    found.push_back({route, path, std::move(id), label, serial, rule});
  }

  std::vector<InputNode> inputs_;
};

std::string rules_path() {
  return "/etc/udev/rules.d/70-feltline-haptics.rules";
}

class CueDriver final : public Driver {
 public:
  explicit CueDriver(CueOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "cue"; }
  [[nodiscard]] std::string_view label() const noexcept override {
    return "Haptic pens, touchpads, mice and game controllers";
  }

  std::vector<DeviceDescriptor> find() override {
    std::vector<DeviceDescriptor> all;
    for (const FoundCues& found : Finder(system()).found) all.push_back(descriptor_of(found));
    return all;
  }

  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions&) override {
    return fail(
        ErrorCode::kUnsupported,
        "\"" + device.id +
            "\" plays waveforms and cannot push, so it cannot be used for drawing with force");
  }

  Result<std::unique_ptr<CueDevice>> open_cue(const DeviceDescriptor& device) override {
    const std::vector<FoundCues> all = Finder(system()).found;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const FoundCues& f) { return f.id == device.id; });
    if (found == all.end()) {
      return fail(ErrorCode::kNotFound,
                  "\"" + device.id + "\" was not found. Is it plugged in and switched on?");
    }
    if (found->route == CueRoute::kHapticPad || found->route == CueRoute::kRumble) {
      return open_input(*found);
    }
    return open_hid(*found);
  }

  std::vector<Finding> diagnose(const SystemView& system) override {
    const Finder finder(system);
    std::vector<Finding> findings;
    std::string rules;
    for (const FoundCues& found : finder.found) {
      if (!system.may_use(found.path)) rules += found.rule;
    }
    for (const FoundCues& found : finder.found)
      findings.push_back(finding_of(system, found, rules));
    if (finder.pad_waits_for_kernel) findings.push_back(about_kernel(system));
    if (findings.empty()) {
      findings.push_back(
          {.level = FindingLevel::kAbsent,
           .what = "No haptic pen, touchpad, mouse or game controller is connected."});
    }
    return findings;
  }

 private:
  [[nodiscard]] const SystemView& system() const {
    return options_.system != nullptr ? *options_.system : this_system();
  }

  static DeviceDescriptor descriptor_of(const FoundCues& found) {
    DeviceDescriptor descriptor;
    descriptor.id = found.id;
    descriptor.driver = "cue";
    descriptor.kind = DeviceKind::kCue;
    descriptor.label = found.label;
    descriptor.serial = found.serial;
    // Only the receiver knows which devices are paired with it, and find() must not ask it.
    descriptor.is_connected = found.route != CueRoute::kReceiver;
    descriptor.has_own_frame = false;
    return descriptor;
  }

  static tl::unexpected<Error> cannot_open(const FoundCues& found, const Error& error) {
    return fail(error.code, found.label + " could not be opened: " + error.message +
                                ". 'feltline doctor cue' shows what to do.");
  }

  Result<std::unique_ptr<CueDevice>> open_input(const FoundCues& found) {
    auto port = options_.open_evdev(found.path);
    if (!port) return cannot_open(found, port.error());
    return std::make_unique<EvdevCues>(*std::move(port), found.route == CueRoute::kHapticPad,
                                       descriptor_of(found));
  }

  Result<std::unique_ptr<CueDevice>> open_hid(const FoundCues& found) {
    auto port = options_.open_hidraw(found.path);
    if (!port) return cannot_open(found, port.error());
    if (found.route != CueRoute::kHid) {
      return HidppMouse::open(*std::move(port), found.route == CueRoute::kReceiver,
                              descriptor_of(found));
    }
    std::optional<HapticReports> reports;
    for (const HidrawNode& node : hidraw_nodes(system())) {
      if (node.path == found.path) reports = reports_of(node);
    }
    if (!reports) return fail(ErrorCode::kNotFound, found.label + " was just unplugged");
    if (const auto asked = reports->ask(**port); !asked) {
      return fail(ErrorCode::kIo,
                  found.label + " does not report its waveforms: " + std::strerror(asked.error()));
    }
    if (reports->ordinal(CueWaveform::kPencil) == 0 && reports->ordinal(CueWaveform::kClick) == 0) {
      return fail(ErrorCode::kUnsupported,
                  found.label + " does not support any waveform that Feltline uses");
    }
    return std::make_unique<HidHaptics>(*std::move(port), *std::move(reports),
                                        descriptor_of(found));
  }

  static Finding finding_of(const SystemView& system, const FoundCues& found,
                            const std::string& rules) {
    const auto may = system.may_use(found.path);
    if (may) {
      return {
          .what = found.label + (found.route == CueRoute::kReceiver
                                     ? " can be used; an MX Master 4 must be paired with it, and "
                                       "awake."
                                     : " is connected and can be used."),
          .details = found.path};
    }
    // It is not an error if a receiver has no mouse with haptics.
    const bool is_receiver = found.route == CueRoute::kReceiver;
    return {.level = is_receiver ? FindingLevel::kWarning : FindingLevel::kProblem,
            .what = is_receiver
                        ? "You do not have permission to use the connected Logitech Bolt receiver. "
                          "This matters only if an MX Master 4 is paired with it."
                        : found.label + " is connected, but you do not have permission to use it.",
            .details = may.error().message,
            .steps = {"Let Feltline write a rule that lets the user of this computer use it:\n"
                      "feltline doctor --fix",
                      "Unplug it and plug it in again. If it is built in, restart the computer."},
            .fix = SystemFix{
                .path = rules_path(), .content = rules, .activate = std::string(kReloadUdev)}};
  }

  static Finding about_kernel(const SystemView& system) {
    const bool is_old = kernel_version(system) < kKnowsTouchpads;
    return {
        .level = FindingLevel::kWarning,
        .what = is_old
                    ? "There is a haptic touchpad, but this kernel does not support it."
                    : "There is a haptic touchpad, but the kernel does not provide access to it.",
        .details = std::string(shown_name(
            system.read("/proc/sys/kernel/osrelease").value_or("kernel of unknown version"))),
        .steps = {is_old ? "Haptic touchpads need Linux 6.18 or newer; Debian's backports have "
                           "newer kernels than a stable release."
                         : "The kernel must be built with CONFIG_HID_HAPTIC. Ask the provider of "
                           "your kernel."}};
  }

  CueOptions options_;
};

}  // namespace

std::unique_ptr<Driver> make_cue_driver(CueOptions options) {
  return std::make_unique<CueDriver>(std::move(options));
}

}  // namespace felt
