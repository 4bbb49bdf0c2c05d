#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/haptics/force.h"
#include "felt/material/materials.h"

namespace felt {

/// A stroke that the simulated hand draws to feel a surface. The pen comes down, moves along x,
/// then turns by a right angle and moves along y.
struct StrokePlan {
  const StylusPreset* device = nullptr;
  const SimulatedHand* hand = nullptr;
  std::int64_t period_ns = 1'000'000;
  const SurfaceMaterial* surface = nullptr;
  const Medium* tool = nullptr;
  bool has_grain = true;  ///< if false, the same surface without its grain
  double speed_mm_per_s = 80.0;
  double press_n = 0.6;
  double leg_mm = 40.0;  ///< length of each of the two legs
  double rest_s = 0.0;   ///< extra time, beyond the usual 0.2 s, that the pen rests before it moves
  std::uint32_t seed = 0;  ///< seed for the start point and the tremor of the hand; 0: no tremor
};

/// The forces of the device on the hand, tick by tick.
struct StrokeForces {
  double period_s = 0.001;
  double leg_s = 0.0;              ///< time for each of the two legs, at full speed
  double device_friction_n = 0.0;  ///< friction that the hand feels in addition
  double viscous_n = 0.0;          ///< viscous part of the forces along the legs
  std::vector<Force> touching;     ///< while the pen comes down, from the first contact on
  std::vector<Force> resting;      ///< while the pen rests
  std::vector<Force> along_x;      ///< the middle nine tenths of the first leg
  std::vector<Force> along_y;      ///< the middle nine tenths of the second leg
  bool is_sound = true;            ///< the safety chain found nothing wrong
};

/// Simulates the stroke in virtual time, with device, hand, loop, safety chain and surface. The
/// same plan gives the same forces.
StrokeForces draw_stroke(const StrokePlan& plan);

/// Returns the strength of the vibration in a force: its RMS above 30 Hz over all axes, N
/// (docs/design/simulation.md#measures). Skips the first tenth of a second; returns 0 if the forces
/// last no longer than that.
double force_above_30_hz_n(std::span<const Force> forces, double period_s);

}  // namespace felt
