#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "felt/devices/simulated/hand_script.h"
#include "felt/devices/simulated/simulated_hand.h"
#include "felt/devices/simulated/stylus_presets.h"

namespace felt::cli {

/// The pen that a replay is played through, who holds it, and how the loop runs.
struct ReplaySettings {
  StylusPreset device;
  SimulatedHand hand;
  bool force = true;  ///< false: the pen pushes back with nothing
  /// How the hand draws raw strokes with it.
  HandScriptOptions script;
};

/// The settings for a preset and a hand. `rate_hz` and `delay_ticks`: else those of the device.
///
/// The device reaches every place of the sheet, as if the paper were moved under it: the workspace
/// is endless sideways. Without force the hand is told to press by the pressure that it senses,
/// since nothing stops it.
ReplaySettings replay_settings(const StylusPreset& device, const SimulatedHand& hand, bool force,
                               std::optional<double> rate_hz, std::optional<int> delay_ticks);

/// The same as options of a command line.
struct ReplayArguments {
  std::string device = "touch";
  std::string hand = "typical";
  std::optional<double> rate_hz;
  std::optional<int> delay_ticks;
  bool no_force = false;

  /// Adds --device and --hand.
  void add_pen_to(CLI::App& command);
  /// Adds --rate, --delay and --no-force.
  void add_loop_to(CLI::App& command);
  /// Requires that the command line was parsed: then the names are known.
  [[nodiscard]] ReplaySettings settings() const;
};

}  // namespace felt::cli
