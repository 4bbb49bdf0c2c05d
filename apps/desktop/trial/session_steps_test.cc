#include "desktop/trial/session_steps.h"

#include <gtest/gtest.h>

namespace felt::desktop::session_steps_test {
namespace {

Study study_of(CatchAction action) {
  Study study;
  study.catch_rules.action = action;
  study.catch_rules.max_repeats = 2;
  study.questionnaires = {Questionnaire::kNasaTlx, Questionnaire::kUeqS};
  return study;
}

StudySession two_trials() {
  StudySession session;
  session.plan.resize(2);
  session.plan[0].number = 1;
  session.plan[1].number = 2;
  session.plan[1].asks_questions = true;
  return session;
}

TrialStep trial_step(const Study& study, const StudySession& session) {
  return std::get<TrialStep>(next_step(study, session));
}

TEST(SessionSteps, TrialsThenQuestionsThenTheEnd) {
  const Study study = study_of(CatchAction::kFlag);
  StudySession session = two_trials();
  EXPECT_EQ(trial_step(study, session), (TrialStep{session.plan[0], 1, ""}));
  session.results = {{1, 1, "", ""}};
  EXPECT_EQ(trial_step(study, session), (TrialStep{session.plan[1], 1, ""}));
  session.results.push_back({2, 1, "max_lifts", ""});
  EXPECT_EQ(next_step(study, session), SessionStep(QuestionStep{2, Questionnaire::kNasaTlx}));
  session.answers = {{2, Questionnaire::kNasaTlx, {}}};
  EXPECT_EQ(next_step(study, session), SessionStep(QuestionStep{2, Questionnaire::kUeqS}));
  session.answers.push_back({2, Questionnaire::kUeqS, {}});
  EXPECT_EQ(next_step(study, session), SessionStep(SessionEnd{}));
}

TEST(SessionSteps, AnInvalidTrialIsRepeatedAtMostSoOften) {
  const Study study = study_of(CatchAction::kRepeat);
  StudySession session = two_trials();
  for (int attempt = 1; attempt <= 3; ++attempt) {
    const TrialStep step = trial_step(study, session);
    EXPECT_EQ(step.trial.number, 1);
    EXPECT_EQ(step.attempt, attempt);
    EXPECT_EQ(step.broken_rule, attempt == 1 ? "" : "max_lifts");
    session.results.push_back({1, attempt, "max_lifts", ""});
  }
  EXPECT_EQ(trial_step(study, session).trial.number, 2);
}

TEST(SessionSteps, AnInterruptedTrialIsRepeatedAndIsNotCounted) {
  for (const CatchAction action : {CatchAction::kFlag, CatchAction::kRepeat}) {
    const Study study = study_of(action);
    StudySession session = two_trials();
    for (int attempt = 1; attempt < 9; ++attempt) {
      session.results.push_back({1, attempt, "interrupted", ""});
      EXPECT_EQ(trial_step(study, session), (TrialStep{session.plan[0], attempt + 1, ""}));
    }
    session.results.push_back({1, 9, "", ""});
    EXPECT_EQ(trial_step(study, session).trial.number, 2);
  }
}

}  // namespace
}  // namespace felt::desktop::session_steps_test
