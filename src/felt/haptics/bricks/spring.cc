#include "felt/haptics/bricks/spring.h"

#include <algorithm>
#include <cmath>

#include "felt/haptics/pen_sample.h"

namespace felt {
namespace {

constexpr double kOldestS = 0.25;  // maximum assumed age of a published curve
constexpr double kBriefS = 1e-7;   // below it, (1 - exp(-x))/x counts as 1

}  // namespace

Force pull_back(const ForceLaw& law, Vec displacement_mm, double damping_n_s_per_m,
                Vec velocity_mm_per_s, double share) noexcept {
  const double distance = norm(displacement_mm);
  // phi(d)/d is at most Kcap. The test avoids 0/0 and division by subnormal distances.
  const double per_mm = distance > 1e-12 ? law.softened(share).force_n(distance) / distance : 0.0;
  const Vec pull =
      -(per_mm * displacement_mm + 1e-3 * share * damping_n_s_per_m * velocity_mm_per_s);
  return {pull.x, pull.y, 0.0};
}

Force EditSpring::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const Force force =
      pull_back(options_.law, on_page(sample.position) - origin_, options_.damping_n_s_per_m,
                known_velocity(sample), memory.scale.lateral);
  memory.terms.add("edit", force);
  return force;
}

Slopes EditSpring::slopes() const noexcept {
  return {.lateral_n_per_m = options_.law.max_slope_n_per_m()};
}

Force SweepSpring::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const double age_s =
      std::clamp(1e-9 * (static_cast<double>(sample.time_ns) - static_cast<double>(curve_.time_ns)),
                 0.0, kOldestS);
  // Solves V' = v - V/tau with constant v, starting from the published V. `kept` is the fraction of
  // the published V that remains. `counts` is the fraction of the displacement since the
  // publication that is added.
  const double kept = std::exp(-age_s / time_constant_s_);
  const double counts = age_s > kBriefS ? time_constant_s_ / age_s * (1.0 - kept) : 1.0;
  const Vec before = curve_.pen - curve_.curve;
  const Vec moved = on_page(sample.position) - curve_.pen;
  Vec lag = kept * before + counts * moved, damped{};
  if (!curve_.is_end) {
    // The nearest point moves along the curve with the pen, so only motion across the curve counts.
    const auto across = [&](Vec v) { return dot(v, curve_.normal) * curve_.normal; };
    lag = kept * before + counts * across(moved);
    damped = across(known_velocity(sample));
  }
  const Force force =
      pull_back(options_.law, lag, options_.damping_n_s_per_m, damped, memory.scale.lateral);
  memory.terms.add("edit", force);
  return force;
}

Slopes SweepSpring::slopes() const noexcept {
  return {.lateral_n_per_m = options_.law.max_slope_n_per_m()};
}

Force PushSpring::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const ForceLaw law = options_.law.softened(memory.scale.lateral);
  const double per_mm = 1e-3 * law.max_slope_n_per_m();
  const double into = -line_.gap_mm - dot(on_page(sample.position) - line_.pen, line_.normal);
  // The line yields at phi of its displacement. Below that force, and when the nib moves back, it
  // is a spring.
  const double yields_n = law.force_n(line_.displacement_mm + std::max(into, 0.0));
  const double spring_n =
      std::clamp(law.force_n(line_.displacement_mm) + per_mm * into, 0.0, yields_n);
  const double damper_n = -1e-3 * memory.scale.lateral * options_.damping_n_s_per_m *
                          dot(known_velocity(sample), line_.normal);
  const double size = line_.share * (spring_n + std::clamp(damper_n, -spring_n, spring_n));
  const Force force{size * line_.normal.x, size * line_.normal.y, 0.0};
  memory.terms.add("edit", force);
  return force;
}

Slopes PushSpring::slopes() const noexcept {
  return {.lateral_n_per_m = options_.law.max_slope_n_per_m()};
}

}  // namespace felt
