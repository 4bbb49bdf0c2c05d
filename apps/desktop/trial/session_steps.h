#pragma once

#include <string>
#include <variant>

#include "felt/studies/study_folder.h"

namespace felt::desktop {

/// The participant draws a trial, for the first time or again.
struct TrialStep {
  PlannedTrial trial;
  int attempt = 1;
  /// The catch rule that the last attempt broke, or "": then the trial is new for the participant,
  /// or it was interrupted.
  std::string broken_rule = {};
  friend bool operator==(const TrialStep&, const TrialStep&) = default;
};

/// The participant answers a questionnaire.
struct QuestionStep {
  int after_trial = 1;
  Questionnaire form = Questionnaire::kNasaTlx;
  friend bool operator==(const QuestionStep&, const QuestionStep&) = default;
};

/// Nothing is left to do.
struct SessionEnd {
  friend bool operator==(const SessionEnd&, const SessionEnd&) = default;
};

using SessionStep = std::variant<TrialStep, QuestionStep, SessionEnd>;

/// Returns what comes next in a session. Depends only on the results and answers that are saved, so
/// that an interrupted session continues where it ended. An interrupted trial is repeated; it is
/// not one of the repeats that CatchRules::max_repeats limits.
SessionStep next_step(const Study& study, const StudySession& session);

}  // namespace felt::desktop
