#pragma once

#include <span>
#include <string_view>

#include "felt/haptics/capabilities.h"

namespace felt {

/// A hand as the stylus feels it: its mass moves with the stylus, and a spring and a damper lie
/// between the stylus and the place where the hand wants it (specification section 0). The four
/// hands bracket people; none is measured.
struct SimulatedHand {
  std::string_view name{};
  double mass_kg = 0.03;
  double stiffness_n_per_m = 300.0;
  double damping_n_s_per_m = 3.0;
};

/// light, soft, typical, firm (specification section 0).
std::span<const SimulatedHand> simulated_hands() noexcept;
/// By name, or null.
const SimulatedHand* find_hand(std::string_view name) noexcept;
/// The hand that is meant where nothing is said: typical.
const SimulatedHand& typical_hand() noexcept;

/// How a stylus moves when nobody helps it: what the hand has to accelerate and overcome. All as
/// seen at the tip, the same in every direction.
struct StylusMechanics {
  double mass_kg = 0.0;
  double friction_n = 0.0;         ///< Coulomb: it sticks up to this force
  double viscous_n_s_per_m = 0.0;  ///< grows with speed
  double weight_n = 0.0;           ///< what balance leaves of its weight; the hand bears it
};

/// A kind of device to simulate. Where a number is not from a maker or from code that drives the
/// device, `source` says "estimate": enough to test with, not a data sheet.
struct StylusPreset {
  std::string_view name;  ///< "touch"
  std::string_view label;
  std::string_view source;
  StylusMechanics mechanics;
  Capabilities capabilities;
};

/// worst, touch, touch-x, premium, falcon, omega, inverse3, and the two without force, whose pen is
/// exactly where the hand aims: mouse, tablet. The workspaces reach 10 mm over the left and upper
/// edge of the sheet, and lie half above, half below the drawing plane.
std::span<const StylusPreset> stylus_presets() noexcept;
/// By name, or null.
const StylusPreset* find_stylus_preset(std::string_view name) noexcept;

/// Moves the workspace sideways so that its middle is above this place of the sheet.
void center_workspace(Capabilities& device, Point middle_mm) noexcept;

}  // namespace felt
