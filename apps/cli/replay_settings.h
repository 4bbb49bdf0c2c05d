#pragma once

#include <cstdint>
#include <optional>

#include "felt/devices/simulated/hand_script.h"
#include "felt/devices/simulated/simulated_hand.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/material/materials.h"

namespace felt::cli {

/// The pen that a replay is played through, who holds it, and how the loop runs.
struct ReplaySettings {
  StylusPreset device;
  SimulatedHand hand;
  bool force = true;  ///< false: the pen pushes back with nothing
  /// How the hand draws raw strokes with it.
  HandScriptOptions script;
  /// Sheets and media that options may name.
  Materials materials = Materials::built_in();
};

/// The settings for a preset and a hand. `rate_hz` and `delay_ticks`: else those of the device.
///
/// The device reaches every place of the sheet, as if the paper were moved under it: the workspace
/// is endless sideways. Without force the hand is told to press by the pressure that it senses,
/// since nothing stops it.
ReplaySettings replay_settings(const StylusPreset& device, const SimulatedHand& hand, bool force,
                               std::optional<double> rate_hz, std::optional<int> delay_ticks);

}  // namespace felt::cli
