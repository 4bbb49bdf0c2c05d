#include "felt/devices/simulated/towed_plan.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"

namespace felt {
namespace {

constexpr double kRopePlanStepS = 0.001;      // of plan_movement()
constexpr double kTautenS = 0.3;              // time in which the pen pulls the rope taut
constexpr std::ptrdiff_t kTangentReach = 10;  // steps to each side

// Smooth from 0 to 1, at rest at both ends (minimum jerk).
double smooth_start(double t) {
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

// Appends the movement from the start of the path to `offset` from it.
void pull_taut(Point start, Vec offset, RecordedPath& pen) {
  const int steps = static_cast<int>(std::lround(kTautenS / kRopePlanStepS));
  for (int k = 0; k < steps; ++k) {
    pen.push_back(
        {.position = start + smooth_start(double(k) / steps) * offset, .time_ns = k * kMs});
  }
}

}  // namespace

RecordedPath ahead_by_rope(const RecordedPath& nib, const TowOptions& rope) {
  RecordedPath pen;
  const auto last = static_cast<std::ptrdiff_t>(nib.size()) - 1;
  const auto at = [&](std::ptrdiff_t i) {
    return nib[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))].position;
  };
  Vec along;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    const Vec step = at(i + kTangentReach) - at(i - kTangentReach);
    const double speed = norm(step) / (2.0 * static_cast<double>(kTangentReach) * kRopePlanStepS);
    if (norm(step) > 0.0) along = normalized(step);
    const Vec lead = (rope.rope_mm + rope.time_constant_s * speed) * along;
    if (i == 0) pull_taut(at(0), lead, pen);
    RecordedPoint point = nib[static_cast<std::size_t>(i)];
    point.position = point.position + lead;
    point.time_ns = static_cast<std::int64_t>(pen.size()) * kMs;
    pen.push_back(point);
  }
  return pen;
}

}  // namespace felt
