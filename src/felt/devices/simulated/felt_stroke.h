#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/haptics/force.h"
#include "felt/material/materials.h"

namespace felt {

/// A stroke that the simulated hand draws to feel a sheet: it comes down, goes along x, turns and
/// goes along y.
struct StrokePlan {
  const StylusPreset* device = nullptr;
  const SimulatedHand* hand = nullptr;
  std::int64_t period_ns = 1'000'000;
  const SurfaceMaterial* surface = nullptr;
  const Medium* tool = nullptr;
  bool has_grain = true;  ///< false: the same sheet, smooth
  double speed_mm_per_s = 80.0;
  double press_n = 0.6;
  double leg_mm = 40.0;    ///< length of each of the two ways
  double rest_s = 0.0;     ///< how much longer than usual (0.2 s) it holds still before it goes
  std::uint32_t seed = 0;  ///< where it starts, and how the hand trembles; 0 does not tremble
};

/// What the device did to the hand meanwhile, tick by tick, and nothing else.
struct StrokeForces {
  double period_s = 0.001;
  double leg_s = 0.0;           ///< how long the pen took for each of the two ways, at full speed
  std::vector<Force> touching;  ///< while it comes down, from the first contact on
  std::vector<Force> resting;   ///< while it holds still
  std::vector<Force> along_x;   ///< the middle nine tenths of the first way
  std::vector<Force> along_y;   ///< and of the second
  bool is_sound = true;         ///< the safety chain found nothing wrong
};

/// Device, hand, loop, safety chain and sheet in virtual time: the same plan, the same forces.
StrokeForces draw_stroke(const StrokePlan& plan);

/// What of a force trembles: RMS of what is above 30 Hz over all axes, N (specification section 0,
/// "HF"), after the first tenth of a second; 0 for less than that.
double force_above_30_hz_n(std::span<const Force> forces, double period_s);

}  // namespace felt
