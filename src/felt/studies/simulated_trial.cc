#include "felt/studies/simulated_trial.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "felt/base/constants.h"
#include "felt/base/hash.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/towed_plan.h"
#include "felt/replay/replay_drawing.h"
#include "felt/replay/replay_machine.h"
#include "felt/studies/erased_page.h"
#include "felt/studies/measured_trial.h"
#include "felt/studies/trial_setup.h"

namespace felt {
namespace {

constexpr std::int64_t kRestNs = 250'000'000;  // after the pen was lifted
constexpr int kStopMs = 200;                   // to reach the end of the path while towing

/// Returns the rope if the pen tows the nib in a condition.
std::optional<TowOptions> rope_of(const StudyCondition& condition) {
  TowOptions rope;
  bool is_towed = false;
  for (const StudySetting& setting : condition.settings) {
    if (setting.id == "pencil.stabiliser") {
      is_towed = setting.value == std::variant<double, bool, std::string>("towed");
    } else if (setting.id == "pencil.stabiliser_length_mm") {
      rope.rope_mm = std::get<double>(setting.value);
    }
  }
  return is_towed ? std::optional(rope) : std::nullopt;
}

/// Returns the movement of a pen that tows the nib along a plan. The pen stops at the end of the
/// path, because the ink is completed up to the pen when it lifts.
RecordedPath towing_plan(const RecordedPath& nib, const TowOptions& rope) {
  RecordedPath pen = ahead_by_rope(nib, rope);
  double left_mm = 0.0;
  for (std::size_t i = nib.size() - 1; i > 0 && left_mm < rope.rope_mm; --i) {
    left_mm += distance(nib[i].position, nib[i - 1].position);
    pen.pop_back();
  }
  const Point from = pen.back().position, to = nib.back().position;
  const std::int64_t start_ns = *pen.back().time_ns;
  for (int i = 1; i <= kStopMs; ++i) {
    const double t = static_cast<double>(i) / kStopMs;
    pen.push_back(
        {.position = lerp(from, to, t * t * (3.0 - 2.0 * t)), .time_ns = start_ns + i * kMs});
  }
  return pen;
}

double number_option(const Session& session, std::string_view id) {
  return std::get<double>(session.option(id).value_or(OptionValue{0.0}));
}

/// Plans the pressure that draws a line of this width: the person knows how the pen answers.
void press_for(const Session& session, double width_mm, RecordedPath& plan) {
  const double min_mm = number_option(session, "pencil.min_width_mm");
  const double range_mm = number_option(session, "pencil.max_width_mm") - min_mm;
  const double share = range_mm > 0.0 ? (width_mm - min_mm) / range_mm : 0.0;
  const double gamma = number_option(session, "pencil.gamma");
  const double pressure = std::pow(std::clamp(share, 0.0, 1.0), 1.0 / gamma);
  for (RecordedPoint& point : plan) point.pressure = pressure;
}

/// Returns the seed of everything random in an attempt. It does not depend on the condition: a
/// person makes the same movement with the same noise in all conditions, so that they differ only
/// by what the conditions do (common random numbers).
std::uint64_t seed_of(const Study& study, const PlannedTrial& trial, int attempt) {
  Fnv1a parts;
  parts.add_value(study.seed);
  parts.add_value(trial.session);
  for (const int part : {trial.block, static_cast<int>(trial.shape), trial.repetition, attempt}) {
    parts.add_value(part);
  }
  return Random(parts.value()).bits();
}

/// Draws one trial.
class TrialRun {
 public:
  TrialRun(const StudyFiles& files, const PlannedTrial& trial, const Person& person,
           const StylusPreset& device)
      : files_(files), trial_(trial), person_(person), device_(device) {}

  /// Returns all attempts: more than one if a catch rule was broken and the study repeats trials.
  Result<std::vector<SimulatedAttempt>> attempts() {
    const CatchRules& rules = files_.study.catch_rules;
    const int most = rules.action == CatchAction::kRepeat ? 1 + rules.max_repeats : 1;
    std::vector<SimulatedAttempt> attempts;
    for (int i = 1; i <= most; ++i) {
      Result<SimulatedAttempt> drawn = draw(i);
      if (!drawn) return tl::unexpected(drawn.error());
      attempts.push_back(*std::move(drawn));
      if (attempts.back().result.invalid.empty()) break;
    }
    return attempts;
  }

 private:
  Result<SimulatedAttempt> draw(int attempt) {
    const StudyCondition& condition = files_.study.conditions[trial_.condition];
    const StudyShape& shape = files_.study.shapes[trial_.shape];
    const std::uint64_t seed = seed_of(files_.study, trial_, attempt);
    Person person = person_;
    person.seed ^= seed;
    if (!condition.has_vision || shape.task == StudyTask::kFind) person.eye_gain_per_s = 0.0;
    ReplaySettings settings = settings_of(condition);
    settings.person = person;
    FeltRecorder recorder("simulated " + std::string(device_.name),
                          settings.device.capabilities.period_ns);
    ReplayMachine machine(settings, Document(), observer(recorder));
    if (Result<void> begun = begin(machine, settings, recorder); !begun) {
      return tl::unexpected(begun.error());
    }
    const Person drawer = settings.script.contact == ContactBy::kDepthInAir
                              ? in_the_air(person)
                              : on_a_plane(person, machine.expected_friction_n());
    RecordedPath plan = plan_movement(drawer, via(seed), seed, shape.tunnel_mm);
    if (shape.task == StudyTask::kWidth) press_for(machine.session(), shape.width_mm, plan);
    const bool is_erased = shape.task == StudyTask::kErase;
    const auto rope = is_erased ? std::nullopt : rope_of(condition);
    if (rope) plan = towing_plan(plan, *rope);
    if (Result<void> drawn = play(machine, plan); !drawn) return tl::unexpected(drawn.error());
    return finish(attempt, machine, recorder.take());
  }

  /// Returns the points through which the person plans to lead the pen.
  [[nodiscard]] std::vector<Point> via(std::uint64_t seed) const {
    if (files_.study.shapes[trial_.shape].task != StudyTask::kErase) {
      return via_points(files_.paths[trial_.shape]);
    }
    Random random(seed);
    return erasing_path(erased_page_of(files_, trial_), random);
  }

  /// Returns the settings of a condition. With motors that are off, the person draws in the air,
  /// and the depth of the pen decides whether it draws, as with a real device. A device without a
  /// surface has no depth.
  [[nodiscard]] ReplaySettings settings_of(const StudyCondition& condition) const {
    const bool is_off = condition.forces == StudyForces::kAir && device_.capabilities.has_force();
    ReplaySettings settings = replay_settings(device_, person_.grip(), true, {}, {});
    settings.force = !is_off;
    if (is_off && device_.renders_surface()) settings.script.contact = ContactBy::kDepthInAir;
    return settings;
  }

  [[nodiscard]] ReplayMachine::Observer observer(FeltRecorder& recorder) const {
    ReplayMachine::Observer observer;
    observer.event = [&recorder](const Event& event) { recorder.event(event); };
    if (!device_.capabilities.has_force()) return observer;
    observer.tick = [&recorder](const ReplayTick& tick) -> Result<void> {
      recorder.forces(tick.report.sample.time_ns, tick.report.asked, tick.report.sent);
      return {};
    };
    return observer;
  }

  Result<void> begin(ReplayMachine& machine, const ReplaySettings& settings,
                     FeltRecorder& recorder) const {
    for (const Event& event : setup_events(files_, trial_, settings.device.capabilities)) {
      if (std::holds_alternative<UseDevice>(event.what)) {  // the machine has its device
        recorder.event(event);
      } else if (Result<void> added = machine.add(event); !added) {
        return added;
      }
    }
    return {};
  }

  /// Lets the hand land, draw the plan, lift the pen and rest.
  static Result<void> play(ReplayMachine& machine, const RecordedPath& plan) {
    const std::vector<TimedAim> aims = script_hand(std::span(&plan, 1), machine.hand_options());
    machine.begin_stroke();
    std::int64_t time_ns = 0;
    const auto add = [&machine, &time_ns](const TimedAim& aim) {
      const HandEvent hand{
          .target = aim.target_mm, .pressure = aim.pressure, .tilt_deg = aim.tilt_deg};
      return machine.add({time_ns, hand});
    };
    for (const TimedAim& aim : aims) {
      time_ns = aim.time_ns;
      if (Result<void> added = add(aim); !added) return added;
    }
    machine.stroke_drawn({});
    time_ns += kRestNs;
    if (Result<void> rested = add(aims.back()); !rested) return rested;
    return machine.play();
  }

  Result<SimulatedAttempt> finish(int attempt, ReplayMachine& machine, FeltRecording recording) {
    const bool had_fault = machine.take_stats().hard_faults > 0;
    const TrialMetrics metrics = measure_recorded_trial(files_, trial_, trial_samples(recording),
                                                        machine.session().document());
    SimulatedAttempt drawn;
    drawn.metrics = metrics;
    drawn.result.trial = trial_.number;
    drawn.result.attempt = attempt;
    drawn.result.invalid = broken_rule(files_.study.catch_rules, metrics,
                                       metrics.path_length_mm.value_or(0.0), had_fault);
    drawn.drawing = drawing_after(Drawing(), machine.session(), machine.session().document());
    Result<void> added = add_recording(drawn.drawing, std::move(recording));
    if (!added) return tl::unexpected(added.error());
    return drawn;
  }

  const StudyFiles& files_;
  const PlannedTrial& trial_;
  Person person_;
  const StylusPreset& device_;
};

}  // namespace

Result<std::vector<SimulatedAttempt>> simulate_trial(const StudyFiles& files,
                                                     const PlannedTrial& trial,
                                                     const Person& person,
                                                     const StylusPreset& device) {
  return TrialRun(files, trial, person, device).attempts();
}

}  // namespace felt
