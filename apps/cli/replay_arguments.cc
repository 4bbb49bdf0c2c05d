#include "replay_arguments.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "commands.h"
#include "felt/haptics/safety/safety_limits.h"
#include "replay_input.h"

namespace felt::cli {
namespace {

std::vector<std::string> device_names() {
  std::vector<std::string> names;
  for (const StylusPreset& preset : stylus_presets()) names.emplace_back(preset.name);
  return names;
}

std::vector<std::string> hand_names() {
  std::vector<std::string> names;
  for (const SimulatedHand& hand : simulated_hands()) names.emplace_back(hand.name);
  return names;
}

}  // namespace

void ReplayArguments::add_pen_to(CLI::App& command) {
  command.add_option("--device", device, "The simulated pen (see 'feltline devices')")
      ->check(CLI::IsMember(device_names()))
      ->capture_default_str();
  command.add_option("--hand", hand, "The simulated hand that holds it")
      ->check(CLI::IsMember(hand_names()))
      ->capture_default_str();
}

void ReplayArguments::add_loop_to(CLI::App& command) {
  command.add_option("--rate", rate_hz, "Ticks of the loop per second (default: the device's)")
      ->check(number_between(250.0, 5000.0));
  command
      .add_option("--delay", delay_ticks,
                  "Delay from a position to its force, in ticks (default: the device's)")
      ->check(CLI::Range(0, 7));
  add_force_limit(command, limit_n);
  command.add_flag("--no-force", no_force, "Send no force to the pen");
}

ReplaySettings ReplayArguments::settings() const {
  StylusPreset preset = *find_stylus_preset(device);
  const double hold_s = 1e-9 * static_cast<double>(preset.force_hold_ns);
  if (rate_hz && *rate_hz * hold_s > 1.0) {
    throw UsageError(
        fmt::format("--rate: {} accepts at most {:g} forces a second", device, 1.0 / hold_s));
  }
  preset.capabilities = with_force_limit(preset.capabilities, limit_n);
  ReplaySettings settings =
      replay_settings(preset, *find_hand(hand), !no_force, rate_hz, delay_ticks);
  settings.read_import = read_strokes;
  return settings;
}

}  // namespace felt::cli
