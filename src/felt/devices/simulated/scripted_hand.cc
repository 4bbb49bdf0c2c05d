#include "felt/devices/simulated/scripted_hand.h"

#include <algorithm>
#include <cmath>

#include "felt/devices/simulated/script_knots.h"
#include "felt/haptics/bricks/drawing_feel.h"

namespace felt {
namespace {

constexpr double kAirSpeed = 250.0;           // mm/s on average, in the air
constexpr double kTravelS = 0.12;             // shortest movement in the air
constexpr double kLandS = 0.15;               // from hovering to the first pressure
constexpr double kLiftS = 0.12;               // from the last pressure to hovering
constexpr double kSettleS = 0.03;             // rest before the pen moves, and before it lifts
constexpr double kShortestS = 0.06;           // shortest stroke, for example a dot
constexpr double kLookS = 0.008;              // window for the speed and acceleration of the plan
constexpr double kFrictionFromSpeed = 5.0;    // mm/s; below this speed, friction is reduced
constexpr double kMinContactPressure = 1e-3;  // smallest pressure that counts as contact

double press_n(const HandScriptOptions& options, double pressure) noexcept {
  return options.light_n + std::clamp(pressure, 0.0, 1.0) * (options.full_n - options.light_n);
}

// A planned position of the pen and the pressure at that position.
struct PenPlan {
  Vec3 pen;
  double pressure = 0.0;  // 0 in the air
  std::optional<double> tilt_deg{};
};

// Plans the path of the pen through all strokes, one position per interval.
class PenPlanner {
 public:
  explicit PenPlanner(const HandScriptOptions& options)
      : options_(options), interval_s_(1e-9 * static_cast<double>(options.interval_ns)) {}

  void draw(const std::vector<ScriptKnot>& knots) {
    const ScriptKnot first = knots.front(), last = knots.back();
    tilt_deg_ = first.tilt_deg;
    travel_above(first.position);
    glide(pressed(first), kLandS, 0.0);
    glide(pressed(first), kSettleS, first.pressure);
    KnotReader reader(knots);
    const auto between = static_cast<int>(std::ceil(last.t_s / interval_s_));
    for (int i = 1; i < between; ++i) {
      const ScriptKnot knot = reader.at(interval_s_ * i);
      plan_.push_back({pressed(knot), contact_pressure(knot.pressure), knot.tilt_deg});
    }
    tilt_deg_ = last.tilt_deg;
    glide(pressed(last), std::max(kSettleS, kShortestS - last.t_s), last.pressure);
    glide({last.position.x, last.position.y, options_.hover_mm}, kLiftS, 0.0);
  }

  [[nodiscard]] const std::vector<PenPlan>& plan() const { return plan_; }

 private:
  static double contact_pressure(double pressure) {
    return std::max(pressure, kMinContactPressure);
  }

  [[nodiscard]] Vec3 pressed(const ScriptKnot& knot) const {
    const double depth_mm = is_by_pressure(options_.contact)
                                ? 0.0
                                : 1e3 * press_n(options_, knot.pressure) / options_.plane_n_per_m;
    return {knot.position.x, knot.position.y, -depth_mm};
  }

  // Plans a movement to `to` with minimum jerk; pressure 0 means in the air.
  void glide(const Vec3& to, double duration_s, double pressure) {
    const Vec3 from = plan_.back().pen;
    const int steps = std::max(1, static_cast<int>(std::ceil(duration_s / interval_s_)));
    for (int i = 1; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const bool in_air = pressure == 0.0 && to.z >= 0.0;
      plan_.push_back({lerp(from, to, t * t * t * (10.0 + t * (6.0 * t - 15.0))),
                       in_air || to != from ? 0.0 : contact_pressure(pressure), tilt_deg_});
    }
  }

  void travel_above(Point start) {
    const Vec3 above{start.x, start.y, options_.hover_mm};
    if (plan_.empty()) {
      plan_.push_back({above, 0.0, tilt_deg_});
      glide(above, options_.lead_in_s, 0.0);
    } else {
      glide(above, kTravelS + norm(above - plan_.back().pen) / kAirSpeed, 0.0);
    }
  }

  const HandScriptOptions& options_;
  double interval_s_;
  std::optional<double> tilt_deg_;  // tilt in the air, and while the pen rests
  std::vector<PenPlan> plan_;
};

// Makes the aims that move a pen along a plan. The mass m of pen and hand, the hand's spring k and
// damper b and the forces F on the pen are given. To compensate for them, the hand aims ahead of
// the pen by e = aim - pen, which solves
//   b e' + k e = m x'' - F
class AimMaker {
 public:
  AimMaker(const HandScriptOptions& options, const std::vector<PenPlan>& plan)
      : options_(options),
        plan_(plan),
        interval_s_(1e-9 * static_cast<double>(options.interval_ns)),
        look_(std::max<std::ptrdiff_t>(1, std::llround(kLookS / interval_s_))) {}

  std::vector<TimedAim> make() {
    std::vector<TimedAim> aims;
    Vec3 ahead;
    const double delay_s = options_.hand.damping_n_s_per_m / options_.hand.stiffness_n_per_m;
    for (std::size_t i = 0; i < plan_.size(); ++i) {
      TimedAim aim{.time_ns = options_.interval_ns * static_cast<std::int64_t>(i),
                   .target_mm = plan_[i].pen,
                   .tilt_deg = plan_[i].tilt_deg};
      if (is_by_pressure(options_.contact)) aim.pressure = plan_[i].pressure;
      if (options_.contact != ContactBy::kPressure) {
        const Vec3 wanted = (1e3 / options_.hand.stiffness_n_per_m) * push_needed(i);
        ahead += (interval_s_ / (delay_s + interval_s_)) * (wanted - ahead);
        aim.target_mm += ahead;
      }
      aims.push_back(aim);
    }
    return aims;
  }

 private:
  [[nodiscard]] const Vec3& pen(std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(plan_.size()) - 1;
    return plan_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))].pen;
  }

  // Returns the force, in N, that the hand must apply so that the pen follows the plan at this
  // position.
  [[nodiscard]] Vec3 push_needed(std::size_t index) const {
    const auto i = static_cast<std::ptrdiff_t>(index);
    const double look_s = interval_s_ * static_cast<double>(look_);
    const Vec3 velocity = (0.5 / look_s) * (pen(i + look_) - pen(i - look_));
    const Vec3 acceleration =
        (1.0 / (look_s * look_s)) * (pen(i + look_) + pen(i - look_) - 2.0 * pen(i));
    const double mass_kg = options_.device_mass_kg + options_.hand.mass_kg;
    Vec3 push = 1e-3 * mass_kg * acceleration;
    const Vec3 way = (1.0 / (norm(velocity) + kFrictionFromSpeed)) * velocity;
    push += options_.device_friction_n * way;
    const double depth_mm = std::max(0.0, -pen(i).z);
    if (depth_mm > 0.0 && options_.contact != ContactBy::kDepthInAir) {
      const double plane_n = 1e-3 * options_.plane_n_per_m * depth_mm;
      // The device renders what the surface has beyond the device's own friction (Friction).
      const double own_n = std::min(options_.device_friction_n, kPencilOnPaper * plane_n);
      push += std::max(0.0, options_.friction * plane_n - own_n) * Vec3{way.x, way.y, 0.0};
      // For a resting pen, the direction of the device's friction is unknown. So that the pen still
      // presses enough, the force is increased by this friction. A sliding pen does not need this,
      // because the friction then acts along the motion.
      push.z -= plane_n + options_.device_friction_n * (1.0 - norm(way));
    }
    return push;
  }

  const HandScriptOptions& options_;
  const std::vector<PenPlan>& plan_;
  double interval_s_;
  std::ptrdiff_t look_;
};

std::vector<TimedAim> aims_for(const HandScriptOptions& options, const PenPlanner& planner) {
  return AimMaker(options, planner.plan()).make();
}

}  // namespace

HandScriptOptions script_options_for(const StylusPreset& device,
                                     const SimulatedHand& hand) noexcept {
  const Capabilities& can = device.capabilities;
  HandScriptOptions options{.hand = hand};
  options.interval_ns = can.period_ns;
  if (!can.has_force()) {
    options.contact = ContactBy::kPressure;
    return options;
  }
  if (device.has_trigger) options.contact = ContactBy::kTrigger;
  set_surface(options, SurfaceMaterial(), can);
  options.device_mass_kg = device.mechanics.mass_kg;
  options.device_friction_n = device.mechanics.friction_n;
  return options;
}

void set_surface(HandScriptOptions& options, const SurfaceMaterial& surface,
                 const Capabilities& device, const Medium* medium) noexcept {
  options.plane_n_per_m = plane_for(surface, device).stiffness_n_per_m;
  options.full_n = firm_push_n(device);
  if (medium) options.friction = friction_of(*medium, surface);
}

double aim_depth_mm(const HandScriptOptions& options, double pressure,
                    double speed_mm_per_s) noexcept {
  const double press = press_n(options, pressure);
  const double sticks = kFrictionFromSpeed / (std::abs(speed_mm_per_s) + kFrictionFromSpeed);
  return 1e3 * (press / options.plane_n_per_m +
                (press + sticks * options.device_friction_n) / options.hand.stiffness_n_per_m);
}

std::vector<TimedAim> script_hand(std::span<const RecordedPath> strokes,
                                  const HandScriptOptions& options) {
  PenPlanner planner(options);
  for (const RecordedPath& path : strokes) {
    const std::vector<ScriptKnot> knots = knots_of(path, options.absent_pressure);
    if (!knots.empty()) planner.draw(knots);
  }
  return aims_for(options, planner);
}

std::vector<TimedAim> script_hand(std::span<const Gesture> gestures, const HandOptions& writing,
                                  const HandScriptOptions& options) {
  WritingHand hand(writing);
  std::vector<RecordedPath> strokes;
  for (const Gesture& gesture : gestures) {
    RecordedPath path;
    for (const HandSample& s : hand.draw(gesture)) {
      path.push_back({s.position, s.pressure, s.time_ns});
    }
    strokes.push_back(std::move(path));
  }
  return script_hand(strokes, options);
}

}  // namespace felt
