#include "felt/devices/simulated/stroke_forces.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "felt/base/constants.h"
#include "felt/devices/simulated/high_pass.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"

namespace felt {
namespace {

constexpr double kHoverMm = 3.0;
constexpr double kArmedS = 0.8;  // after this time the safety chain passes full forces
constexpr double kLandedS = 1.3;
constexpr double kStillS = 0.2;  // rest before the pen moves

// The tremor of the hand: three sines of 6 to 12 Hz, 0.03 mm each.
class Tremor {
 public:
  explicit Tremor(std::uint32_t seed) {
    if (seed == 0) return;
    std::mt19937 random(seed);
    const auto part = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (Sine& sine : sines_) sine = {6.0 + 6.0 * part(), part(), 0.03 * part(), 0.03 * part()};
    place_ = {20.0 * part() - 10.0, 20.0 * part() - 10.0};
  }
  [[nodiscard]] Vec at(double t_s) const {
    Vec sum{};
    for (const Sine& s : sines_) {
      sum = sum + std::sin(kTau * (s.hz * t_s + s.phase)) * Vec{s.x_mm, s.y_mm};
    }
    return sum;
  }
  // Returns the offset of this stroke on the page.
  [[nodiscard]] Vec place() const { return place_; }

 private:
  struct Sine {
    double hz = 0.0, phase = 0.0, x_mm = 0.0, y_mm = 0.0;
  };
  Sine sines_[3];
  Vec place_{};
};

double smooth(double from_s, double until_s, double t_s) {
  const double t = std::clamp((t_s - from_s) / (until_s - from_s), 0.0, 1.0);
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

// Returns the distance along a leg, mm, at a time since its start. The pen reaches full speed after
// a tenth of a second.
double way_mm(double speed, double t_s) {
  constexpr double kRampS = 0.1;
  if (t_s <= 0.0) return 0.0;
  return t_s < kRampS ? 0.5 * speed * t_s * t_s / kRampS : speed * (t_s - 0.5 * kRampS);
}

}  // namespace

StrokeForces draw_stroke(const StrokePlan& plan) {
  constexpr Point kMiddle{30.0, 30.0};
  StylusPreset device = *plan.device;
  device.capabilities.period_ns = plan.period_ns;
  center_workspace(device.capabilities, kMiddle + Vec{0.5 * plan.leg_mm, 0.5 * plan.leg_mm});
  const Capabilities& can = device.capabilities;
  SimulatedStylus stylus(device, *plan.hand);
  const Tremor tremor(plan.seed);
  const Point start = kMiddle + tremor.place();
  stylus.place({start.x, start.y, kHoverMm});
  const auto servo = std::make_unique<Servo>(
      stylus, ServoOptions{.period_ns = plan.period_ns, .limits = limits_for(can), .queued = 2});
  const HeightField* grain = plan.has_grain ? surface_grain(*plan.surface) : nullptr;
  servo->publish(ForceModel(make_surface_force(*plan.surface, *plan.tool, can, grain)));
  servo->arm();

  // The depth below the surface at which the hand must aim to press with this force: the springs of
  // the hand and the surface are in series.
  const double surface_n_per_m = plane_for(*plan.surface, can).stiffness_n_per_m;
  const double depth_mm =
      1e3 * plan.press_n * (1.0 / surface_n_per_m + 1.0 / plan.hand->stiffness_n_per_m);
  const double start_s = kLandedS + kStillS + std::max(plan.rest_s, 0.0);
  const double leg_s = plan.leg_mm / plan.speed_mm_per_s + 0.05;
  StrokeForces forces;
  forces.leg_s = plan.leg_mm / plan.speed_mm_per_s;
  forces.period_s = 1e-9 * static_cast<double>(plan.period_ns);
  forces.device_friction_n = device.mechanics.friction_n;
  forces.viscous_n =
      std::min(Friction::kMaxViscousN,
               1e-3 * friction_for(*plan.tool, *plan.surface, can).viscosity_n_s_per_m *
                   std::max(0.0, plan.speed_mm_per_s - kUnknownSpeedMmPerS));
  VirtualClock clock(*servo);
  bool has_touched = false;
  while (true) {
    const double t_s = 1e-9 * static_cast<double>(clock.next_ns());
    if (t_s >= start_s + 2.0 * leg_s) break;
    const double first_s = std::min(t_s - start_s, leg_s), second_s = t_s - start_s - leg_s;
    const Vec trembling = tremor.at(t_s);
    stylus.aim({start.x + way_mm(plan.speed_mm_per_s, first_s) + trembling.x,
                start.y + way_mm(plan.speed_mm_per_s, second_s) + trembling.y,
                kHoverMm - (kHoverMm + depth_mm) * smooth(kArmedS, kLandedS, t_s)},
               {}, 0);
    const TickReport& tick = clock.tick();
    if (tick.safety.fault != SafetyFault::kNone) forces.is_sound = false;
    const Force& force = stylus.acting_force();
    has_touched = has_touched || force.z > 0.02;
    const auto is_middle = [&](double in_leg_s) {
      return in_leg_s > std::max(0.1 * leg_s, 0.2) && in_leg_s <= leg_s;
    };
    if (has_touched && t_s < kLandedS) forces.touching.push_back(force);
    if (t_s > kLandedS && first_s <= 0.0) forces.resting.push_back(force);
    if (second_s <= 0.0 && is_middle(first_s)) forces.along_x.push_back(force);
    if (is_middle(second_s)) forces.along_y.push_back(force);
  }
  return forces;
}

double force_above_30_hz_n(std::span<const Force> forces, double period_s) {
  constexpr double kFromHz = 30.0, kFilterSettleS = 0.1;
  HighPass x(kFromHz, period_s), y(kFromHz, period_s), z(kFromHz, period_s);
  const auto first = static_cast<std::size_t>(kFilterSettleS / period_s);
  double sum = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const Vec3 high{x(forces[i].x - forces[0].x), y(forces[i].y - forces[0].y),
                    z(forces[i].z - forces[0].z)};
    if (i >= first) sum += dot(high, high);
  }
  return forces.size() > first ? std::sqrt(sum / static_cast<double>(forces.size() - first)) : 0.0;
}

}  // namespace felt
