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
};

/// The pressure for a pointer that cannot sense it (R18).
enum class MousePressure : std::uint8_t {
  kConstant,  ///< absent_pressure; the default is 0.5
  kBySpeed,   ///< rises for 60 ms, and falls with the speed (PointerHand::pressure_at)
};

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

  /// Returns the pressure that MousePressure::kBySpeed uses: 0.8 at rest, 0.5 at 42 mm/s, and close
  /// to 0.2 from 200 mm/s on. Writing with a mouse is slow (a median of 24 mm/s was measured), so
  /// the pressure changes most at low speeds.
  [[nodiscard]] static double pressure_at(double mm_per_s) noexcept;

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
  std::int64_t down_ns_ = 0;     // time of the touch
  std::optional<PointerEvent> last_;
};

}  // namespace felt
