#include "felt/haptics/bricks/push_clicks.h"

#include <algorithm>

namespace felt {

std::size_t PushClicks::passed_at(double depth_mm, std::size_t passed) const noexcept {
  passed = std::min(passed, count_);
  while (passed < count_ && depth_mm > depths_mm_[passed] + kHysteresisMm) ++passed;
  while (passed > 0 && depth_mm < depths_mm_[passed - 1] - kHysteresisMm) --passed;
  return passed;
}

Force PushClicks::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  ClickState& click = memory.click;
  const double depth = depth_mm(sample);
  if (count_ == 0 || !(depth > 0.0)) {
    click = {};
    return {};
  }
  click.down_s = std::min(click.down_s + memory.dt_s, 10.0);
  click.age_s = std::min(click.age_s + memory.dt_s, 10.0);
  const std::size_t passed = passed_at(depth, click.passed);
  if (passed != click.passed) {
    if (click.down_s > kLandingS && click.age_s >= kPauseS) {
      click.direction = passed > click.passed ? 1.0 : -1.0;  // 1: into the surface
      click.age_s = 0.0;
    }
    click.passed = passed;
  }
  Force force;
  if (click.direction != 0.0 && click.age_s < kPulseS) {
    const double x = click.age_s / kPulseS;
    force.z = click.direction * kForceN * 4.0 * x * (1.0 - x);
  }
  memory.terms.add("click", force);
  return force;
}

}  // namespace felt
