#include "tests/devices/stability/pen_plan.h"

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/tools/pencil/shape_hold.h"
#include "felt/tools/read/read_force.h"

namespace felt {
namespace {

constexpr double kHoverMm = 3.0;
constexpr double kArmedS = 0.8;  // the safety chain has engaged by then
constexpr double kLandedS = 1.2;
constexpr double kMoveS = 1.6;  // every movement along the surface begins here
constexpr double kSlowMmPerS = 20.0;
constexpr double kTapS = 0.333;
constexpr double kTapHeightMm = 2.0;

// Rises from 0 at `from_s` to 1 at `until_s` with minimum jerk.
double smooth(double from_s, double until_s, double t_s) noexcept {
  const double t = std::clamp((t_s - from_s) / (until_s - from_s), 0.0, 1.0);
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

double height_mm(Trial trial, double depth_mm, double t_s) noexcept {
  if (trial != Trial::kTap)
    return kHoverMm - (kHoverMm + depth_mm) * smooth(kArmedS, kLandedS, t_s);
  const double down = smooth(kArmedS - kTapS, kArmedS, t_s);
  const double phase = t_s > kArmedS ? (t_s - kArmedS) / kTapS : 0.0;
  const double part = phase - static_cast<double>(static_cast<int>(phase));
  const double press = smooth(0.0, 0.5, part) - smooth(0.5, 1.0, part);
  const double top = kHoverMm + (kTapHeightMm - kHoverMm) * down;
  return top - (top + depth_mm) * press;
}

// The planned movement along x and the forces against it.
struct Side {
  double way_mm = 0.0;  // distance from kTrialPlace
  double pull_n = 0.0;  // force towards kTrialPlace
  double slides = 0.0;  // -1..1: direction of the movement and share of the friction against it
};

// The force of the groove, or of the ridge, which points away from its path.
double guide_pull_n(Trial trial, double way_mm) noexcept {
  if (trial == Trial::kGuide) return GuideLaw::groove(1.0).well.force_at_n(way_mm);
  const GuideLaw ridge = GuideLaw::error_amplifying(1.0);
  return -ridge.well.force_at_n(std::max(0.0, way_mm - ridge.dead_mm));
}

// The movement beside a guide of a drawing: a rest, then beyond the plateau and back. The pen lands
// on the free side of a ruler. The wells of rays and nodes are crossed.
Side guide_side(Trial trial, const GuideLaw& law, double t_s) noexcept {
  if (trial == Trial::kClick) return {};  // it moves in z only
  const bool is_small = trial == Trial::kRay || trial == Trial::kNode;
  const double rest_mm = is_small ? 0.5 : 1.0;
  const double far_mm = is_small ? 3.0 : trial == Trial::kRing ? 7.0 : 2.9;
  Side side;
  side.way_mm = rest_mm + (far_mm - rest_mm) * (smooth(2.9, 3.5, t_s) - smooth(3.6, 4.2, t_s));
  side.slides = 2.0 * (smooth(2.9, 3.1, t_s) - smooth(3.6, 3.8, t_s));
  double reach_mm = side.way_mm;
  if (trial == Trial::kRuler) {
    side.way_mm -= 2.0 * (1.0 - smooth(kLandedS, kMoveS, t_s));
    reach_mm = std::max(0.0, side.way_mm + GuideLaw::kEdgeMm);
  }
  const double sign = law.pushes_away ? -1.0 : 1.0;
  if (t_s >= kLandedS) side.pull_n = sign * law.well.force_at_n(reach_mm - law.dead_mm);
  return side;
}

// The force of the tool Read at the end of a line: its groove and its notch.
double read_pull_n(double way_mm) noexcept {
  return GuideLaw::groove(kReadGrooveShare).well.force_at_n(way_mm) +
         read_notch(1.0).force_at_n(way_mm);
}

// The movement on a body, whose way is an arc from its top.
Side body_side(Trial trial, double t_s) noexcept {
  Side side;
  if (trial == Trial::kSlide) {
    side.way_mm = kSlowMmPerS * std::max(0.0, t_s - kMoveS);
    side.slides = smooth(kMoveS, kMoveS + 0.4, t_s);
  } else {
    side.way_mm = 8.0 + 22.0 * (smooth(2.9, 3.5, t_s) - smooth(3.6, 4.2, t_s));
    side.slides = 2.0 * (smooth(2.9, 3.1, t_s) - smooth(3.6, 3.8, t_s));
  }
  return side;
}

Side side_of(Trial trial, const GuideLaw& law, double t_s) noexcept {
  Side side;
  switch (trial) {
    case Trial::kFlank:
    case Trial::kSlide:
      return body_side(trial, t_s);
    case Trial::kRest:
    case Trial::kTap:
      break;
    case Trial::kSlow:
      side.way_mm = kSlowMmPerS * std::max(0.0, t_s - kMoveS);
      side.slides = smooth(kMoveS, kMoveS + 0.4, t_s);
      break;
    case Trial::kWell:
      side.way_mm = 10.0 - 9.0 * smooth(kArmedS, kMoveS, t_s) +
                    4.0 * (smooth(2.9, 3.5, t_s) - smooth(3.6, 4.2, t_s));
      side.pull_n = WellShape{}.force_at_n(side.way_mm);
      side.slides =
          2.0 * (smooth(2.9, 3.1, t_s) - smooth(3.6, 3.8, t_s)) - smooth(kLandedS, kMoveS, t_s);
      break;
    case Trial::kEdit:
      side.way_mm = 20.0 * (smooth(kMoveS, 2.2, t_s) - smooth(2.7, 3.3, t_s));
      side.pull_n = kEditLaw.force_n(side.way_mm);
      side.slides = smooth(kMoveS, kMoveS + 0.2, t_s) - 2.0 * smooth(2.7, 2.9, t_s);
      break;
    case Trial::kBundle:
      side.way_mm = 20.0 * (smooth(kMoveS, 2.2, t_s) - smooth(2.7, 3.3, t_s));
      side.slides = smooth(kMoveS, kMoveS + 0.2, t_s) - 2.0 * smooth(2.7, 2.9, t_s);
      break;
    case Trial::kShake:
      side.way_mm =
          20.0 * (smooth(kMoveS, 2.2, t_s) - smooth(2.7, 3.3, t_s)) +
          (smooth(kMoveS, 1.8, t_s) - smooth(3.3, 3.5, t_s)) * std::sin(kTau * kShakeHz * t_s);
      side.slides = smooth(kMoveS, kMoveS + 0.2, t_s) - 2.0 * smooth(2.7, 2.9, t_s);
      break;
    case Trial::kHold:
      side.way_mm = RestWatch::kRestMm +
                    ShapeHold::kLeaveMm * (smooth(2.9, 3.5, t_s) - smooth(3.6, 4.2, t_s));
      if (t_s >= kLandedS) side.pull_n = hold_shape(1.0).force_at_n(side.way_mm);
      side.slides = 2.0 * (smooth(2.9, 3.1, t_s) - smooth(3.6, 3.8, t_s));
      break;
    case Trial::kRead:
      // From afar, as for the well: a notch attracts in the air, and forces engage only where the
      // pen feels none.
      side.way_mm = 10.0 - 9.0 * smooth(kArmedS, kMoveS, t_s) +
                    2.0 * (smooth(2.9, 3.5, t_s) - smooth(3.6, 4.2, t_s));
      if (t_s >= kLandedS) side.pull_n = read_pull_n(side.way_mm);
      break;
    case Trial::kGuide:
    case Trial::kRidge:
      side.way_mm = 1.0 + 2.0 * (smooth(2.9, 3.5, t_s) - smooth(3.6, 4.2, t_s));
      if (t_s >= kLandedS) side.pull_n = guide_pull_n(trial, side.way_mm);
      side.slides = 2.0 * (smooth(2.9, 3.1, t_s) - smooth(3.6, 3.8, t_s));
      break;
    default:
      return guide_side(trial, law, t_s);
  }
  return side;
}

// Returns true if the force at the start of the trial is that of a position, so that its energy
// counts only from then on.
bool is_in_a_well(Trial trial) noexcept {
  return trial == Trial::kWell || trial == Trial::kGuide || trial == Trial::kRidge ||
         trial == Trial::kHold || trial == Trial::kRead || is_guide_of_drawing(trial);
}

}  // namespace

TrialTimes times_of(Trial trial, bool lets_go) noexcept {
  if (lets_go) {
    const double release_s = trial == Trial::kTap ? 0.9 : 2.0;
    return {.measure_from_s = 3.5,
            .measure_until_s = 4.5,
            .energy_from_s = is_in_a_well(trial) ? kMoveS : 0.0,
            .release_s = release_s,
            .end_s = 4.5};
  }
  TrialTimes times;
  switch (trial) {
    case Trial::kRest:
      times = {.measure_from_s = 1.8, .measure_until_s = 2.8};
      break;
    case Trial::kSlow:
    case Trial::kSlide:
      times = {.measure_from_s = 2.2, .measure_until_s = 3.4};
      break;
    case Trial::kTap:
      times = {.measure_from_s = 3.5, .measure_until_s = 3.5};
      break;
    case Trial::kWell:
    case Trial::kGuide:
    case Trial::kRidge:
    case Trial::kHold:
    case Trial::kRead:
    default:
      times = {
          .measure_from_s = 1.9, .measure_until_s = 2.9, .energy_from_s = kMoveS, .end_s = 4.6};
      break;
    case Trial::kEdit:
    case Trial::kBundle:
    case Trial::kShake:
      times = {.measure_from_s = 1.4, .measure_until_s = 3.6};
      break;
  }
  times.end_s = std::max(times.end_s, times.measure_until_s);
  return times;
}

PlannedPen planned_pen(Trial trial, const PlanGround& ground, double t_s) noexcept {
  const double depth_mm = 1e3 * ground.press_n / ground.plane_n_per_m;
  double z = height_mm(trial, depth_mm, t_s);
  if (trial == Trial::kClick) z -= kClickWayMm * (smooth(2.9, 3.5, t_s) - smooth(3.6, 4.2, t_s));
  const double push_n = 1e-3 * ground.plane_n_per_m * std::max(0.0, -z);
  const Side side = side_of(trial, ground.guide, t_s);
  PlannedPen planned;
  if (is_on_body(trial)) {
    const double angle = side.way_mm / kBodyRadiusMm;
    const Vec3 out{std::sin(angle), 0.0, std::cos(angle)}, along{out.z, 0.0, -out.x};
    planned.pen = Vec3{kTrialPlace.x, kTrialPlace.y, -kBodyRadiusMm} + (kBodyRadiusMm + z) * out;
    const Vec3 load = push_n * out - side.slides * ground.friction * push_n * along;
    planned.load = {load.x, 0.0, load.z};
    return planned;
  }
  planned.pen = {kTrialPlace.x + side.way_mm, kTrialPlace.y, z};
  planned.load = {-side.pull_n - side.slides * ground.friction * push_n, 0.0, push_n};
  return planned;
}

}  // namespace felt
