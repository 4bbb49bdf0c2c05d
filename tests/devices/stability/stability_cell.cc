#include "tests/devices/stability/stability_cell.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "felt/devices/simulated/held_body.h"
#include "felt/devices/simulated/high_pass.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/geometry/testing/ball.h"
#include "felt/haptics/bricks/band_damping.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/bricks/push_clicks.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/solid_surface.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"
#include "felt/tools/choice_ring.h"
#include "felt/tools/fill/fill_force.h"
#include "felt/tools/gather/gather_force.h"
#include "felt/tools/guided_feel.h"
#include "felt/tools/pencil/shape_hold.h"
#include "felt/tools/read/read_force.h"
#include "tests/devices/stability/pen_plan.h"

namespace felt {
namespace {

constexpr double kHighFromHz = 30.0;
constexpr double kBundleMm = 1.0;  // spread at which the resistance of a bundle is largest
// Pressing force, N. Small enough for the safety chain to allow it with a Touch during a whole
// trial, with the other forces.
constexpr double kPressN = 0.8;
constexpr double kPressBesidesN = 0.4;
constexpr double kPressBeforeLettingGoN = 0.15;
constexpr double kTriggerPressure = 0.5;

double press_of(const StabilityCell& cell) {
  if (cell.hand == nullptr) return kPressBeforeLettingGoN;
  const bool other_forces = cell.trial >= Trial::kWell;
  return other_forces ? kPressBesidesN : kPressN;
}

StylusPreset device_of(const StabilityCell& cell) {
  StylusPreset device = *cell.device;
  device.capabilities.delay_ticks = cell.delay_ticks;
  device.capabilities.period_ns = cell.period_ns;
  center_workspace(device.capabilities, kTrialPlace + Vec{12.0, 0.0});
  return device;
}

// Returns a straight path along y through kTrialPlace.
GuidePiece straight_path() {
  GuidePiece piece;
  piece.count = GuidePiece::kPoints;
  piece.at_mm = 0.5 * piece.spacing_mm * static_cast<double>(piece.count - 1);
  for (std::size_t i = 0; i < piece.count; ++i) {
    const double along_mm = piece.spacing_mm * static_cast<double>(i) - piece.at_mm;
    piece.points[i] = kTrialPlace + Vec{0.0, along_mm};
  }
  return piece;
}

constexpr double kTeacherMmPerS = 40.0;

// Returns the law of a guide of a drawing on a device.
GuideLaw law_of(Trial trial, const Capabilities& device) {
  if (trial == Trial::kRay || trial == Trial::kNode) return GuideLaw::tick(1.0, GuideLaw::kTickMm);
  if (trial == Trial::kRing) return ring_law(kRingMm);
  if (trial == Trial::kEdge) return GuideLaw::error_amplifying(1.0);
  GuideLaw law = GuideLaw::line(1.0, guide_spring_for(device));
  law.is_edge = trial == Trial::kRuler;
  if (trial == Trial::kPerspective) law.click_n = 0.2;
  if (trial == Trial::kTeacher) {
    law.lead_n = GuideLaw::teacher(1.0).lead_n;
    law.lead_n_s_per_m = GuideLaw::teacher(1.0).lead_n_s_per_m;
  }
  return law;
}

// Returns the path of a guide of a drawing, which passes through kTrialPlace along y.
GuidePiece guide_path_of(Trial trial) {
  GuidePiece piece = straight_path();
  if (trial == Trial::kNode) {
    piece.count = 1;
    piece.at_mm = 0.0;
    piece.points[0] = kTrialPlace;
  }
  const double radius_mm = trial == Trial::kEllipse ? 5.0 : 20.0;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const double along_mm = piece.spacing_mm * static_cast<double>(i) - piece.at_mm;
    if (trial == Trial::kCompass || trial == Trial::kEllipse) {
      const double angle = along_mm / radius_mm;
      piece.points[i] = kTrialPlace + radius_mm * Vec{std::cos(angle) - 1.0, std::sin(angle)};
    } else if (trial == Trial::kTrace) {
      piece.points[i] = kTrialPlace + Vec{std::sin(0.5 * along_mm), along_mm};
    } else if (trial == Trial::kTeacher) {
      piece.speeds_mm_per_s[i] = static_cast<float>(kTeacherMmPerS);
    }
  }
  return piece;
}

// Returns the medium as the tool of this trial scales it: Fill and Gather glide more than a pencil.
Medium scaled_tool(const StabilityCell& cell) {
  if (cell.trial == Trial::kRidge) return scaled_medium(*cell.tool, kFillGlide, kFillGlide);
  if (cell.trial == Trial::kBundle) return scaled_medium(*cell.tool, kGatherGlide, kGatherGlide);
  if (cell.trial == Trial::kEdge || cell.trial == Trial::kClick) return *cell.tool;
  if (is_on_body(cell.trial)) return *cell.tool;
  if (is_guide_of_drawing(cell.trial)) return guided_medium(*cell.tool);
  return *cell.tool;
}

// Returns the surface with the resistance of the widest bundle, without grain.
ForceModel bundle_model(const StabilityCell& cell, const Medium& tool, const Capabilities& device) {
  const FrictionOptions friction = friction_for(tool, *cell.surface, device);
  return ForceModel(Compose(Plane(plane_for(*cell.surface, device)),
                            BundleFeel(kBundleMm, friction.coefficient, 1.0), Friction(friction)));
}

// Returns the forces of the tool Read where they are stiffest: at the end of a line.
ForceModel read_model(const StabilityCell& cell, const Capabilities& device) {
  const Guide groove(GuideLaw::groove(kReadGrooveShare), straight_path());
  return read_feel(*cell.surface, device, 1.0, &groove, &kTrialPlace);
}

// Returns the force of a ring whose well on the right is at kTrialPlace.
ForceModel ring_model(const StabilityCell& cell, const Capabilities& device) {
  ChoiceRing ring(kTrialPlace - Vec{kRingMm, 0.0}, {0.0, -kRingMm}, {kRingMm, 0.0});
  ring.choose(2);
  return ring_force(ring, *cell.surface, device);
}

// Returns the surface with a click where the pen rests and one half of the way deeper.
ForceModel click_model(const StabilityCell& cell, const SurfaceForce& surface,
                       const Capabilities& device) {
  const double rest_mm = 1e3 * press_of(cell) / plane_for(*cell.surface, device).stiffness_n_per_m;
  PushClicks clicks;
  clicks.add(rest_mm);
  clicks.add(rest_mm + 0.5 * kClickWayMm);
  return ForceModel(Compose(surface, clicks));
}

// Returns the surface of a ball that touches the page from below at kTrialPlace. It has about as
// many triangles as the window makes for a drawing.
ForceModel body_model(const StabilityCell& cell, const Capabilities& device) {
  constexpr double r = kBodyRadiusMm;
  static const TriangleTree body(
      testing::ball({kTrialPlace.x, kTrialPlace.y, -r}, {r, r, r}, 50, 50));
  return ForceModel(make_solid_surface(body, *cell.surface, *cell.tool, device, 1));
}

ForceModel model_of(const StabilityCell& cell, const Capabilities& device) {
  // Grain is tested at rest only: there it must add no force. It may be felt while the pen moves.
  const HeightField* grain = cell.trial == Trial::kRest ? surface_grain(*cell.surface) : nullptr;
  const Medium tool = scaled_tool(cell);
  const SurfaceForce surface = make_surface_force(*cell.surface, tool, device, grain);
  switch (cell.trial) {
    case Trial::kWell:
      return ForceModel(Compose(surface, SnapWells(kTrialPlace)));
    case Trial::kEdit:
      return ForceModel(Compose(surface, EditSpring(kTrialPlace)));
    case Trial::kGuide:
      return ForceModel(Compose(surface, Guide(GuideLaw::groove(1.0), straight_path())));
    case Trial::kRidge:
      return ForceModel(Compose(surface, Guide(GuideLaw::error_amplifying(1.0), straight_path())));
    case Trial::kBundle:
      return bundle_model(cell, tool, device);
    case Trial::kShake:
      return ForceModel(Compose(surface, BandDamping(band_damping_for(kShakeHz, device))));
    case Trial::kHold:
      return ForceModel(Compose(surface, SnapWells(kTrialPlace, hold_shape(1.0))));
    case Trial::kRead:
      return read_model(cell, device);
    case Trial::kRing:
      return ring_model(cell, device);
    case Trial::kClick:
      return click_model(cell, surface, device);
    case Trial::kFlank:
    case Trial::kSlide:
      return body_model(cell, device);
    case Trial::kRest:
    case Trial::kSlow:
    case Trial::kTap:
      return ForceModel(surface);
    default:
      return ForceModel(
          Compose(surface, Guide(law_of(cell.trial, device), guide_path_of(cell.trial))));
  }
}

// Accumulates the measurements of a trial.
class Meter {
 public:
  Meter(const TrialTimes& times, bool per_contact, double period_s)
      : times_(times),
        per_contact_(per_contact),
        x_(kHighFromHz, period_s),
        y_(kHighFromHz, period_s),
        z_(kHighFromHz, period_s) {}

  // Adds one tick. `acted` is the force while the pen moved from its last position to `pen`.
  void add(double t_s, const Vec3& pen, const Force& acted) {
    const Force high{x_(acted.x), y_(acted.y), z_(acted.z)};
    if (t_s > times_.measure_from_s && t_s <= times_.measure_until_s) {
      sum_squares_ += dot(high, high);
      sum_press_n_ += acted.z;
      ++count_;
    }
    if (has_last_ && t_s > times_.energy_from_s) work_mj_ += work_mj(acted, pen - last_);
    last_ = pen;
    has_last_ = true;
    if (per_contact_ && pen.z > 0.0 && norm(acted) == 0.0) end_contact();
    result.finite = result.finite && is_finite(pen) && is_finite(acted);
  }
  StabilityResult finish() {
    end_contact();
    if (count_ > 0) {
      result.high_frequency_n = std::sqrt(sum_squares_ / static_cast<double>(count_));
      result.mean_press_n = sum_press_n_ / static_cast<double>(count_);
    }
    return result;
  }

  StabilityResult result;

 private:
  void end_contact() {
    result.energy_mj = std::max(result.energy_mj, work_mj_);
    work_mj_ = 0.0;
  }

  TrialTimes times_;
  bool per_contact_;
  HighPass x_, y_, z_;
  double sum_squares_ = 0.0, sum_press_n_ = 0.0, work_mj_ = 0.0;
  int count_ = 0;
  Vec3 last_;
  bool has_last_ = false;
};

// A hand that knows the load on its pen. It aims past the planned position by e, so that its spring
// and damper balance load, mass and friction: b e' + k e = m x'' - load (as in scripted_hand.h).
class KnowingHand {
 public:
  KnowingHand(const StabilityCell& cell, const SimulatedHand& hand, const PlanGround& ground)
      : trial_(cell.trial),
        hand_(hand),
        ground_(ground),
        mass_kg_(cell.device->mechanics.mass_kg + hand.mass_kg),
        device_friction_n_(cell.device->mechanics.friction_n),
        period_s_(1e-9 * static_cast<double>(cell.period_ns)) {}

  Vec3 aim_at(double t_s) noexcept {
    const PlannedPen planned = planned_pen(trial_, ground_, t_s);
    const Vec3 before = planned_pen(trial_, ground_, t_s - kLookS).pen;
    const Vec3 after = planned_pen(trial_, ground_, t_s + kLookS).pen;
    const Vec3 acceleration = (1.0 / (kLookS * kLookS)) * (before + after - 2.0 * planned.pen);
    Vec3 push = 1e-3 * mass_kg_ * acceleration;
    push -= {planned.load.x, planned.load.y, planned.load.z};
    if (planned.load.z > 0.0) push.z -= device_friction_n_;
    if (planned.load.x != 0.0) push.x += std::copysign(device_friction_n_, -planned.load.x);
    const double delay_s = hand_.damping_n_s_per_m / hand_.stiffness_n_per_m;
    ahead_ +=
        (period_s_ / (delay_s + period_s_)) * ((1e3 / hand_.stiffness_n_per_m) * push - ahead_);
    return planned.pen + ahead_;
  }

 private:
  static constexpr double kLookS = 0.005;

  Trial trial_;
  SimulatedHand hand_;
  PlanGround ground_;
  double mass_kg_, device_friction_n_, period_s_;
  Vec3 ahead_;
};

}  // namespace

std::string_view name_of(Trial trial) noexcept {
  switch (trial) {
    case Trial::kRest:
      return "rest";
    case Trial::kSlow:
      return "slow";
    case Trial::kTap:
      return "tap";
    case Trial::kWell:
      return "well";
    case Trial::kEdit:
      return "edit";
    case Trial::kGuide:
      return "guide";
    case Trial::kRidge:
      return "ridge";
    case Trial::kBundle:
      return "bundle";
    case Trial::kShake:
      return "shake";
    case Trial::kHold:
      return "hold";
    case Trial::kRead:
      return "read";
    case Trial::kRuler:
      return "ruler";
    case Trial::kLine:
      return "line";
    case Trial::kCompass:
      return "compass";
    case Trial::kEllipse:
      return "ellipse";
    case Trial::kPerspective:
      return "perspective";
    case Trial::kRay:
      return "ray";
    case Trial::kNode:
      return "node";
    case Trial::kTrace:
      return "trace";
    case Trial::kTeacher:
      return "teacher";
    case Trial::kRing:
      return "ring";
    case Trial::kEdge:
      return "edge";
    case Trial::kClick:
      return "click";
    case Trial::kFlank:
      return "flank";
    case Trial::kSlide:
      return "slide";
  }
  return "";
}

std::string rate_name(std::int64_t period_ns) {
  return period_ns > 1'000'000 ? std::to_string(1'000'000'000 / period_ns) + " Hz"
                               : std::to_string(1'000'000 / period_ns) + " kHz";
}

std::string name_of(const StabilityCell& cell) {
  std::string name(name_of(cell.trial));
  name += ' ';
  name += cell.device->name;
  name += '/';
  name += cell.hand != nullptr ? cell.hand->name : "let go";
  name += ' ';
  name += rate_name(cell.period_ns) + " delay ";
  name += std::to_string(cell.delay_ticks) + ' ';
  name += cell.surface->id;
  name += ' ';
  name += cell.tool->id;
  return name;
}

bool passes(const StabilityResult& result) noexcept {
  return result.finite && result.fault == SafetyFault::kNone &&
         result.high_frequency_n < kCleanForceN && result.energy_mj <= kPassiveEnergyMj;
}

StabilityResult run_trial(const StabilityCell& cell) {
  const StylusPreset device = device_of(cell);
  const Capabilities& can = device.capabilities;
  const bool lets_go = cell.hand == nullptr;
  const SimulatedHand hand = lets_go ? typical_hand() : *cell.hand;
  SimulatedStylus stylus(device, hand);
  stylus.place(planned_pen(cell.trial, {}, 0.0).pen);
  ServoOptions options{.period_ns = cell.period_ns, .limits = limits_for(can)};
  const auto servo = std::make_unique<Servo>(stylus, options);
  servo->publish(model_of(cell, can));
  servo->arm();

  PlanGround ground{.plane_n_per_m = plane_for(*cell.surface, can).stiffness_n_per_m,
                    .press_n = press_of(cell)};
  const FrictionOptions friction = friction_for(scaled_tool(cell), *cell.surface, can);
  const double own = std::min(friction.own_friction_n / ground.press_n, friction.own_coefficient);
  ground.friction = std::max(0.0, friction.coefficient - own);
  if (cell.trial == Trial::kBundle) {
    ground.friction += std::min(BundleFeel::kMaxN / ground.press_n, BundleFeel::kMaxFactor);
  }
  if (cell.trial == Trial::kRing) ground.friction = 0.0;
  if (is_guide_of_drawing(cell.trial)) ground.guide = law_of(cell.trial, can);
  const TrialTimes times = times_of(cell.trial, lets_go);
  Meter meter(times, cell.trial == Trial::kTap, 1e-9 * static_cast<double>(cell.period_ns));
  KnowingHand knowing(cell, hand, ground);
  VirtualClock clock(*servo);
  bool holds = true;
  while (1e-9 * static_cast<double>(clock.next_ns()) < times.end_s) {
    const double t_s = 1e-9 * static_cast<double>(clock.next_ns());
    const Vec3 aim_mm = knowing.aim_at(t_s);
    std::optional<double> pressure;  // of a pen without height
    if (can.has_force() && !device.renders_surface())
      pressure = aim_mm.z < 0.0 ? kTriggerPressure : 0.0;
    stylus.aim(aim_mm, pressure, 0);
    if (lets_go && holds && t_s >= times.release_s) {
      stylus.hold(std::nullopt);
      holds = false;
    }
    const TickReport& tick = clock.tick();
    meter.add(t_s, stylus.body().position(), stylus.acting_force());
    if (tick.safety.fault != SafetyFault::kNone) meter.result.fault = tick.safety.fault;
  }
  return meter.finish();
}

}  // namespace felt
