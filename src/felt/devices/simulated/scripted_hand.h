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

/// A point of a recorded stroke that a hand will redraw. Pressure is 0..1.
struct RecordedPoint {
  Point position;
  std::optional<double> pressure{};
  std::optional<std::int64_t> time_ns{};
  std::optional<double> tilt_deg{};  ///< tilt of the pen from the upright, 0..90
};
using RecordedPath = std::vector<RecordedPoint>;

/// An aim and its time, as arguments for HandInput::aim.
struct TimedAim {
  std::int64_t time_ns = 0;
  Vec3 target_mm;
  std::optional<double> pressure{};
  std::optional<double> tilt_deg{};

  friend constexpr bool operator==(const TimedAim&, const TimedAim&) noexcept = default;
};

/// How the device on which the script is played detects contact.
enum class ContactBy : std::uint8_t {
  kDepth,       ///< by depth, on a device with forces: the hand presses the pen into the surface
  kPressure,    ///< by its pressure sensor: the pen stays on the surface, z = 0
  kTrigger,     ///< as kPressure, with a button on the grip of a joystick, which the hand leads
  kDepthInAir,  ///< by depth, without a surface: the hand goes as deep as a surface would yield
};

/// Returns true if the aims carry the pressure of the pen.
constexpr bool is_by_pressure(ContactBy contact) noexcept {
  return contact == ContactBy::kPressure || contact == ContactBy::kTrigger;
}

struct HandScriptOptions {
  SimulatedHand hand = typical_hand();
  ContactBy contact = ContactBy::kDepth;
  std::int64_t interval_ns = 1'000'000;  ///< time between aims
  double plane_n_per_m = 500.0;          ///< stiffness of the surface
  double light_n = 0.1;                  ///< force for pressure 0 (F0 of docs/design/forces.md)
  double full_n = 2.0;                   ///< force for pressure 1 (F1)
  double absent_pressure = 0.5;
  /// The friction coefficient of the pen on the surface; the next members are the mass and the
  /// Coulomb friction of the device. A practised hand compensates for all three by aiming ahead of
  /// the pen.
  double friction = 0.25;
  double device_mass_kg = 0.05;
  double device_friction_n = 0.0;
  double hover_mm = 4.0;
  double lead_in_s = 0.7;  ///< time to hover until forces are on (safety_limits.h)
};

/// Returns the options for drawing on paper with this device. The stiffness is that of paper on
/// this device (plane_for), and pressure 1 is the force that draws the full width (firm_push_n), so
/// that a recorded pressure gives the recorded width.
HandScriptOptions script_options_for(const StylusPreset& device,
                                     const SimulatedHand& hand) noexcept;

/// Sets the surface that the hand draws on: its stiffness on this device, and the force for
/// pressure 1, which draws the full width on this surface. If `medium` is not null, also sets the
/// friction of the medium on the surface.
void set_surface(HandScriptOptions& options, const SurfaceMaterial& surface,
                 const Capabilities& device, const Medium* medium = nullptr) noexcept;

/// Returns how far below the surface a hand must aim to press with the force for pressure p, F = F0
/// + p (F1 - F0). At this depth, F/K + (F + friction)/k, the hand's spring k and the surface's
/// spring K are in balance. The Coulomb friction of the device counts only for a resting pen,
/// because it acts along the motion of a moving pen.
double aim_depth_mm(const HandScriptOptions& options, double pressure,
                    double speed_mm_per_s = 0.0) noexcept;

/// Returns the aims, one per interval from time 0 on, with which a hand draws these strokes. The
/// hand hovers above the start, lands, presses, draws at the recorded pace, waits a moment, lifts
/// and moves on to the next stroke. Movements in the air are minimum-jerk,
/// s = 10 t^3 - 15 t^4 + 6 t^5 (Flash, Hogan, J Neurosci 5, 1985), with an average of at most 250
/// mm/s. The aim runs ahead of the planned position of the pen to compensate for mass, surface and
/// friction, so that the pen follows the strokes.
///
/// The pen has the recorded tilt. Between strokes and in the air it keeps the last tilt.
///
/// For a dot, the pen presses for at least 60 ms, so that the dot is not lost. Points that are not
/// finite are left out. A stroke is drawn at the pace of an unhurried hand (hand_path.h) if a time
/// is missing, if a time is earlier than the one before it, or if all times are equal. Otherwise it
/// is drawn at the recorded times, but at most at 500 mm/s and with pauses of at most 1 s.
std::vector<TimedAim> script_hand(std::span<const RecordedPath> strokes,
                                  const HandScriptOptions& options);

/// Returns the aims for strokes that a WritingHand draws, including its tremor.
std::vector<TimedAim> script_hand(std::span<const Gesture> gestures, const HandOptions& writing,
                                  const HandScriptOptions& options);

}  // namespace felt
