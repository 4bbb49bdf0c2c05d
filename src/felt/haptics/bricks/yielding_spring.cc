#include "felt/haptics/bricks/yielding_spring.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

constexpr double kNewGestureS = 0.1;  // a pause of this length begins a new gesture
constexpr double kShortStep = 1e-6;   // below it, (1 - exp(-x))/x counts as 1

}  // namespace

Vec yielding_lag(Point grab, double yield_s, const PenSample& sample,
                 ForceMemory& memory) noexcept {
  YieldState& state = memory.yield;
  const Point pen = on_page(sample.position);
  const double step_s =
      1e-9 * (static_cast<double>(sample.time_ns) - static_cast<double>(state.time_ns));
  if (!state.is_set || state.grab != grab || std::abs(step_s) > kNewGestureS) {
    state = {.grab = grab, .pen = pen, .lag = {}, .time_ns = sample.time_ns, .is_set = true};
  } else if (step_s > 0.0) {
    const double x = step_s / yield_s, kept = std::exp(-x);
    const double counts = x > kShortStep ? (1.0 - kept) / x : 1.0;
    state.lag = kept * state.lag + counts * (pen - state.pen);
    state.pen = pen;
    state.time_ns = sample.time_ns;
  }
  return state.lag;
}

Vec yielding_pull(const ForceLaw& law, double level_n, Vec lag) noexcept {
  const double soft_mm = 1e3 * law.max_n / std::max(law.cap_n_per_m, 1e-3);
  return -level_n / std::max(soft_mm, norm(lag)) * lag;
}

Force YieldingSpring::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const ForceLaw law = options_.law.softened(memory.scale.lateral);
  const Vec lag = yielding_lag(grab_, yield_s_, sample, memory);
  const double level_n = law.gain * law.level_n(distance(on_page(sample.position), grab_));
  const Vec pull = yielding_pull(law, level_n, lag) - 1e-3 * memory.scale.lateral *
                                                          options_.damping_n_s_per_m *
                                                          known_velocity(sample);
  const Force force{pull.x, pull.y, 0.0};
  memory.terms.add("edit", force);
  return force;
}

Slopes YieldingSpring::slopes() const noexcept {
  // d(l q)/dV + d(l q)/dL <= l'(V) + l(V) Kcap/max_n <= Kcap for the laws of force_law.h.
  return {.lateral_n_per_m = options_.law.gain * options_.law.cap_n_per_m};
}

}  // namespace felt
