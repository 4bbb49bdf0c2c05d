// Checks of levels 1 to 4: the values that a device reports, without any force.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "felt/validate/checks.h"

namespace felt {
namespace {

constexpr double kMaxLatePeriods = 1.0;  // 99 % of the ticks must be less late than this
constexpr double kMaxMissed = 0.01;
constexpr double kRateWithin = 0.05;
constexpr double kRestS = 2.0;
/// Maximum RMS deviation from the mean: a few encoder steps (kNoiseSteps), and less than a person
/// could see (kMaxNoiseMm).
constexpr double kMaxNoiseMm = 0.1;
constexpr double kNoiseSteps = 2.0;
/// Permitted distance beyond the edge, as a fraction of the size of the workspace.
constexpr double kWithinReach = 0.5;
/// Added to this distance, because the z of a planar device comes from touch alone.
constexpr double kMinRoomMm = 1.0;
constexpr double kFarMm = 5000.0;

bool is_cancelled(const CheckContext& context) {
  return context.options.is_cancelled && context.options.is_cancelled();
}

std::string milliseconds(double ns) {
  return figure(1e-6 * ns, 2) + " ms";
}

/// Returns true if the workspace is a box with at least as many extended sides as sensed axes, at
/// most 3. The workspace of a planar device is flat.
bool is_a_workspace(const Capabilities& can) {
  const Vec3 size = can.workspace_max - can.workspace_min;
  int sides = 0;
  for (const double length : {size.x, size.y, size.z}) {
    if (!(length >= 0.0 && length < kFarMm)) return false;
    if (length > 1.0) ++sides;
  }
  return sides >= std::min(can.sensed_axes, 3);
}

/// Returns which of the device's capabilities is implausible; empty if none.
std::string nonsense_in(const Capabilities& can) {
  if (can.sensed_axes < 1 || can.sensed_axes > 6) return "the number of axes that it senses";
  if (can.actuated_axes < 0 || can.actuated_axes > can.sensed_axes + 1) {
    return "the number of axes that it pushes";
  }
  for (const double force : {can.max_force_n, can.continuous_force_n, can.advised_force_n}) {
    if (!(force >= 0.0 && force < 1000.0)) return "its forces";
  }
  if (can.continuous_force_n > can.max_force_n) return "continuous force above peak force";
  if (!is_a_workspace(can)) return "the size of its workspace";
  if (can.period_ns < kShortestPeriodNs || can.period_ns > kLongestPeriodNs) {
    return "the period of its loop";
  }
  if (can.delay_ticks < 0 || can.delay_ticks > kMaxDelayTicks) return "its delay";
  if (!(can.position_step_mm >= 0.0 && can.position_step_mm < 10.0)) return "its resolution";
  if (!is_sound(limits_for(can))) return "the force limits that follow from its figures";
  return {};
}

/// Runs the device in the loop for this time, while nobody touches it.
Result<std::unique_ptr<Trial>> at_rest(CheckContext& context, double seconds) {
  Result<std::unique_ptr<Trial>> trial = context.begin();
  if (trial) (*trial)->pass(seconds);
  return trial;
}

}  // namespace

CheckOutcome check_openings(CheckContext& context) {
  std::int64_t slowest_ns = 0;
  for (int i = 0; i < context.options.openings; ++i) {
    if (is_cancelled(context)) return {Verdict::kNotRun, {}, "the test was interrupted"};
    const std::int64_t start_ns = context.loop.now_ns();
    const Result<void> opened = context.subject.open();
    const std::int64_t took_ns = context.loop.now_ns() - start_ns;
    if (!opened) {
      return failed(std::to_string(i) + " times, then it failed", opened.error().message);
    }
    slowest_ns = std::max(slowest_ns, took_ns);
    context.subject.close();
  }
  return passed(std::to_string(context.options.openings) + " times, the slowest took " +
                milliseconds(static_cast<double>(slowest_ns)));
}

CheckOutcome check_identity(CheckContext& context) {
  const DeviceDescriptor before = context.subject.descriptor();
  if (Result<void> opened = context.subject.open(); !opened) {
    return failed({}, opened.error().message);
  }
  const DeviceDescriptor& now = context.subject.descriptor();
  std::string measured = now.label;
  if (!now.serial.empty()) measured += ", serial " + now.serial;
  if (!now.version.empty()) measured += ", version " + now.version;
  if (now.id.empty() || now.label.empty()) return failed(measured, "it has no id or no name");
  if (now.id != before.id) {
    return failed(measured, "its id was " + before.id + " before it was opened, and is " + now.id);
  }
  if (!before.serial.empty() && now.serial != before.serial) {
    return failed(measured, "its serial number was " + before.serial + " before it was opened");
  }
  return passed(measured);
}

CheckOutcome check_capabilities(CheckContext& context) {
  if (context.subject.device() == nullptr) return not_possible("it could not be opened");
  const Capabilities& can = context.subject.device()->capabilities();
  const Vec3 size = can.workspace_max - can.workspace_min;
  const std::string measured = figure(can.max_force_n, 1) + " N peak, " +
                               figure(can.continuous_force_n, 2) + " N held, " + figure(size.x, 0) +
                               " x " + figure(size.y, 0) + " x " + figure(size.z, 0) + " mm, " +
                               figure(1e9 / static_cast<double>(can.period_ns), 0) + " Hz";
  const std::string nonsense = nonsense_in(can);
  if (!nonsense.empty()) return failed(measured, "implausible: " + nonsense);
  return passed(measured);
}

CheckOutcome check_rate(CheckContext& context) {
  Result<std::unique_ptr<Trial>> trial = at_rest(context, context.options.rate_s);
  if (!trial) return failed({}, trial.error().message);
  if (!(*trial)->trouble().empty()) return broken(**trial);
  const LoopStats stats = context.loop.stats();
  const double nominal_hz = 1e9 / static_cast<double>((*trial)->servo().options().period_ns);
  const double missed = static_cast<double>(stats.missed()) /
                        std::max(1.0, static_cast<double>(stats.ticks() + stats.missed()));
  const std::int64_t p99_ns = stats.lateness().percentile_ns(0.99);
  const std::string measured = figure(stats.rate_hz(), 0) + " Hz of " + figure(nominal_hz, 0) +
                               ", late by " + milliseconds(static_cast<double>(p99_ns)) +
                               " (99 %), " +
                               milliseconds(static_cast<double>(stats.lateness().max_ns())) +
                               " at most, missed " + figure(100.0 * missed, 2) + " %";
  const char* const words =
      "the loop is late: the device is slow to answer, or this computer does not permit real time "
      "('feltline doctor' shows the missing permission)";
  if (std::abs(stats.rate_hz() / nominal_hz - 1.0) > kRateWithin) return failed(measured, words);
  if (missed > kMaxMissed) return failed(measured, words);
  if (static_cast<double>(p99_ns) > kMaxLatePeriods * 1e9 / nominal_hz) {
    return failed(measured, words);
  }
  return passed(measured);
}

CheckOutcome check_sample_times(CheckContext& context) {
  Result<std::unique_ptr<Trial>> trial = at_rest(context, 1.0);
  if (!trial) return failed({}, trial.error().message);
  if (!(*trial)->trouble().empty()) return broken(**trial);
  std::int64_t backwards = 0, last_ns = INT64_MIN, farthest_ns = 0;
  for (const ProbeTick& tick : (*trial)->ticks()) {
    if (tick.sample.time_ns <= last_ns) ++backwards;
    last_ns = tick.sample.time_ns;
    farthest_ns = std::max<std::int64_t>(farthest_ns, std::abs(tick.sample.time_ns - tick.now_ns));
  }
  const std::string measured = std::to_string((*trial)->ticks().size()) + " samples, " +
                               milliseconds(static_cast<double>(farthest_ns)) +
                               " from the loop's clock at most";
  if (backwards > 0) {
    return failed(measured,
                  std::to_string(backwards) + " samples are not later than the previous one");
  }
  if (farthest_ns > 100'000'000)
    return failed(measured, "sample times do not match the loop's clock");
  return passed(measured);
}

CheckOutcome check_places(CheckContext& context) {
  Result<std::unique_ptr<Trial>> trial = at_rest(context, 0.5);
  if (!trial) return failed({}, trial.error().message);
  if (!(*trial)->trouble().empty()) return broken(**trial);
  const Capabilities& can = context.subject.device()->capabilities();
  const Vec3 smallest{kMinRoomMm, kMinRoomMm, kMinRoomMm};
  const Vec3 room = smallest + kWithinReach * (can.workspace_max - can.workspace_min);
  for (const ProbeTick& tick : (*trial)->ticks()) {
    const Vec3& p = tick.sample.position;
    const Vec3& v = tick.sample.velocity;
    if (!std::isfinite(p.x + p.y + p.z + v.x + v.y + v.z)) {
      return failed({}, "it reports positions or velocities that are not numbers");
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double low = component(can.workspace_min - room, axis);
      const double high = component(can.workspace_max + room, axis);
      if (component(p, axis) >= low && component(p, axis) <= high) continue;
      return failed(figure(component(p, axis), 0) + " mm along " + axis_name(axis),
                    "the pen is far outside the range of the device: set the drawing plane again, "
                    "or find home again");
    }
  }
  const Vec3 place = (*trial)->mean_place(0.5);
  return passed("at " + figure(place.x, 1) + ", " + figure(place.y, 1) + ", " + figure(place.z, 1) +
                " mm on the surface");
}

CheckOutcome check_noise(CheckContext& context) {
  if (!context.person.does(
          PersonTask::kLeaveAlone,
          "Put the pen down or on its rest, and take your hands off the table for some seconds.")) {
    return not_possible("it was not put down");
  }
  Result<std::unique_ptr<Trial>> trial = at_rest(context, 1.0);
  if (!trial) return failed({}, trial.error().message);
  (*trial)->forget();  // discards the samples from before, when the pen still oscillated
  (*trial)->pass(kRestS);
  if (!(*trial)->trouble().empty()) return broken(**trial);
  std::array<Series, 3> places;
  for (const ProbeTick& tick : (*trial)->ticks()) {
    for (int axis = 0; axis < 3; ++axis) {
      places[static_cast<std::size_t>(axis)].add(component(tick.sample.position, axis));
    }
  }
  double worst = 0.0;
  for (const Series& place : places) worst = std::max(worst, place.deviation());
  const double step = context.subject.device()->capabilities().position_step_mm;
  const double largest = std::max(kMaxNoiseMm, kNoiseSteps * step);
  const std::string measured = figure(places[0].deviation(), 3) + ", " +
                               figure(places[1].deviation(), 3) + ", " +
                               figure(places[2].deviation(), 3) + " mm RMS along x, y, z";
  context.is_noisy = worst > largest;
  if (context.is_noisy) {
    return failed(measured, "more than " + figure(largest, 2) +
                                " mm although nothing moves it: check for a loose cable, a magnet "
                                "nearby or a worn joint, and do not lean on the table");
  }
  return passed(measured);
}

}  // namespace felt
