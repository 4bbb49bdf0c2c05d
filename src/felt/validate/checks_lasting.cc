// Checks of levels 9 and 10: unplugging, and a soak test.
#include <algorithm>
#include <cmath>

#include "felt/haptics/bricks/plane.h"
#include "felt/validate/checks.h"

namespace felt {
namespace {

constexpr double kPatienceS = 30.0;
constexpr double kLookS = 0.5;
constexpr double kSlice = 0.1;
constexpr double kStaysGoneS = 0.5;

constexpr double kSoftPlaneNPerM = 200.0;
constexpr double kOfMaximum = 0.5;
constexpr double kMaxEnergyMj = 1.0;

constexpr const char* kUnplug =
    "Let go of the pen. Then unplug the device's cable from the computer; you have half a minute.";
constexpr const char* kReplug = "Plug it in again; you have half a minute.";
constexpr const char* kDraw = "Draw anything, pressing and lifting, until this check ends.";

/// Waits until the device is connected again; returns false after kPatienceS or if cancelled.
bool wait_for_device(CheckContext& context) {
  for (double waited = 0.0; waited < kPatienceS; waited += kLookS) {
    if (context.options.is_cancelled && context.options.is_cancelled()) return false;
    context.loop.pass(static_cast<std::int64_t>(1e9 * kLookS), [] {});
    if (context.subject.is_connected()) return true;
  }
  return false;
}

/// after_s is the time at which reading began to fail, or negative if reading did not fail.
/// came_back is true if a later read succeeded.
struct Gone {
  double after_s = -1.0;
  DeviceFault fault = DeviceFault::kOther;
  bool came_back = false;
};

Gone watch_it_go(Trial& trial) {
  Gone gone;
  trial.keep(false);
  trial.expect_faults();
  double now_s = 0.0;
  trial.on_tick = [&](const ProbeTick& tick) {
    if (tick.read_fault && gone.after_s < 0.0) {
      gone.after_s = now_s;
      gone.fault = *tick.read_fault;
    } else if (gone.after_s >= 0.0 && !tick.read_fault) {
      gone.came_back = true;
    }
  };
  for (; now_s < kPatienceS && gone.after_s < 0.0 && trial.trouble().empty(); now_s += kSlice) {
    trial.pass(kSlice);
  }
  if (gone.after_s >= 0.0) trial.pass(kStaysGoneS);
  trial.on_tick = nullptr;
  return gone;
}

}  // namespace

CheckOutcome check_unplugging(CheckContext& context) {
  if (!context.person.does(PersonTask::kUnplug, kUnplug)) {
    return not_possible("its cable was not unplugged");
  }
  Gone gone;
  {
    Result<std::unique_ptr<Trial>> trial = context.begin();
    if (!trial) return failed({}, trial.error().message);
    gone = watch_it_go(**trial);
    if (!(*trial)->trouble().empty()) return broken(**trial);
  }
  if (gone.after_s < 0.0) {
    return not_possible("it was not unplugged, or this was not noticed within half a minute");
  }
  const std::string noticed = "noticed (" + std::string(describe(gone.fault)) + ")";
  context.subject.close();
  const bool back = context.person.does(PersonTask::kReplug, kReplug) && wait_for_device(context);
  if (gone.fault != DeviceFault::kDisconnected || gone.came_back) {
    return failed(noticed,
                  "an unplugged device must report that it is not connected, and nothing else, "
                  "until it is opened again");
  }
  if (!back) return not_possible("it was not plugged in again", noticed);
  if (Result<void> opened = context.subject.open(); !opened) {
    return failed(noticed + ", but it could not be opened again", opened.error().message);
  }
  Result<std::unique_ptr<Trial>> trial = context.begin();
  if (!trial) return failed(noticed, trial.error().message);
  (*trial)->pass(1.0);
  if (!(*trial)->trouble().empty()) {
    return failed(noticed + ", opened again", (*trial)->trouble());
  }
  return passed(noticed + ", and drawn with again");
}

CheckOutcome check_soak(CheckContext& context) {
  const bool has_device = context.subject.device() != nullptr || context.subject.open();
  if (!has_device) return not_possible("it could not be opened");
  const Capabilities can = context.subject.device()->capabilities();
  const bool with_force = can.has_force() && context.refusal().empty();
  if (!context.person.does(PersonTask::kDraw, kDraw)) return not_possible("nothing was drawn");
  Result<std::unique_ptr<Trial>> begun = context.begin();
  if (!begun) return failed({}, begun.error().message);
  Trial& trial = **begun;
  trial.keep(false);
  double energy_mj = 0.0, largest_n = 0.0;
  std::uint64_t ticks = 0;
  SafetyReport last;
  trial.on_turn = [&](const TickReport& report) {
    energy_mj = std::max(energy_mj, report.safety.energy_mj);
    last = report.safety;
  };
  trial.on_tick = [&](const ProbeTick& tick) {
    largest_n = std::max(largest_n, norm(tick.force));
    ++ticks;
  };
  if (with_force) {
    PlaneOptions plane;
    plane.stiffness_n_per_m = std::min(kSoftPlaneNPerM, kOfMaximum * can.max_stiffness_n_per_m);
    plane.damping_n_s_per_m = std::min(1.0, kOfMaximum * can.max_damping_n_s_per_m);
    trial.publish(ForceModel(Plane(plane)));
    trial.servo().arm();
  }
  trial.pass(context.options.soak_s);
  if (!trial.trouble().empty()) return broken(trial);
  const std::string measured =
      figure(context.options.soak_s, 0) + " s, " + std::to_string(ticks) + " ticks, " +
      (with_force ? figure(largest_n, 2) + " N at most, " + figure(energy_mj, 2) + " mJ generated"
                  : std::string("no force"));
  if (last.hard_faults > 0 || last.soft_faults > 0) {
    return failed(measured, std::to_string(last.soft_faults) + " soft and " +
                                std::to_string(last.hard_faults) +
                                " hard faults: late ticks, jumps, or a device that failed");
  }
  if (context.is_noisy && energy_mj > kMaxEnergyMj) {
    return not_possible("its positions are too noisy to measure energy", measured);
  }
  if (energy_mj > kMaxEnergyMj) {
    return failed(measured, "the wall returns more energy than it absorbed: it would hum");
  }
  if (with_force && largest_n <= kEpsilonN) {
    return not_possible("the surface was not pressed", measured);
  }
  return passed(measured);
}

}  // namespace felt
