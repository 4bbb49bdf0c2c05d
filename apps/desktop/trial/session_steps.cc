#include "desktop/trial/session_steps.h"

#include <algorithm>

namespace felt::desktop {
namespace {

bool is_answered(const StudySession& session, const QuestionStep& step) {
  return std::any_of(session.answers.begin(), session.answers.end(), [&](const QuestionAnswers& a) {
    return a.after_trial == step.after_trial && a.form == step.form;
  });
}

}  // namespace

SessionStep next_step(const Study& study, const StudySession& session) {
  for (const PlannedTrial& trial : session.plan) {
    TrialAttempts attempts = attempts_of(session, trial.number);
    if (!attempts.is_done(study.catch_rules)) {
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
