#pragma once

#include <cstdint>
#include <optional>

#include "felt/devices/simulated/scripted_hand.h"
#include "felt/geometry/point.h"
#include "felt/rt/device.h"

namespace felt {

/// An event of a mouse or a tablet.
struct PointerEvent {
  std::int64_t time_ns = 0;          ///< on the loop's clock
  Point position{};                  ///< on the page, mm
  bool touching = false;             ///< the mouse button is down, or the pen is on the tablet
  std::optional<double> pressure{};  ///< 0..1; only from tablets
  std::uint32_t buttons = 0;
  std::optional<double> tilt_deg{};  ///< tilt from the upright, 0..90; only from some tablets
  /// Height above the page of what the hand touches there, mm: that of a body.
  double height_mm = 0.0;
};

/// The pressure for a pointer that cannot sense it (R18).
enum class MousePressure : std::uint8_t {
  kConstant,  ///< absent_pressure; the default is 0.5
  /// Falls with the logarithm of the speed, from 0.8 up to 5 mm/s to 0.2 from 120 mm/s on. People
  /// draw with a mouse at about 24 mm/s, where it is 0.5.
  kBySpeed,
};

/// Returns the pressure of MousePressure::kBySpeed.
[[nodiscard]] double pressure_by_speed(double mm_per_s) noexcept;

/// Converts each event of a mouse or tablet to an aim of the simulated hand
/// (docs/design/loop.md#data-flow). On a device that pushes back, pressure sets how far below the
/// surface the hand aims, so that the hand presses with the force for that pressure. On a device
/// without forces, pressure is passed on unchanged. Tilt is always passed on unchanged.
///
/// For use by one thread at a time.
class PointerHand {
 public:
  /// `hand` must outlive this. `options` describes the device and the hand (script_options_for).
  PointerHand(HandInput& hand, const HandScriptOptions& options,
              MousePressure mouse = MousePressure::kConstant) noexcept
      : hand_(hand), options_(options), mouse_(mouse) {}

  /// Handles the next event. Ignores it if its position is not finite.
  void point(const PointerEvent& event) noexcept;
  /// Sets the pressure of pointers without a sensor, from the next event on.
  void set_mouse(MousePressure mouse) noexcept { mouse_ = mouse; }
  /// Sets the pressure that MousePressure::kConstant uses, 0..1, from the next event on.
  void set_absent_pressure(double pressure) noexcept { options_.absent_pressure = pressure; }
  /// Sets the surface that the hand presses on (felt::set_surface), from the next event on.
  void set_surface(const SurfaceMaterial& surface, const Capabilities& device) noexcept {
    felt::set_surface(options_, surface, device);
  }
  /// Returns the pressure of the last event; 0 in the air.
  [[nodiscard]] double pressure() const noexcept { return pressure_; }

 private:
  [[nodiscard]] double pressure_of(const PointerEvent& event) noexcept;

  HandInput& hand_;
  HandScriptOptions options_;
  MousePressure mouse_;
  double pressure_ = 0.0;
  double speed_mm_per_s_ = 0.0;  // low-pass filtered
  std::optional<PointerEvent> last_;
};

}  // namespace felt
