#include "felt/driver/position_filter.h"

#include <cmath>

#include "felt/base/constants.h"

namespace felt {

PositionFilter::PositionFilter(double bandwidth_hz, double jump_mm) noexcept
    : rad_per_s_(kTau * bandwidth_hz), jump_mm_(jump_mm) {}

void PositionFilter::update(const Vec3& measured, double step_s) noexcept {
  constexpr double kForgetS = 0.02;
  const Vec3 expected = position_ + step_s * velocity_;
  const Vec3 error = measured - expected;
  const bool follows =
      has_position_ && step_s >= 0.0 && step_s < kForgetS && norm(error) < jump_mm_;
  has_position_ = true;
  if (!follows) {
    position_ = measured;
    velocity_ = {};
    return;
  }
  if (step_s <= 0.0) return;
  const double keep = std::exp(-rad_per_s_ * step_s);
  position_ = expected + (1.0 - keep * keep) * error;
  velocity_ += ((1.0 - keep) * (1.0 - keep) / step_s) * error;
}

}  // namespace felt
