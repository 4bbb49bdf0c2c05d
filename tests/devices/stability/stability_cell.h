#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/haptics/safety/safety_chain.h"
#include "felt/material/materials.h"

namespace felt {

/// What the hand does in a stability trial.
enum class Trial : std::uint8_t {
  kRest,  ///< lands, presses, holds still
  kSlow,  ///< presses and moves at 20 mm/s
  kTap,   ///< taps eight times in 2.7 s
  kWell,  ///< lands within a snap well, rests, goes out to its plateau and back
  kEdit,  ///< an edit spring, 20 mm out and back
};
inline constexpr Trial kTrials[] = {Trial::kRest, Trial::kSlow, Trial::kTap, Trial::kWell,
                                    Trial::kEdit};
std::string_view name_of(Trial trial) noexcept;

/// One trial of one hand with one device on one surface, and how the loop is.
struct StabilityCell {
  Trial trial = Trial::kRest;
  const StylusPreset* device = nullptr;
  const SimulatedHand* hand = nullptr;  ///< null: a typical hand lets go where it gets interesting
  int delay_ticks = 1;
  std::int64_t period_ns = 1'000'000;
  const SurfaceMaterial* surface = nullptr;
  const Medium* tool = nullptr;
};
/// "slow worst/light 1 kHz delay 2 blackboard eraser"
std::string name_of(const StabilityCell& cell);

/// What was measured.
struct StabilityResult {
  /// RMS of what the device pushed above 30 Hz, N, in the part of the trial where nothing sudden is
  /// meant to happen (docs/design/simulation.md#measures). A tap has none: 0.
  double high_frequency_n = 0.0;
  /// Net work of the device's force on the hand over one contact, mJ: the worst of the taps, else
  /// all of a movement that ends where it began. Negative is 0.
  double energy_mj = 0.0;
  double mean_press_n = 0.0;  ///< while measured
  SafetyFault fault = SafetyFault::kNone;
  bool finite = true;
};

/// Bounds of docs/design/simulation.md#measures.
inline constexpr double kCleanForceN = 0.03;
inline constexpr double kPassiveEnergyMj = 1.0;
bool passes(const StabilityResult& result) noexcept;

/// Runs the trial: simulated stylus, Servo with its SafetyChain, the tools' bricks, virtual time.
/// Deterministic; some milliseconds.
StabilityResult run_trial(const StabilityCell& cell);

}  // namespace felt
