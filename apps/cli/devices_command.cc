#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "commands.h"
#include "driver_processes.h"
#include "felt/devices/drivers.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/io/ndjson/json_text.h"
#include "print.h"
#include "text_table.h"

namespace felt::cli {
namespace {

constexpr const char* kNothing =
    "No haptic device is connected. 'feltline doctor' shows what a device needs on this computer.";
constexpr const char* kNote =
    "These are simulated by equations with the figures above, for --device and --hand of 'replay' "
    "and 'demo', and for 'device-test'; --json shows more about them.";

std::string number_or_dash(double value) {
  return value > 0.0 ? json_number(value) : "-";
}

/// Returns the real devices: first those with force, then those that only play cues.
std::vector<DeviceDescriptor> real_devices(const std::vector<DriverReport>& looks) {
  std::vector<DeviceDescriptor> devices;
  for (const DeviceKind kind : {DeviceKind::kForce, DeviceKind::kCue}) {
    for (const DriverReport& look : looks) {
      for (const DeviceDescriptor& device : look.devices) {
        if (device.kind == kind) devices.push_back(device);
      }
    }
  }
  return devices;
}

const char* state_of(const DeviceDescriptor& device) {
  return device.is_connected ? "connected" : "open it to see";
}

std::string or_dash(const std::string& text) {
  return text.empty() ? "-" : text;
}

std::string count_words(const std::vector<DeviceDescriptor>& devices) {
  const auto connected =
      std::count_if(devices.begin(), devices.end(),
                    [](const DeviceDescriptor& device) { return device.is_connected; });
  if (connected == 0) {
    return "To check whether a haptic device is connected, open it: feltline device-test "
           "--level 1 " +
           devices.front().id;
  }
  return connected == 1 ? "One haptic device is connected."
                        : fmt::format("{} haptic devices are connected.", connected);
}

/// Prints the connected devices, and the drivers that failed in the vendor's software.
void print_real(const std::vector<DriverReport>& looks, const TextStyle& style) {
  using Align = TextTable::Align;
  const std::vector<DeviceDescriptor> devices = real_devices(looks);
  print("{}\n\n", wrapped(devices.empty() ? kNothing : count_words(devices), style.width, 0));
  if (!devices.empty()) {
    TextTable table({{"id"},
                     {"peak N", Align::kRight},
                     {"held N", Align::kRight},
                     {"gives"},
                     {"serial"},
                     {"version"},
                     {"state"},
                     {"device"}});
    for (const DeviceDescriptor& device : devices) {
      table.add_row({device.id, number_or_dash(device.capabilities.max_force_n),
                     number_or_dash(device.capabilities.continuous_force_n),
                     device.kind == DeviceKind::kForce ? "force" : "cues", or_dash(device.serial),
                     or_dash(device.version), state_of(device), device.label});
    }
    print("{}\n", table.text(style));
  }
  for (const DriverReport& look : looks) {
    for (const Finding& finding : look.findings) {
      print("{}: {}\n\n", look.name,
            wrapped(finding.what + " 'feltline doctor " + look.name + "' says more.", style.width,
                    0));
    }
  }
}

void print_simulated(const TextStyle& style) {
  using Align = TextTable::Align;
  TextTable devices({{"device"},
                     {"peak N", Align::kRight},
                     {"held N", Align::kRight},
                     {"wall N/m", Align::kRight},
                     {"mass g", Align::kRight},
                     {"friction N", Align::kRight},
                     {"represents"}});
  for (const StylusPreset& preset : stylus_presets()) {
    const Capabilities& can = preset.capabilities;
    devices.add_row({std::string(preset.name), number_or_dash(can.max_force_n),
                     number_or_dash(can.continuous_force_n),
                     number_or_dash(can.max_stiffness_n_per_m),
                     number_or_dash(1000.0 * preset.mechanics.mass_kg),
                     number_or_dash(preset.mechanics.friction_n), std::string(preset.label)});
  }
  TextTable hands({{"hand"},
                   {"mass g", Align::kRight},
                   {"stiffness N/m", Align::kRight},
                   {"damping N s/m", Align::kRight}});
  for (const SimulatedHand& hand : simulated_hands()) {
    hands.add_row({std::string(hand.name), json_number(1000.0 * hand.mass_kg),
                   json_number(hand.stiffness_n_per_m), json_number(hand.damping_n_s_per_m)});
  }
  print("{}\n{}\n{}\n", devices.text(style), hands.text(style), wrapped(kNote, style.width, 0));
}

std::string vector_json(const Vec3& v) {
  return fmt::format("[{},{},{}]", json_number(v.x), json_number(v.y), json_number(v.z));
}

std::string device_json(const StylusPreset& preset) {
  const Capabilities& can = preset.capabilities;
  JsonObject object;
  object.add_text("name", preset.name);
  object.add_text("label", preset.label);
  object.add_bool("simulated", true);
  object.add_number("sensed_axes", can.sensed_axes);
  object.add_number("actuated_axes", can.actuated_axes);
  object.add_number("max_force_n", can.max_force_n);
  object.add_number("continuous_force_n", can.continuous_force_n);
  object.add_number("advised_force_n", can.advised_force_n);
  object.add_number("max_stiffness_n_per_m", can.max_stiffness_n_per_m);
  object.add_number("max_damping_n_s_per_m", can.max_damping_n_s_per_m);
  object.add_raw("workspace_min_mm", vector_json(can.workspace_min));
  object.add_raw("workspace_max_mm", vector_json(can.workspace_max));
  object.add_number("position_step_mm", can.position_step_mm);
  object.add_number("rate_hz", 1e9 / static_cast<double>(can.period_ns));
  object.add_number("delay_ticks", can.delay_ticks);
  object.add_bool("senses_pressure", can.senses_pressure);
  object.add_number("mass_kg", preset.mechanics.mass_kg);
  object.add_number("friction_n", preset.mechanics.friction_n);
  object.add_number("viscous_n_s_per_m", preset.mechanics.viscous_n_s_per_m);
  object.add_number("weight_n", preset.mechanics.weight_n);
  object.add_text("source", preset.source);
  return object.text();
}

std::string hand_json(const SimulatedHand& hand) {
  JsonObject object;
  object.add_text("name", hand.name);
  object.add_bool("simulated", true);
  object.add_number("mass_kg", hand.mass_kg);
  object.add_number("stiffness_n_per_m", hand.stiffness_n_per_m);
  object.add_number("damping_n_s_per_m", hand.damping_n_s_per_m);
  return object.text();
}

std::string real_json(const DeviceDescriptor& device) {
  const Capabilities& can = device.capabilities;
  JsonObject object;
  object.add_text("name", device.id);
  object.add_text("label", device.label);
  object.add_bool("simulated", false);
  object.add_text("driver", device.driver);
  object.add_text("gives", device.kind == DeviceKind::kForce ? "force" : "cues");
  object.add_text("model", device.model);
  object.add_text("serial", device.serial);
  object.add_text("version", device.version);
  object.add_raw("connected", device.is_connected ? "true" : "null");
  object.add_number("actuated_axes", can.actuated_axes);
  object.add_number("max_force_n", can.max_force_n);
  object.add_number("continuous_force_n", can.continuous_force_n);
  object.add_number("max_stiffness_n_per_m", can.max_stiffness_n_per_m);
  object.add_raw("workspace_min_mm", vector_json(can.workspace_min));
  object.add_raw("workspace_max_mm", vector_json(can.workspace_max));
  object.add_number("rate_hz", 1e9 / static_cast<double>(can.period_ns));
  return object.text();
}

std::string trouble_json(const DriverReport& look, const Finding& finding) {
  JsonObject object;
  object.add_text("driver", look.name);
  object.add_text("what", finding.what);
  object.add_text("details", finding.details);
  return object.text();
}

void print_json(const std::vector<DriverReport>& looks) {
  std::vector<std::string> devices, hands, troubles;
  for (const DeviceDescriptor& device : real_devices(looks)) devices.push_back(real_json(device));
  for (const DriverReport& look : looks) {
    for (const Finding& finding : look.findings) troubles.push_back(trouble_json(look, finding));
  }
  for (const StylusPreset& preset : stylus_presets()) devices.push_back(device_json(preset));
  for (const SimulatedHand& hand : simulated_hands()) hands.push_back(hand_json(hand));
  print("{{\"devices\":{},\"hands\":{},\"troubles\":{}}}\n", json_array(devices), json_array(hands),
        json_array(troubles));
}

void run_devices(bool json) {
  const std::vector<DriverReport> looks =
      query_drivers(make_drivers(), this_system(), DriverQuery::kDevices);
  if (json) return print_json(looks);
  const TextStyle style = TextStyle::of_stdout();
  print_real(looks, style);
  print_simulated(style);
}

}  // namespace

void add_devices_command(CLI::App& app, Console&) {
  CLI::App* command =
      app.add_subcommand("devices", "List the devices that are connected, and the simulated ones");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One line of JSON");
  command->footer(
      examples("feltline devices\n"
               "feltline devices --json\n"
               "feltline replay strokes.ndjson --device premium --hand light -o sketch.svg"));
  command->callback([json] { run_devices(*json); });
}

}  // namespace felt::cli
