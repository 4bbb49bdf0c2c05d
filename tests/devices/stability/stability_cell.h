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
  kRest,    ///< lands, presses, holds still
  kSlow,    ///< presses and moves at 20 mm/s
  kTap,     ///< taps eight times in 2.7 s
  kWell,    ///< lands in a snap well, rests, moves out to the well's plateau and back
  kEdit,    ///< moves 20 mm out and back against an edit spring
  kGuide,   ///< lands 1 mm beside a groove, rests, moves to 3 mm and back
  kRidge,   ///< the same beside the soft ridge of the tool Fill
  kBundle,  ///< moves 20 mm out and back through a bundle of the tool Gather
  kShake,   ///< the same with a hand that shakes by 1 mm, and the damping of the steady hand
  kHold,    ///< rests where the pencil holds the pen, moves out of the hold and back
  kRead,    ///< lands 1 mm beside a line at an end that the tool Read holds, moves out and back
  // As kGuide, but with a guide of a drawing and the friction of a guided pencil.
  kRuler,        ///< beyond the edge of a ruler
  kLine,         ///< a line, also one of parallels or of a set square
  kCompass,      ///< a circle with a radius of 20 mm
  kEllipse,      ///< the narrow end of an ellipse, with a radius of 5 mm
  kPerspective,  ///< a line that begins with a click
  kRay,          ///< a ray of a protractor; the pen crosses it
  kNode,         ///< a node of a grid; the pen crosses it
  kTrace,        ///< a wavy stroke
  kTeacher,      ///< a teacher who draws with 40 mm/s
  kRing,   ///< a well of the ring of tools, without friction; the pen leaves it and comes back
  kEdge,   ///< the ridge at the edge of the page, with the friction of a pencil
  kClick,  ///< rests at a threshold that clicks, presses through another one and comes back
  kFlank,  ///< rests on the flank of a body, moves to where it is steep and back
  kSlide,  ///< moves at 20 mm/s over the facets of a body
};
/// The trials of guides of a drawing, and others that are made on all devices with one medium.
inline constexpr Trial kGuideTrials[] = {
    Trial::kRuler, Trial::kLine,  Trial::kCompass, Trial::kEllipse, Trial::kPerspective,
    Trial::kRay,   Trial::kNode,  Trial::kTrace,   Trial::kTeacher, Trial::kRing,
    Trial::kEdge,  Trial::kClick, Trial::kFlank,   Trial::kSlide};
inline constexpr Trial kTrials[] = {Trial::kRest,  Trial::kSlow,  Trial::kTap,   Trial::kWell,
                                    Trial::kEdit,  Trial::kGuide, Trial::kRidge, Trial::kBundle,
                                    Trial::kShake, Trial::kHold,  Trial::kRead};
constexpr bool is_guide_of_drawing(Trial trial) noexcept {
  return trial >= Trial::kRuler;
}
constexpr bool is_on_body(Trial trial) noexcept {
  return trial == Trial::kFlank || trial == Trial::kSlide;
}
std::string_view name_of(Trial trial) noexcept;

/// One trial: a hand uses a medium on a surface with a device and a loop.
struct StabilityCell {
  Trial trial = Trial::kRest;
  const StylusPreset* device = nullptr;
  const SimulatedHand* hand = nullptr;  ///< null: a typical hand that releases the pen in the trial
  int delay_ticks = 1;
  std::int64_t period_ns = 1'000'000;
  const SurfaceMaterial* surface = nullptr;
  const Medium* tool = nullptr;
};
/// Returns the rate of a loop: "1 kHz", "250 Hz".
std::string rate_name(std::int64_t period_ns);
/// Returns the name of a cell, for example "slow worst/light 1 kHz delay 2 blackboard eraser".
std::string name_of(const StabilityCell& cell);

/// The measurements of a trial.
struct StabilityResult {
  /// RMS of the device's force above 30 Hz, N, while no sudden change of force is expected
  /// (docs/design/simulation.md#measures). 0 for taps, because all of a tap is sudden.
  double high_frequency_n = 0.0;
  /// Net work of the device's force on the hand, mJ: for taps, that of the contact with the largest
  /// work; otherwise of the whole movement, which ends at its start. Negative work counts as 0.
  double energy_mj = 0.0;
  double mean_press_n = 0.0;  ///< while measured
  SafetyFault fault = SafetyFault::kNone;
  bool finite = true;
};

/// Limits from docs/design/simulation.md#measures.
inline constexpr double kCleanForceN = 0.03;
inline constexpr double kPassiveEnergyMj = 1.0;
/// Returns true if there was no fault and the result is finite and within these limits.
bool passes(const StabilityResult& result) noexcept;

/// Runs the trial with a simulated stylus, a Servo with its SafetyChain and the tools' force bricks
/// in virtual time. Deterministic; takes some milliseconds.
StabilityResult run_trial(const StabilityCell& cell);

}  // namespace felt
