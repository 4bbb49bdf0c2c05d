#include "felt/studies/simulate_study.h"

#include <algorithm>
#include <deque>
#include <future>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

#include "felt/base/constants.h"
#include "felt/base/hash.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/towed_plan.h"
#include "felt/replay/replay_drawing.h"
#include "felt/replay/replay_machine.h"
#include "felt/studies/measured_trial.h"
#include "felt/studies/trial_setup.h"

namespace felt {
namespace {

constexpr std::int64_t kRestNs = 250'000'000;  // after the pen was lifted
constexpr int kStopMs = 200;                   // to reach the end of the path while towing
constexpr double kCornerCosine = 0.87;         // of 30 degrees

/// A trial of one attempt, ready to be saved.
struct SimulatedAttempt {
  TrialResult result;
  Drawing drawing;
};
using SimulatedTrial = Result<std::vector<SimulatedAttempt>>;

/// Returns the path with each corner given twice, as plan_movement() expects it. A closed path ends
/// where it began.
std::vector<Point> via_points(const StudyPath& path) {
  std::vector<Point> points = path.points;
  if (path.ends == TrialPathEnds::kClosed && points.front() != points.back()) {
    points.push_back(points.front());
  }
  std::vector<Point> via;
  for (std::size_t i = 0; i < points.size(); ++i) {
    via.push_back(points[i]);
    if (i == 0 || i + 1 == points.size()) continue;
    const Vec in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    if (dot(in, out) < kCornerCosine * norm(in) * norm(out)) via.push_back(points[i]);
  }
  return via;
}

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
  SimulatedTrial attempts() {
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
    ReplaySettings settings = replay_settings(device_, person.grip(), condition.has_forces, {}, {});
    settings.person = person;
    FeltRecorder recorder("simulated " + std::string(device_.name),
                          settings.device.capabilities.period_ns);
    ReplayMachine machine(settings, Document(), observer(recorder));
    if (Result<void> begun = begin(machine, settings, recorder); !begun) {
      return tl::unexpected(begun.error());
    }
    const std::vector<Point> via = via_points(files_.paths[trial_.shape]);
    RecordedPath plan = plan_movement(person, via, seed, shape.tunnel_mm);
    if (const auto rope = rope_of(condition)) plan = towing_plan(plan, *rope);
    if (Result<void> drawn = play(machine, plan); !drawn) return tl::unexpected(drawn.error());
    return finish(attempt, machine, recorder.take());
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
    const TrialMetrics metrics = measure_recorded_trial(files_, trial_, trial_samples(recording));
    SimulatedAttempt drawn;
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

/// Draws the trials of one session on all cores, and saves them in their order.
class SessionRun {
 public:
  SessionRun(StudyFolder& folder, const SimulateOptions& options,
             std::function<bool()> finished_trial)
      : folder_(folder), options_(options), finished_trial_(std::move(finished_trial)) {}

  /// Draws the trials that the session does not have yet. Returns false if the simulation shall
  /// end.
  Result<bool> run(StudySession session) {
    const std::size_t ahead = std::max(1U, std::thread::hardware_concurrency()) + 1;
    const Person person = person_of(*session.info.person_seed);
    const std::vector<PlannedTrial> plan = open_trials(session);
    for (std::size_t i = plan.size(); i < session.plan.size(); ++i) {
      if (!finished_trial_()) return false;
    }
    std::deque<std::future<SimulatedTrial>> running;
    for (std::size_t next = 0; next < plan.size() || !running.empty();) {
      if (next < plan.size() && running.size() < ahead) {
        const PlannedTrial& trial = plan[next++];
        running.push_back(std::async(std::launch::async, [this, &trial, &person] {
          return TrialRun(folder_.files(), trial, person, options_.device).attempts();
        }));
        continue;
      }
      SimulatedTrial drawn = running.front().get();
      running.pop_front();
      if (!drawn) return tl::unexpected(drawn.error());
      for (SimulatedAttempt& attempt : *drawn) {
        if (attempt.result.attempt <= attempts_of(session, attempt.result.trial).last) continue;
        Result<void> saved = folder_.add_trial(session, std::move(attempt.result), attempt.drawing);
        if (!saved) return tl::unexpected(saved.error());
      }
      if (!finished_trial_()) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] std::vector<PlannedTrial> open_trials(const StudySession& session) const {
    const CatchRules& rules = folder_.files().study.catch_rules;
    std::vector<PlannedTrial> open;
    std::copy_if(session.plan.begin(), session.plan.end(), std::back_inserter(open),
                 [&](const PlannedTrial& trial) {
                   return !attempts_of(session, trial.number).is_done(rules);
                 });
    return open;
  }

  StudyFolder& folder_;
  const SimulateOptions& options_;
  std::function<bool()> finished_trial_;
};

/// Begins a session, or continues the same one.
Result<StudySession> begin(StudyFolder& folder, const SessionInfo& info) {
  Result<StudySession> session = folder.begin_session(info);
  if (!session || session->info == info) return session;
  return fail(ErrorCode::kInvalidArgument,
              folder.path() + ": participant " + std::to_string(info.participant) +
                  " is someone else there: a real person, or one simulated with another seed, "
                  "device or version of Feltline. Use another folder.");
}

}  // namespace

Result<void> simulate_study(StudyFolder& folder, const SimulateOptions& options,
                            const std::function<bool(double)>& progress) {
  const Study& study = folder.files().study;
  if (options.people < 1 || options.people > static_cast<std::size_t>(kMaxParticipants)) {
    return fail(ErrorCode::kInvalidArgument, "a study has 1 to 9999 simulated people");
  }
  const std::string name = folder.path() + "/" + folder.files().sources.front().first;
  Result<void> possible =
      check_conditions(folder.files(), Materials::built_in(), options.device.capabilities, name);
  if (!possible) return possible;
  std::size_t done = 0, all = 0;
  for (const SessionKind kind : study.sessions) all += options.people * trial_count(study, kind);
  SessionRun run(folder, options, [&] {
    ++done;
    return !progress || progress(static_cast<double>(done) / static_cast<double>(all));
  });
  Random seeds(options.seed);  // as in population()
  for (std::size_t i = 0; i < options.people; ++i) {
    const std::uint64_t person_seed = seeds.bits();
    for (const SessionKind kind : study.sessions) {
      Result<StudySession> session =
          begin(folder, {.participant = static_cast<int>(i) + 1,
                         .session = kind,
                         .device = "simulated " + std::string(options.device.name),
                         .program = options.program,
                         .person_seed = person_seed});
      if (!session) return tl::unexpected(session.error());
      const Result<bool> goes_on = run.run(*std::move(session));
      if (!goes_on) return tl::unexpected(goes_on.error());
      if (!*goes_on) return {};
    }
  }
  return {};
}

}  // namespace felt
