// Checks of levels 5 and 6: how a small force moves a pen that a person holds.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/validate/checks.h"

namespace felt {
namespace {

constexpr int kStillPairs = 4;
constexpr int kCirclePairs = 6;
constexpr double kStillSettleS = 0.25;
constexpr double kStillMeanS = 0.15;
constexpr double kCircleSettleS = 0.35;
constexpr double kCircleS = 1.0;  // one whole circle; its mean is the centre
constexpr double kMinMovedMm = 0.04;
constexpr double kSurely = 3.0;  // in standard errors
/// Displacement across the axis, as a fraction of the displacement along it.
constexpr double kMaxAside = 0.6;

constexpr int kSteps = 8;
constexpr double kStepS = 0.3;
constexpr double kMinStepMm = 0.1;
constexpr double kBegun = 0.15;  // fraction of the final displacement at which the motion has begun
constexpr double kMaxDeadS = 0.050;
/// Deviation in the last third, as a fraction of the final displacement.
constexpr double kMaxRinging = 0.3;

constexpr const char* kHoldStillWhilePushed =
    "Hold the pen in the air as for writing, loosely, and keep it still. It will push slightly in "
    "different directions.";
constexpr const char* kDrawCircles =
    "Nothing moved while you held still; friction may be the cause. Now draw circles in the air, "
    "as small as a pea, about one per second, until the next message.";

std::array<int, 3> shuffled_axes(std::mt19937_64& random) {
  std::array<int, 3> axes{0, 1, 2};
  for (std::size_t i = 2; i > 0; --i) std::swap(axes[i], axes[random() % (i + 1)]);
  return axes;
}

/// Pushes repeatedly in the positive and the negative direction of one axis. Returns the
/// displacement between the two.
PushResponse push_along(Trial& trial, int axis, bool in_circles) {
  std::array<Series, 3> apart;
  Vec3 sum{};
  const int pairs = in_circles ? kCirclePairs : kStillPairs;
  const double mean_s = in_circles ? kCircleS : kStillMeanS;
  const auto place_under = [&](double newtons) {
    trial.push(along(axis, newtons));
    trial.pass((in_circles ? kCircleSettleS : kStillSettleS) + mean_s);
    return trial.mean_place(mean_s);
  };
  for (int i = 0; i < pairs && trial.trouble().empty(); ++i) {
    // The order of the two directions alternates, so that a slow drift of the hand cancels out.
    const double first = i % 2 == 0 ? kTestForceN : -kTestForceN;
    const Vec3 there = place_under(first);
    const Vec3 back = place_under(-first);
    const Vec3 moved = i % 2 == 0 ? there - back : back - there;
    sum += moved;
    for (int k = 0; k < 3; ++k) apart[static_cast<std::size_t>(k)].add(component(moved, k));
    trial.forget();
  }
  trial.push({});
  PushResponse response;
  response.moved = (1.0 / pairs) * sum;
  for (const Series& series : apart) {
    response.uncertainty = std::max(response.uncertainty, series.error());
  }
  return response;
}

bool is_felt(const CheckContext& context, const PushResponse& push) {
  const double step = context.subject.device()->capabilities().position_step_mm;
  return norm(push.moved) > std::max({kMinMovedMm, step, kSurely * push.uncertainty});
}

std::string moved_words(const CheckContext& context) {
  std::string words;
  for (int axis = 0; axis < context.subject.device()->capabilities().actuated_axes && axis < 3;
       ++axis) {
    const PushResponse& push = (*context.pushes)[static_cast<std::size_t>(axis)];
    words += (words.empty() ? "" : ", ") + std::string(axis_name(axis)) + " " +
             figure(component(push.moved, axis), 2) + " +- " + figure(push.uncertainty, 2) + " mm";
  }
  return "+0.3 N against -0.3 N: " + words;
}

/// Returns the number of axes that the device can push along; a planar device has two.
int pushed_axes(const CheckContext& context) {
  return std::clamp(context.subject.device()->capabilities().actuated_axes, 0, 3);
}

/// Fills context.pushes. Returns nullopt on success, otherwise the outcome of the check.
std::optional<CheckOutcome> push_all(CheckContext& context, bool in_circles) {
  Result<std::unique_ptr<Trial>> trial = context.begin();
  if (!trial) return failed({}, trial.error().message);
  (*trial)->pass(1.0);  // the person needs a moment to get ready
  (*trial)->arm();
  std::array<PushResponse, 3> pushes{};
  for (const int axis : shuffled_axes(context.random)) {
    if (axis >= pushed_axes(context)) continue;
    pushes[static_cast<std::size_t>(axis)] = push_along(**trial, axis, in_circles);
  }
  if (!(*trial)->trouble().empty()) return broken(**trial);
  const SafetyReport safety = (*trial)->servo().latest().safety;
  if (safety.state != SafetyState::kActive) {
    return not_possible("the safety chain switched the force off (" +
                        std::to_string(safety.soft_faults + safety.hard_faults) +
                        " faults): the loop was late, or the pen moved too fast");
  }
  context.pushes = pushes;
  context.pushed_in_circles = in_circles;
  return std::nullopt;
}

int count_felt(const CheckContext& context) {
  int count = 0;
  for (int axis = 0; axis < pushed_axes(context); ++axis) {
    if (is_felt(context, (*context.pushes)[static_cast<std::size_t>(axis)])) ++count;
  }
  return count;
}

}  // namespace

CheckOutcome check_force_felt(CheckContext& context) {
  if (context.subject.device() == nullptr) return not_possible("it could not be opened");
  if (const std::string why = context.refusal(); !why.empty()) return not_possible(why);
  if (!context.person.does(PersonTask::kHoldStill, kHoldStillWhilePushed)) {
    return not_possible("it was not held");
  }
  if (auto outcome = push_all(context, false)) return *outcome;
  if (count_felt(context) < pushed_axes(context) &&
      context.person.does(PersonTask::kDrawCircles, kDrawCircles)) {
    if (auto outcome = push_all(context, true)) return *outcome;
  }
  const std::string measured =
      moved_words(context) + (context.pushed_in_circles ? ", in circles" : "");
  const int felt = count_felt(context);
  if (felt == pushed_axes(context)) return passed(measured);
  const std::string words =
      felt == 0 ? "the device accepts forces but does not produce them: check its power supply, "
                  "and any switch, button or grip that enables forces"
                : "no force is felt along one of the axes: a motor or its amplifier is off";
  if (felt == 0) context.pushes.reset();
  return failed(measured, words);
}

CheckOutcome check_force_sign(CheckContext& context) {
  if (!context.pushes) return not_possible("no force was felt");
  std::string wrong;
  for (int axis = 0; axis < pushed_axes(context); ++axis) {
    const PushResponse& push = (*context.pushes)[static_cast<std::size_t>(axis)];
    if (!is_felt(context, push)) continue;
    const double way = component(push.moved, axis);
    Vec3 aside = push.moved;
    (axis == 0 ? aside.x : axis == 1 ? aside.y : aside.z) = 0.0;
    const std::string name = axis_name(axis);
    if (way < 0.0) {
      wrong += (wrong.empty() ? "" : "; ") + name + " pushes the opposite way";
    } else if (norm(aside) > kMaxAside * way) {
      wrong += (wrong.empty() ? "" : "; ") + name + " pushes sideways";
    }
  }
  if (wrong.empty()) {
    return passed(pushed_axes(context) < 3
                      ? "x, y of the surface: right, down"
                      : "x, y, z of the surface: right, down, towards the hand");
  }
  return failed(moved_words(context),
                wrong +
                    ". Do not draw with it: set the drawing plane again (it may be upside down or "
                    "mirrored), and report this if that does not help");
}

CheckOutcome check_step(CheckContext& context) {
  const std::optional<int> axis = context.best_axis();
  if (!axis) return not_possible("no force was felt");
  if (!context.person.does(PersonTask::kHoldStill, kHoldStillWhilePushed)) {
    return not_possible("it was not held");
  }
  Result<std::unique_ptr<Trial>> trial = context.begin();
  if (!trial) return failed({}, trial.error().message);
  (*trial)->pass(1.0);
  (*trial)->arm();
  const double period_s = 1e-9 * static_cast<double>((*trial)->servo().options().period_ns);
  std::vector<Series> curve(static_cast<std::size_t>(kStepS / period_s));
  for (int i = 0; i < kSteps && (*trial)->trouble().empty(); ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    const double from = component((*trial)->mean_place(0.05), *axis);
    (*trial)->forget();
    (*trial)->step(along(*axis, sign * kTestForceN));
    (*trial)->pass(kStepS + 0.05);
    // Starts at the tick after the force was sent to the device.
    std::size_t at = 0;
    bool reported = false;
    for (const ProbeTick& tick : (*trial)->ticks()) {
      if (reported && at < curve.size()) {
        curve[at++].add(sign * (component(tick.sample.position, *axis) - from));
      }
      reported = reported || norm(tick.force) > 0.5 * kTestForceN;
    }
    (*trial)->push({});
    (*trial)->pass(0.4);
  }
  if (!(*trial)->trouble().empty()) return broken(**trial);
  Series end;
  double begins_s = -1.0, farthest = 0.0;
  for (std::size_t i = curve.size() * 2 / 3; i < curve.size(); ++i) end.add(curve[i].mean());
  const double way = end.mean();
  // An earlier check tests the sign. This check tests only how soon and how calmly the pen moves.
  const double facing = way < 0.0 ? -1.0 : 1.0;
  if (std::abs(way) < kMinStepMm) {
    return not_possible("friction holds the pen: a step of 0.3 N moves it by " + figure(way, 2) +
                        " mm");
  }
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double moved = facing * curve[i].mean();
    if (begins_s < 0.0 && moved > kBegun * std::abs(way)) {
      begins_s = period_s * static_cast<double>(i + 1);
    }
    farthest = std::max(farthest, moved);
  }
  const double ringing = end.deviation() / std::abs(way);
  const std::string measured = figure(std::abs(way), 2) + " mm, starting after " +
                               figure(1e3 * begins_s, 0) + " ms, " +
                               figure(100.0 * std::max(0.0, farthest / std::abs(way) - 1.0), 0) +
                               " % overshoot, " + figure(100.0 * ringing, 0) + " % ringing";
  if (begins_s < 0.0 || begins_s > kMaxDeadS) {
    return failed(measured, "the force arrives late: walls would hum");
  }
  if (ringing > kMaxRinging) return failed(measured, "it keeps oscillating after a step");
  return passed(measured);
}

}  // namespace felt
