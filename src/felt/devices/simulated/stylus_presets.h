#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "felt/haptics/capabilities.h"

namespace felt {

/// A hand as the stylus feels it: a mass that moves with the stylus, and a spring and a damper
/// between the stylus and the hand's aim (docs/design/simulation.md#hands). The four hands cover
/// the range of human hands; their values are estimates.
struct SimulatedHand {
  std::string_view name{};
  double mass_kg = 0.03;
  double stiffness_n_per_m = 300.0;
  double damping_n_s_per_m = 3.0;
};

/// Returns the four hands: light, soft, typical and firm (docs/design/simulation.md#hands).
std::span<const SimulatedHand> simulated_hands() noexcept;
/// Returns the hand with this name, or null.
const SimulatedHand* find_hand(std::string_view name) noexcept;
/// Returns the default hand: typical.
const SimulatedHand& typical_hand() noexcept;

/// The mechanical properties of a stylus that the hand has to overcome. They are measured at the
/// tip and are the same in every direction.
///
/// An admittance device (HapticMASTER) measures the force of the hand and moves as a virtual mass
/// would move under this force and the bias force that the program sets. So its mass and friction
/// are the virtual ones (docs/design/simulation.md#devices).
struct StylusMechanics {
  double mass_kg = 0.0;
  double friction_n = 0.0;         ///< Coulomb friction: the stylus sticks up to this force
  double viscous_n_s_per_m = 0.0;  ///< viscous friction, proportional to speed
  double weight_n = 0.0;           ///< weight that the device does not balance; the hand bears it
};

/// A device model to simulate. If a number comes neither from the maker nor from code that drives
/// the device, `source` says "estimate": good enough for tests, but not for a data sheet.
struct StylusPreset {
  std::string_view name;  ///< "touch"
  std::string_view label;
  std::string_view source;
  StylusMechanics mechanics;
  Capabilities capabilities;
  /// The device accepts a force at most once in this time, and holds it; 0 means at each tick. A
  /// loop must not have a shorter period, because its limits would be too high (R56).
  std::int64_t force_hold_ns = 0;
  bool plays_cues = false;  ///< a CueLaw decides how it vibrates
  /// The grip moves along the page only, and the pressure of a trigger sets the height of the pen.
  bool has_trigger = false;

  /// Returns true if the device can push the pen out of the page, so that a surface can be felt.
  /// The forces of a joystick act along the page only, and a button says whether its pen is down.
  [[nodiscard]] constexpr bool renders_surface() const noexcept {
    return capabilities.has_force() && capabilities.actuated_axes > 2;
  }
};

/// Returns all presets: worst, touch, touch-x, premium, falcon, omega, inverse3, delta,
/// hapticmaster, joystick, mouse, vibrating-mouse and tablet. The last three have no force; their
/// pen is exactly at the aim. The workspaces extend 10 mm beyond the left and upper edge of the
/// page; half of each workspace is above the drawing plane, half below. Only the pen of the
/// joystick does not move up and down (SimulatedStylus).
std::span<const StylusPreset> stylus_presets() noexcept;
/// Returns the preset with this name, or null.
const StylusPreset* find_stylus_preset(std::string_view name) noexcept;

/// Moves the workspace of `device` parallel to the page, so that its centre is above this position
/// of the page.
void center_workspace(Capabilities& device, Point middle_mm) noexcept;

}  // namespace felt
