// Checks of levels 7 and 8: the safety chain and watchdogs, with this device.
#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/validate/checks.h"

namespace felt {
namespace {

constexpr double kAskedN = 3.0;  // ten times the permitted force
/// After a late tick, the force may rise for at most two periods (TickTime::credited_s).
constexpr double kCreditedPeriods = 2.0;

constexpr double kStallS = 0.100;
constexpr int kStalls = 4;
/// Long enough that three stalls never occur within 10 s, because that would be a hard fault.
constexpr double kBetweenStallsS = 6.0;
constexpr double kHeldS = 0.4;
constexpr int kTicksAfter = 5;
constexpr int kTicksOff = 2;  // in which the first reading after a stall must fail
constexpr double kMinPushedMm = 0.15;
constexpr double kControlReturns = 0.4;
constexpr double kLimp = 0.5;

constexpr const char* kHoldStill =
    "Hold the pen in the air as for writing, loosely, and keep it still.";

/// The largest force that was sent, and the largest rise of the force between two ticks.
struct Sent {
  double max_n = 0.0;
  double rise_n = 0.0;
};

Sent sent_in(const std::vector<ProbeTick>& ticks) {
  Sent sent;
  Force last{};
  for (const ProbeTick& tick : ticks) {
    sent.max_n = std::max(sent.max_n, norm(tick.force));
    if (norm(tick.force) > norm(last)) sent.rise_n = std::max(sent.rise_n, norm(tick.force - last));
    last = tick.force;
  }
  return sent;
}

std::optional<CheckOutcome> hold(CheckContext& context) {
  if (context.subject.device() == nullptr) return not_possible("it could not be opened");
  if (const std::string why = context.refusal(); !why.empty()) return not_possible(why);
  if (!context.person.does(PersonTask::kHoldStill, kHoldStill)) {
    return not_possible("it was not held");
  }
  return std::nullopt;
}

/// Returns the displacement of the pen along `axis` from `rest`, its position without force.
double away(const Trial& trial, int axis, double rest, double seconds) {
  return component(trial.mean_place(seconds), axis) - rest;
}

/// Returns the mean position along `axis` over the first kTicksAfter ticks after the stall.
std::optional<double> after_stall(const Trial& trial, int axis) {
  Series places;
  for (const ProbeTick& tick : trial.ticks()) {
    if (places.count == 0.0 && !tick.after_stall) continue;
    if (places.count < kTicksAfter) places.add(component(tick.sample.position, axis));
  }
  return places.count > 0.0 ? std::optional(places.mean()) : std::nullopt;
}

/// Returns the largest force sent in the 50 ticks after a stall, except the first two, because
/// their forces may have been computed before the stall was detected.
double sent_after_stall(const Trial& trial) {
  double largest = 0.0;
  int since = -1;
  for (const ProbeTick& tick : trial.ticks()) {
    if (tick.after_stall) since = 0;
    if (since >= 2 && since < 50) largest = std::max(largest, norm(tick.force));
    if (since >= 0) ++since;
  }
  return largest;
}

/// Returns true if the device was off when the loop went on after a stall: reading fails in the
/// first ticks, always for the same reason, and stays so. A device that fails later worked again
/// after the stall, so its failure does not show that it was switched off meanwhile.
bool is_off_after_stall(const Trial& trial) {
  int since = -1;
  bool is_off = false;
  for (const ProbeTick& tick : trial.ticks()) {
    if (tick.after_stall) since = 0;
    if (since < 0) continue;
    const bool fails = tick.read_fault == DeviceFault::kNotCalibrated;
    if (!fails && (is_off || since >= kTicksOff)) return false;
    is_off = is_off || fails;
    ++since;
  }
  return is_off;
}

/// The outcome if the device was switched off during a stall, by itself or by the guard process of
/// its driver, and must be prepared again.
CheckOutcome switched_off(const Series& pushed) {
  const double way = std::abs(pushed.mean());
  const std::string measured =
      "pushed " + figure(way, 2) + " mm; without commands for 100 ms it was switched off";
  if (way < kMinPushedMm) return not_possible("no force was felt", measured);
  return passed(measured);
}

}  // namespace

CheckOutcome check_limits(CheckContext& context) {
  if (auto outcome = hold(context)) return *outcome;
  Result<std::unique_ptr<Trial>> trial = context.begin();
  if (!trial) return failed({}, trial.error().message);
  (*trial)->pass(1.0);
  (*trial)->arm();
  (*trial)->forget();
  (*trial)->step({0.0, 0.0, kAskedN});
  (*trial)->pass(0.3);
  const Sent sent = sent_in((*trial)->ticks());
  (*trial)->push({});
  (*trial)->forget();
  (*trial)->step({0.0, 0.0, std::numeric_limits<double>::quiet_NaN()});
  (*trial)->pass(0.1);
  (*trial)->forget();
  (*trial)->step({0.0, 0.0, 0.1});
  (*trial)->pass(0.2);
  if (!(*trial)->trouble().empty()) return broken(**trial);
  const double after_nonsense = sent_in((*trial)->ticks()).max_n;
  const ServoOptions& options = (*trial)->servo().options();
  const double period_ms = 1e-6 * static_cast<double>(options.period_ns);
  const std::string measured = "requested 3 N: " + figure(sent.max_n, 2) + " N sent, rising by " +
                               figure(sent.rise_n / period_ms, 2) +
                               " N/ms; requested NaN: " + figure(after_nonsense, 2) + " N";
  const double max_rise = kCreditedPeriods * period_ms * options.limits.rise_n_per_ms;
  if (sent.max_n > kTestForceN + kEpsilonN || sent.rise_n > max_rise + kEpsilonN ||
      after_nonsense > kEpsilonN) {
    return failed(measured, "a force limit was exceeded: do not draw with it, and report this");
  }
  if (sent.max_n <= kEpsilonN) {
    return not_possible("the safety chain let no force through: the loop was late", measured);
  }
  return passed(measured);
}

CheckOutcome check_engaging(CheckContext& context) {
  if (auto outcome = hold(context)) return *outcome;
  Result<std::unique_ptr<Trial>> trial = context.begin();
  if (!trial) return failed({}, trial.error().message);
  // The model already presses before forces are enabled, so no force may be sent until it has
  // stopped.
  (*trial)->pass(1.0);
  (*trial)->step({0.0, 0.0, kAskedN});
  (*trial)->pass(0.1);
  (*trial)->servo().arm();
  (*trial)->pass(0.5);
  const double kick = sent_in((*trial)->ticks()).max_n;
  (*trial)->step({});
  (*trial)->pass(0.05);
  (*trial)->forget();
  (*trial)->step({0.0, 0.0, kTestForceN});
  (*trial)->pass(0.4);
  if (!(*trial)->trouble().empty()) return broken(**trial);
  const Sent sent = sent_in((*trial)->ticks());
  const ServoOptions& options = (*trial)->servo().options();
  const double period_ms = 1e-6 * static_cast<double>(options.period_ns);
  const std::string measured = figure(kick, 2) + " N at the start while 3 N was requested, then " +
                               figure(sent.rise_n / period_ms, 3) + " N/ms at most";
  const double max_rise = kCreditedPeriods * period_ms * options.limits.engage_rise_n_per_ms;
  if (kick > kEpsilonN || sent.rise_n > max_rise + kEpsilonN) {
    return failed(measured, "forces start with a jerk: do not draw with it, and report this");
  }
  return passed(measured);
}

CheckOutcome check_watchdog(CheckContext& context) {
  const std::optional<int> axis = context.best_axis();
  if (!axis) return not_possible("no force was felt");
  if (auto outcome = hold(context)) return *outcome;
  Result<std::unique_ptr<Trial>> begun = context.begin();
  if (!begun) return failed({}, begun.error().message);
  Trial& trial = **begun;
  trial.pass(1.0);
  trial.arm();
  Series pushed, returns, limp;
  double sent_n = 0.0;
  for (int i = 0; i < 2 * kStalls && trial.trouble().empty(); ++i) {
    const bool stalls = i % 2 == 1;
    const double sign = i % 4 < 2 ? 1.0 : -1.0;
    const double rest = component(trial.mean_place(0.1), *axis);
    trial.push(along(*axis, sign * kTestForceN));
    trial.pass(kHeldS);
    const double there = sign * away(trial, *axis, rest, 0.05);
    pushed.add(there);
    trial.forget();
    if (stalls && trial.trouble().empty()) {
      trial.stall(kStallS);
      trial.pass(0.1);
      sent_n = std::max(sent_n, sent_after_stall(trial));
      if (is_off_after_stall(trial) && sent_n <= kEpsilonN) return switched_off(pushed);
      if (const auto place = after_stall(trial, *axis)) limp.add(there - sign * (*place - rest));
    } else {
      trial.step({});
      trial.pass(kStallS);
      returns.add(there - sign * away(trial, *axis, rest, 0.005));
    }
    trial.push({});
    trial.pass(stalls ? kBetweenStallsS : 0.5);
  }
  if (!trial.trouble().empty()) return broken(trial);
  const double way = std::abs(pushed.mean());
  const std::string measured = "pushed " + figure(way, 2) + " mm; released it returns " +
                               figure(returns.mean(), 2) + " mm, without commands for 100 ms " +
                               figure(limp.mean(), 2) + " mm";
  if (sent_n > kEpsilonN) {
    return failed(measured, "force was sent immediately after the loop had stalled for 100 ms");
  }
  const double facing = pushed.mean() < 0.0 ? -1.0 : 1.0;
  if (way < kMinPushedMm || facing * returns.mean() < kControlReturns * way) {
    return not_possible("friction holds the pen after a force of 0.3 N ends", measured);
  }
  if (facing * limp.mean() < kLimp * facing * returns.mean()) {
    return failed(measured,
                  "it keeps pushing while the program sends nothing: if the program hangs or "
                  "crashes, the last force stays on. Keep its power switch within reach");
  }
  return passed(measured);
}

}  // namespace felt
