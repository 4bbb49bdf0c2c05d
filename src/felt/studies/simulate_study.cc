#include "felt/studies/simulate_study.h"

#include <algorithm>
#include <deque>
#include <future>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

#include "felt/base/random.h"
#include "felt/studies/simulated_trial.h"
#include "felt/studies/trial_setup.h"

namespace felt {
namespace {

using SimulatedAttempts = Result<std::vector<SimulatedAttempt>>;

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
    const Person person = in_model(person_of(*session.info.person_seed), options_.model);
    const std::vector<PlannedTrial> plan = open_trials(session);
    for (std::size_t i = plan.size(); i < session.plan.size(); ++i) {
      if (!finished_trial_()) return false;
    }
    std::deque<std::future<SimulatedAttempts>> running;
    for (std::size_t next = 0; next < plan.size() || !running.empty();) {
      if (next < plan.size() && running.size() < ahead) {
        const PlannedTrial& trial = plan[next++];
        running.push_back(std::async(std::launch::async, [this, &trial, &person] {
          return simulate_trial(folder_.files(), trial, person, options_.device);
        }));
        continue;
      }
      SimulatedAttempts drawn = running.front().get();
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
                  "model, device or version of Feltline. Use another folder.");
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
                         .person_seed = person_seed,
                         .person_model = std::string(person_model_name(options.model))});
      if (!session) return tl::unexpected(session.error());
      const Result<bool> goes_on = run.run(*std::move(session));
      if (!goes_on) return tl::unexpected(goes_on.error());
      if (!*goes_on) return {};
    }
  }
  return {};
}

}  // namespace felt
