#include <fmt/core.h>

#include <memory>

#include "commands.h"
#include "felt/devices/simulated/simulated_hand.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "json_text.h"
#include "text_table.h"

namespace felt::cli {
namespace {

constexpr const char* kNote =
    "All of these are simulated: equations with the figures above, for --device and --hand of "
    "'replay' and 'demo'; --json tells more of them. Drivers for real devices are still to come.";

std::string number_or_dash(double value) {
  return value > 0.0 ? json_number(value) : "-";
}

void print_text() {
  using Align = TextTable::Align;
  const TextStyle style = TextStyle::of_stdout();
  TextTable devices({{"device"},
                     {"peak N", Align::kRight},
                     {"held N", Align::kRight},
                     {"wall N/m", Align::kRight},
                     {"mass g", Align::kRight},
                     {"friction N", Align::kRight},
                     {"stands for"}});
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
  fmt::print("{}\n{}\n{}\n", devices.text(style), hands.text(style),
             wrapped(kNote, style.width, 0));
}

std::string vector_json(const Vec3& v) {
  return fmt::format("[{},{},{}]", json_number(v.x), json_number(v.y), json_number(v.z));
}

std::string device_json(const StylusPreset& preset) {
  const Capabilities& can = preset.capabilities;
  JsonObject object;
  object.add_text("name", preset.name);
  object.add_text("label", preset.label);
  object.add_raw("simulated", "true");
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
  object.add_raw("senses_pressure", can.senses_pressure ? "true" : "false");
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
  object.add_raw("simulated", "true");
  object.add_number("mass_kg", hand.mass_kg);
  object.add_number("stiffness_n_per_m", hand.stiffness_n_per_m);
  object.add_number("damping_n_s_per_m", hand.damping_n_s_per_m);
  return object.text();
}

void print_json() {
  std::vector<std::string> devices, hands;
  for (const StylusPreset& preset : stylus_presets()) devices.push_back(device_json(preset));
  for (const SimulatedHand& hand : simulated_hands()) hands.push_back(hand_json(hand));
  fmt::print("{{\"devices\":{},\"hands\":{}}}\n", json_array(devices), json_array(hands));
}

}  // namespace

void add_devices_command(CLI::App& app, Console&) {
  CLI::App* command = app.add_subcommand("devices", "List the pens and hands there are");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One line of JSON");
  command->footer(
      examples("feltline devices\n"
               "feltline replay strokes.ndjson --device premium --hand light -o sketch.svg"));
  command->callback([json] { *json ? print_json() : print_text(); });
}

}  // namespace felt::cli
