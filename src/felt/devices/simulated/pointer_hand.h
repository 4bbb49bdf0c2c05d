#pragma once

#include <cstdint>
#include <optional>

#include "felt/devices/simulated/hand_script.h"
#include "felt/geometry/point.h"
#include "felt/rt/device.h"

namespace felt {

/// What a mouse or a tablet says.
struct PointerEvent {
  std::int64_t time_ns = 0;          ///< when it was so, on the loop's clock
  Point position{};                  ///< on the sheet, mm
  bool touching = false;             ///< the button is down, the pen is on the tablet
  std::optional<double> pressure{};  ///< 0..1, tablets only
  std::uint32_t buttons = 0;
  std::optional<double> lean_deg{};  ///< of the pen from the upright, 0..90; tablets that know it
};

/// How hard a pointer presses that senses no pressure (R18).
enum class MousePressure : std::uint8_t {
  kConstant,  ///< absent_pressure, 0.5 unless it is set
  kBySpeed,   ///< slower is harder: 0.8 at rest down to 0.2 at 300 mm/s and more
};

/// Mouse and tablet as a hand: every event becomes an aim of the simulated hand (architecture
/// section 4). On a device that pushes back, pressure is how deep the hand aims, so that plane and
/// hand balance at the force which means that pressure; without forces it is passed through. Lean
/// is passed through by all of them.
///
/// Any one thread.
class PointerHand {
 public:
  /// `hand` must outlive this. `options` is what the device and the hand are like
  /// (script_options_for).
  PointerHand(HandInput& hand, const HandScriptOptions& options,
              MousePressure mouse = MousePressure::kConstant) noexcept
      : hand_(hand), options_(options), mouse_(mouse) {}

  /// Takes the next event. One whose place is not finite is ignored.
  void point(const PointerEvent& event) noexcept;
  /// From the next event on.
  void set_mouse(MousePressure mouse) noexcept { mouse_ = mouse; }
  /// What kConstant stands for, 0..1, from the next event on.
  void set_absent_pressure(double pressure) noexcept { options_.absent_pressure = pressure; }
  /// Sets what the hand presses on (felt::set_surface), from the next event on.
  void set_surface(const SurfaceMaterial& surface, const Capabilities& device) noexcept {
    felt::set_surface(options_, surface, device);
  }
  /// The pressure that the last event stood for; 0 in the air.
  [[nodiscard]] double pressure() const noexcept { return pressure_; }

 private:
  [[nodiscard]] double pressure_of(const PointerEvent& event) noexcept;

  HandInput& hand_;
  HandScriptOptions options_;
  MousePressure mouse_;
  double pressure_ = 0.0;
  double speed_mm_per_s_ = 0.0;  // low-passed
  std::optional<PointerEvent> last_;
};

}  // namespace felt
