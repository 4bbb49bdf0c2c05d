#include "felt/devices/evdev/evdev_driver.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "felt/devices/evdev/stick_device.h"

namespace felt {
namespace {

struct FoundStick {
  InputNode node;
  StickKind kind;
  std::string id;
};

std::vector<FoundStick> sticks_of(const SystemView& system) {
  std::vector<FoundStick> sticks;
  for (InputNode& node : input_nodes(system)) {
    std::optional<StickKind> kind = stick_kind(node);
    if (!kind) continue;
    std::string id = "evdev:" + vendor_and_product(node.vendor, node.product);
    if (!node.unique.empty()) id += "-" + node.unique;
    const auto same = std::count_if(sticks.begin(), sticks.end(), [&](const FoundStick& other) {
      return other.id == id || other.id.starts_with(id + "#");
    });
    if (same > 0) id += "#" + std::to_string(same + 1);
    sticks.push_back({std::move(node), *std::move(kind), std::move(id)});
  }
  return sticks;
}

std::string rules_of(const InputNode& node) {
  const std::string both = vendor_and_product(node.vendor, node.product);
  return "KERNEL==\"event*\", SUBSYSTEM==\"input\", ATTRS{id/vendor}==\"" + both.substr(0, 4) +
         "\", ATTRS{id/product}==\"" + both.substr(5) + "\", TAG+=\"uaccess\"\n";
}

Finding not_allowed(const FoundStick& stick, const std::string& words, const std::string& rules) {
  return {.level = FindingLevel::kProblem,
          .what = stick.kind.label + " is plugged in, but you do not have permission to use it.",
          .details = words,
          .steps = {"Let Feltline write a rule that lets the user of this computer use it:\n"
                    "feltline doctor --fix",
                    "Unplug it, and plug it in again."},
          .fix = SystemFix{.path = "/etc/udev/rules.d/70-feltline-sticks.rules",
                           .content = rules,
                           .activate = std::string(kReloadUdev)}};
}

/// Returns true for a stick or wheel that has no motors which the kernel can drive. Returns false
/// for game pads.
bool is_without_motors(const InputNode& node) {
  return node.axes[evdev::kAbsX] && node.keys[evdev::kButtonTrigger] && node.effects.none();
}

class EvdevDriver final : public Driver {
 public:
  explicit EvdevDriver(EvdevOptions options) : options_(std::move(options)) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "evdev"; }
  [[nodiscard]] std::string_view label() const noexcept override {
    return "Joysticks and wheels with force feedback";
  }

  std::vector<DeviceDescriptor> find() override {
    std::vector<DeviceDescriptor> found;
    for (const FoundStick& stick : sticks_of(system())) found.push_back(descriptor_of(stick, 0.0));
    return found;
  }

  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions&) override {
    std::vector<FoundStick> sticks = sticks_of(system());
    const auto stick = std::find_if(sticks.begin(), sticks.end(),
                                    [&](const FoundStick& s) { return s.id == device.id; });
    if (stick == sticks.end()) {
      return fail(ErrorCode::kNotFound,
                  "\"" + device.id + "\" is not plugged in, or the kernel no longer sees it");
    }
    auto port = options_.open(stick->node.path);
    if (!port) {
      return fail(port.error().code, stick->kind.label +
                                         " could not be opened: " + port.error().message +
                                         ". 'feltline doctor evdev' shows what to do.");
    }
    return prepare(*std::move(port), *stick);
  }

  [[nodiscard]] PlaneCalibration default_plane(const DeviceDescriptor&,
                                               const OpenOptions&) const override {
    return {};  // x to the right, y towards the user, as on the page
  }

  std::vector<Finding> diagnose(const SystemView& system) override {
    std::vector<Finding> findings;
    const std::vector<FoundStick> sticks = sticks_of(system);
    std::string rules;  // rules for all devices that need one, because all are in one file
    for (const FoundStick& stick : sticks) {
      if (!system.may_use(stick.node.path)) rules += rules_of(stick.node);
    }
    for (const FoundStick& stick : sticks) {
      if (const auto may = system.may_use(stick.node.path); !may) {
        findings.push_back(not_allowed(stick, may.error().message, rules));
        continue;
      }
      Finding ok{.what = stick.kind.label + " is plugged in and can be used.",
                 .details = stick.node.path};
      if (!stick.kind.is_known) {
        ok.details += "; its strength is unknown, so weaker forces are used";
      }
      findings.push_back(std::move(ok));
    }
    for (const InputNode& node : input_nodes(system)) {
      if (!is_without_motors(node)) continue;
      findings.push_back(
          {.level = FindingLevel::kWarning,
           .what = (node.name.empty() ? "A joystick" : node.name) +
                   " is plugged in, but the kernel does not report force feedback for it.",
           .details = vendor_and_product(node.vendor, node.product),
           .steps = {"If it has motors, check whether there is a special kernel driver for its "
                     "maker or model: docs/devices/joysticks.md names some."}});
    }
    if (findings.empty()) {
      findings.push_back({.level = FindingLevel::kAbsent,
                          .what = "No joystick or wheel with force feedback is plugged in."});
    }
    return findings;
  }

 private:
  [[nodiscard]] const SystemView& system() const {
    return options_.system != nullptr ? *options_.system : this_system();
  }

  static DeviceDescriptor descriptor_of(const FoundStick& stick, double step_mm) {
    DeviceDescriptor descriptor;
    descriptor.id = stick.id;
    descriptor.driver = "evdev";
    descriptor.label = stick.kind.label;
    descriptor.model = stick.kind.is_wheel ? "ff-wheel" : "ff-stick";
    descriptor.serial = stick.node.unique;
    descriptor.has_own_frame = false;
    descriptor.capabilities = capabilities_of(stick.kind, step_mm);
    return descriptor;
  }

  Result<std::unique_ptr<DriverDevice>> prepare(std::unique_ptr<EvdevPort> port,
                                                const FoundStick& stick) const {
    const auto refused = [&stick](int error, const std::string& what) {
      return fail(ErrorCode::kIo, stick.kind.label + ": " + what + ": " + std::strerror(error) +
                                      ". Unplug it, and plug it in again.");
    };
    StickAxes axes(stick.kind.layout);
    if (const auto begun = axes.begin(ask_stick(*port, stick.kind.layout)); !begun) {
      return refused(begun.error(), "its axes cannot be read");
    }
    const auto slots = port->slots();
    if (!slots) return refused(slots.error(), "it does not report how many effects it can store");
    if (*slots < static_cast<int>(EffectPlan::kKinds)) {
      return refused(ENOSPC,
                     "it can store " + std::to_string(*slots) + " effects, but three are needed");
    }
    // Switches off the device's own forces, so that only the drawing's forces act.
    const auto set = [&](std::uint16_t what, std::int32_t value) {
      return !stick.kind.forces.effects[what] || port->send({evdev::kFf, what, value});
    };
    if (!set(evdev::kFfAutocenter, 0) || !set(evdev::kFfGain, 0xFFFF)) {
      return refused(EIO, "its own spring cannot be switched off");
    }
    DeviceDescriptor descriptor = descriptor_of(stick, axes.step_mm());
    return std::make_unique<StickDevice>(std::move(port), stick.kind, axes, std::move(descriptor),
                                         options_.has_thread);
  }

  EvdevOptions options_;
};

}  // namespace

std::unique_ptr<Driver> make_evdev_driver(EvdevOptions options) {
  return std::make_unique<EvdevDriver>(std::move(options));
}

}  // namespace felt
