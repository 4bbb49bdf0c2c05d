#include "felt/devices/simulated/pointer_hand.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kSpeedTimeS = 0.05;
constexpr double kSlowMmPerS = 5.0, kFastMmPerS = 120.0;
constexpr double kSlowPressure = 0.8, kFastPressure = 0.2;
constexpr double kMinTouchPressure = 1e-3;  // pressure of a touching pen

}  // namespace

double pressure_by_speed(double mm_per_s) noexcept {
  const double speed = std::clamp(mm_per_s, kSlowMmPerS, kFastMmPerS);
  const double part = std::log(speed / kSlowMmPerS) / std::log(kFastMmPerS / kSlowMmPerS);
  return kSlowPressure + part * (kFastPressure - kSlowPressure);
}

double PointerHand::pressure_of(const PointerEvent& event) noexcept {
  if (last_) {
    // Subtracts in double, because the difference of two arbitrary times may not fit into 64 bits.
    const double dt_s =
        1e-9 * (static_cast<double>(event.time_ns) - static_cast<double>(last_->time_ns));
    if (dt_s > 0.0) {
      speed_mm_per_s_ += (distance(event.position, last_->position) - dt_s * speed_mm_per_s_) /
                         (kSpeedTimeS + dt_s);
    }
  }
  if (!event.touching) return 0.0;
  if (event.pressure && !std::isnan(*event.pressure)) {
    return std::clamp(*event.pressure, kMinTouchPressure, 1.0);
  }
  if (mouse_ == MousePressure::kConstant) return options_.absent_pressure;
  return pressure_by_speed(speed_mm_per_s_);
}

void PointerHand::point(const PointerEvent& event) noexcept {
  if (!is_finite(event.position)) return;
  pressure_ = pressure_of(event);
  last_ = event;
  const double height_mm = event.touching ? 0.0 : options_.hover_mm;
  Aim aim{.target_mm = {event.position.x, event.position.y, height_mm},
          .buttons = event.buttons,
          .tilt_deg = event.tilt_deg};
  if (is_by_pressure(options_.contact)) {
    aim.pressure = pressure_;
  } else if (event.touching) {
    aim.target_mm.z = -aim_depth_mm(options_, pressure_, speed_mm_per_s_);
  }
  if (std::isfinite(event.height_mm)) aim.target_mm.z += event.height_mm;
  hand_.aim_at(event.time_ns, aim);
}

}  // namespace felt
