#include "felt/haptics/bricks/drawing_feel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/haptics/safety/safety_guards.h"
#include "felt/haptics/safety/safety_stages.h"

namespace felt {
namespace {

constexpr double kOneSpring = 300.0;
/// Coefficient of friction from which on the whole viscosity acts.
constexpr double kDampedFriction = 0.1;
/// Maximum change of a force by one step of the position sensor.
constexpr double kQuietStepN = 0.025;
constexpr double kSoftest = 200.0;
constexpr double kMinB = 0.5;

double period_s(const Capabilities& device) noexcept {
  return 1e-9 * static_cast<double>(device.period_ns);
}

// Maximum stiffness and damping at which one step of the position sensor changes the force by at
// most kQuietStepN.
struct QuietLimits {
  double stiffness_n_per_m = std::numeric_limits<double>::infinity();
  double damping_n_s_per_m = std::numeric_limits<double>::infinity();
};

QuietLimits quiet_limits(const Capabilities& device) noexcept {
  if (!(device.position_step_mm > 0.0)) return {};
  const double step_m = 1e-3 * device.position_step_mm;
  const double seen_over_s = Plane::kSpeedFilterS + period_s(device);
  return {std::max(kQuietStepN / step_m, kSoftest),
          std::max(kQuietStepN * seen_over_s / step_m, kMinB)};
}

}  // namespace

double stiffness_budget_n_per_m(const Capabilities& device) noexcept {
  return stiffness_budget_n_per_m(limits_for(device));
}

PlaneOptions plane_for(const SurfaceMaterial& surface, const Capabilities& device) noexcept {
  PlaneOptions plane{surface.stiffness_n_per_m, surface.damping_n_s_per_m};
  const QuietLimits quiet = quiet_limits(device);
  double hardest = std::min(stiffness_budget_n_per_m(device), quiet.stiffness_n_per_m);
  if (device.max_stiffness_n_per_m > 0.0) {
    hardest = std::min(hardest, 0.9 * device.max_stiffness_n_per_m);
  }
  const double share = std::sqrt(std::min(surface.stiffness_n_per_m / kHardestNPerM, 1.0));
  plane.stiffness_n_per_m = std::min(plane.stiffness_n_per_m, share * hardest);
  if (device.max_damping_n_s_per_m > 0.0) {
    plane.damping_n_s_per_m = std::min(plane.damping_n_s_per_m, device.max_damping_n_s_per_m);
  }
  if (period_s(device) < 0.0005) {
    plane.damping_n_s_per_m =
        std::min(plane.damping_n_s_per_m, 2.0 / std::max(1.0, device.page_scale));
  }
  plane.damping_n_s_per_m = std::min(plane.damping_n_s_per_m, quiet.damping_n_s_per_m);
  return plane;
}

FrictionOptions friction_for(const Medium& tool, const SurfaceMaterial& surface,
                             const Capabilities& device) noexcept {
  const double budget = stiffness_budget_n_per_m(device);
  const QuietLimits quiet = quiet_limits(device);
  const double stiffness = std::min(
      {tool.bristle_n_per_m, quiet.stiffness_n_per_m, std::max(budget - kOneSpring, 0.5 * budget)});
  const double damping = tool.bristle_n_s_per_m * stiffness / tool.bristle_n_per_m;
  const double coefficient = friction_of(tool, surface);
  const double slides = std::min(1.0, coefficient / kDampedFriction);
  return {.coefficient = coefficient,
          .stiffness_n_per_m = stiffness,
          .damping_n_s_per_m = std::min(damping, quiet.damping_n_s_per_m),
          // The eraser must be told from what draws, on every device.
          .own_friction_n = tool.draws ? finite_positive(device.friction_n) : 0.0,
          .own_coefficient = tool.strength * kPencilOnPaper,
          .viscosity_n_s_per_m = slides * matched_viscosity_n_s_per_m(device)};
}

double matched_viscosity_n_s_per_m(const Capabilities& device) noexcept {
  constexpr double kPerS = 18.0, kSpeedMPerS = 0.1, kQuietShare = 0.7;
  const double matched = kPerS * finite_positive(device.mass_kg);
  const double dry = finite_positive(device.friction_n) / kSpeedMPerS;
  return std::min({std::clamp(2.0 * matched - dry, 0.0, matched),
                   0.5 * finite_positive(device.max_damping_n_s_per_m),
                   kQuietShare * quiet_limits(device).damping_n_s_per_m});
}

double firm_push_n(const Capabilities& device) noexcept {
  constexpr double kMinN = 0.2, kSlides = 0.6;
  const SafetyLimits limits = limits_for(device);
  double held_n = sustained_force_n(limits);
  if (limits.peak_force_n > 0.0) held_n = std::min(held_n, limits.peak_force_n);
  return std::max(kMinN, std::min(held_n / std::sqrt(1.0 + kSlides * kSlides), device.full_push_n));
}

double flattening_push_n(const Capabilities& device) noexcept {
  constexpr double kMaxN = 2.0, kMinN = 0.2, kShareOfContinuous = 1.2;
  if (!(device.continuous_force_n > 0.0)) return kMaxN;
  return std::clamp(kShareOfContinuous * device.continuous_force_n, kMinN, kMaxN);
}

TextureOptions texture_for(const Medium& tool, const SurfaceMaterial& surface,
                           const Capabilities& device, TextureLaw law) noexcept {
  const FrictionOptions friction = friction_for(tool, surface, device);
  return {.law = law,
          .strength = tool.grain,
          .wear = tool.wear,
          .firm_push_n = flattening_push_n(device),
          .friction = friction.coefficient,
          .bristle_n_per_m = friction.stiffness_n_per_m,
          .own_friction_n = friction.own_friction_n,
          .period_s = period_s(device)};
}

SurfaceForce make_surface_force(const SurfaceMaterial& surface, const Medium& tool,
                                const Capabilities& device, const HeightField* grain,
                                TextureLaw law) noexcept {
  return SurfaceForce(Plane(plane_for(surface, device)),
                      Texture(grain, texture_for(tool, surface, device, law)),
                      Friction(friction_for(tool, surface, device)));
}

}  // namespace felt
