#include "desktop/trial/session_steps.h"

#include <algorithm>

namespace felt::desktop {
namespace {

/// The attempts at one trial.
struct Attempts {
  int last = 0;     // the number of the last attempt
  int invalid = 0;  // that broke a catch rule
  bool has_valid = false;
  std::string broken_rule;  // by the last attempt that was not interrupted
};

Attempts attempts_of(const StudySession& session, int trial) {
  Attempts all;
  for (const TrialResult& result : session.results) {
    if (result.trial != trial) continue;
    all.last = std::max(all.last, result.attempt);
    if (result.invalid == kInterrupted) continue;
    all.has_valid = all.has_valid || result.invalid.empty();
    if (!result.invalid.empty()) ++all.invalid;
    all.broken_rule = result.invalid;
  }
  return all;
}

bool is_done(const Attempts& attempts, const CatchRules& rules) {
  if (attempts.has_valid) return true;
  return attempts.invalid > (rules.action == CatchAction::kRepeat ? rules.max_repeats : 0);
}

bool is_answered(const StudySession& session, const QuestionStep& step) {
  return std::any_of(session.answers.begin(), session.answers.end(), [&](const QuestionAnswers& a) {
    return a.after_trial == step.after_trial && a.form == step.form;
  });
}

}  // namespace

SessionStep next_step(const Study& study, const StudySession& session) {
  for (const PlannedTrial& trial : session.plan) {
    Attempts attempts = attempts_of(session, trial.number);
    if (!is_done(attempts, study.catch_rules)) {
      return TrialStep{trial, attempts.last + 1, std::move(attempts.broken_rule)};
    }
    if (!trial.asks_questions) continue;
    for (const Questionnaire form : study.questionnaires) {
      const QuestionStep step{trial.number, form};
      if (!is_answered(session, step)) return step;
    }
  }
  return SessionEnd{};
}

}  // namespace felt::desktop
