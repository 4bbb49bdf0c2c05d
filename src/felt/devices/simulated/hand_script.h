#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/devices/simulated/writing_hand.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/capabilities.h"
#include "felt/material/materials.h"

namespace felt {

/// One point of a recorded stroke that a hand will redraw. Pressure is 0..1.
struct RecordedPoint {
  Point position;
  std::optional<double> pressure{};
  std::optional<std::int64_t> time_ns{};
  std::optional<double> tilt_deg{};  ///< tilt of the pen from the upright, 0..90
};
using RecordedPath = std::vector<RecordedPoint>;

/// An aim and its time: arguments for HandInput::aim.
struct TimedAim {
  std::int64_t time_ns = 0;
  Vec3 target_mm;
  std::optional<double> pressure{};
  std::optional<double> tilt_deg{};

  friend constexpr bool operator==(const TimedAim&, const TimedAim&) noexcept = default;
};

/// How the device of the script makes ink.
enum class ContactBy : std::uint8_t {
  kDepth,     ///< it pushes back: the hand presses the pen into the surface
  kPressure,  ///< it senses pressure: the pen stays on the surface, z = 0
};

struct HandScriptOptions {
  SimulatedHand hand = typical_hand();
  ContactBy contact = ContactBy::kDepth;
  std::int64_t interval_ns = 1'000'000;  ///< between aims
  double plane_n_per_m = 500.0;          ///< stiffness of the surface that it presses on
  double light_n = 0.1;                  ///< force for pressure 0 (F0 of docs/design/forces.md)
  double full_n = 2.0;                   ///< force for pressure 1 (F1)
  double absent_pressure = 0.5;
  /// Known to a practised hand, which aims ahead to compensate: friction mu of the pen on the
  /// surface, mass and Coulomb friction of the device.
  double friction = 0.25;
  double device_mass_kg = 0.05;
  double device_friction_n = 0.0;
  double hover_mm = 4.0;
  double lead_in_s = 0.7;  ///< hovering before the first stroke: forces engage (safety_limits.h)
};

/// Returns the options for drawing on paper with this device: the stiffness of paper on it
/// (plane_for), and full pressure at the push that draws full width (firm_push_n), so that a
/// recorded pressure reproduces its width.
HandScriptOptions script_options_for(const StylusPreset& device,
                                     const SimulatedHand& hand) noexcept;

/// Sets the surface that the hand draws on: its stiffness on this device, and full pressure at the
/// push that draws full width there. With a medium, also its friction on the surface.
void set_surface(HandScriptOptions& options, const SurfaceMaterial& surface,
                 const Capabilities& device, const Medium* medium = nullptr) noexcept;

/// Returns how far below the surface a hand must aim so that its spring and the surface's balance
/// at the force for this pressure, F = F0 + p (F1 - F0):  aim depth = F/K + (F + friction)/k. The
/// Coulomb friction of the device counts only for a resting pen, because in motion it acts along
/// the motion.
double aim_depth_mm(const HandScriptOptions& options, double pressure,
                    double speed_mm_per_s = 0.0) noexcept;

/// Returns aims that make a hand draw these strokes, one every interval from time 0 on: it hovers
/// above the start, lands, presses, draws at the recorded pace, waits a moment, lifts, moves on.
/// Movements in the air are minimum-jerk, s = 10 t^3 - 15 t^4 + 6 t^5 (Flash, Hogan, J Neurosci 5,
/// 1985), at 250 mm/s on average at most. The aim runs ahead of the planned pen by the effect of
/// mass, surface and friction, so that the pen, not the aim, follows the strokes.
///
/// The pen has the recorded tilt, and keeps the last one in between and in the air.
///
/// No stroke is lost: a dot presses for at least 60 ms. Points that are not finite are left out.
/// Strokes without times, or with times that do not grow, get the pace of an unhurried hand
/// (hand_path.h); no pace is above 500 mm/s, no pause longer than 1 s.
std::vector<TimedAim> script_hand(std::span<const RecordedPath> strokes,
                                  const HandScriptOptions& options);

/// The same for strokes that a WritingHand draws, including its tremor.
std::vector<TimedAim> script_hand(std::span<const Gesture> gestures, const HandOptions& writing,
                                  const HandScriptOptions& options);

}  // namespace felt
