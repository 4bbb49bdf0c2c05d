#include "tests/devices/safety/fuzz_body.h"

#include <cmath>

#include "felt/geometry/testing/ball.h"
#include "felt/geometry/triangle_tree.h"

namespace felt::safety {
namespace {

constexpr double kSmallMm = 18.0, kLargeMm = 24.0;
constexpr double kFlatter = 0.97;  // of the radius: the facets are inside the ball
// The constants of SolidSurface, repeated on purpose.
constexpr double kFarthestMm = 4.0;
constexpr long double kLongestGapNs = 20e6L;

const TriangleTree& ball_of(bool is_large) {
  const auto tree = [](double r) {
    return TriangleTree(felt::testing::ball({}, {r, r, r}, 40, 20));
  };
  static const TriangleTree small = tree(kSmallMm), large = tree(kLargeMm);
  return is_large ? large : small;
}

// The hand, straight above, does not see the point.
bool is_surely_covered(const Vec3& p, bool is_large) {
  const double r = kFlatter * (is_large ? kLargeMm : kSmallMm);
  const double high = r * r - p.x * p.x - p.y * p.y;
  return high > 0.0 && p.z < std::sqrt(high);
}

}  // namespace

FuzzBody::FuzzBody(Random& random, const Vec3& start_mm)
    : start_mm_(start_mm - Vec3{0.0, 0.0, kSmallMm + 1.0}) {
  options_.plane = {.stiffness_n_per_m = random.between(100.0, 1500.0),
                    .damping_n_s_per_m = random.between(0.0, 5.0)};
  options_.friction = {.coefficient = random.between(0.0, 1.2),
                       .stiffness_n_per_m = random.between(100.0, 1500.0),
                       .damping_n_s_per_m = random.between(0.0, 5.0)};
  options_.max_force_n = random.between(0.5, 5.0);
}

void FuzzBody::exchange(const Vec3& pen) {
  is_large_ = !is_large_;
  ++options_.number;
  if (is_large_ && is_surely_covered(pen, true)) may_touch_ = false;
}

void FuzzBody::follow(const PenSample& sample) {
  const long double gap_ns =
      static_cast<long double>(sample.time_ns) - static_cast<long double>(last_ns_);
  const bool goes_on = has_last_ && gap_ns >= 0.0L && gap_ns <= kLongestGapNs &&
                       norm(sample.position - last_mm_) <= kFarthestMm + 1e-9;
  if (!goes_on) may_touch_ = false;
  has_last_ = true;
  last_mm_ = sample.position;
  last_ns_ = sample.time_ns;
}

Force FuzzBody::asked(PenSample sample, const StiffnessScale& scale, double dt_s, Random& random) {
  sample.position -= start_mm_;
  follow(sample);
  if (random.between(0.0, 1.0) < 0.003) exchange(sample.position);
  if (!is_surely_covered(sample.position, is_large_)) may_touch_ = true;

  const SolidSurface surface(ball_of(is_large_), options_);
  const auto force_of = [&](ForceMemory& memory) {
    memory.begin_tick(dt_s);
    memory.scale = scale;
    return surface(sample, memory);
  };
  const Force force = force_of(memory_);
  const double other = random.between(-10.0, 10.0);
  sample.velocity = other * sample.velocity + Vec3{0.0, 30.0 * other, -100.0};
  if (!broken_) broken_ = check(force, force_of(other_memory_));
  return force;
}

const char* FuzzBody::check(const Force& force, const Force& with_other_velocity) const {
  if (!std::isfinite(norm(force))) return "the force of a body is finite";
  const double mu = options_.friction.coefficient;
  if (norm(force) > options_.max_force_n * std::sqrt(1.0 + mu * mu) + 1e-9) {
    return "the force of a body is under the force of the device";
  }
  const Vec3& out = memory_.solid.proxy.normal();
  if (force.x * out.x + force.y * out.y + force.z * out.z < -1e-9) {
    return "a body does not pull the pen in";
  }
  if (!may_touch_ && force != Force{}) return "a body that appears around the pen does not push";
  if (force != with_other_velocity) return "a body does not rely on the device's velocity";
  return nullptr;
}

}  // namespace felt::safety
