#pragma once

#include <string>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/studies/study_folder.h"
#include "felt/trial/trial_metrics.h"

namespace felt {

/// A finished trial with its metrics.
struct MeasuredTrial {
  SessionInfo info = {};
  PlannedTrial plan = {};
  TrialResult result = {};
  TrialMetrics metrics = {};
  int position = 0;              ///< of the condition in the block, from 1; 0 for practice trials
  std::string recording = {};    ///< the path of the recording in the export
  std::vector<Point> path = {};  ///< with which the ink was compared
  bool is_closed = false;        ///< the path is closed
  std::vector<Point> ink = {};   ///< some of the samples in contact, for pictures
  std::vector<std::size_t> touches = {};  ///< where touches begin in `ink`
};

/// The answers to one questionnaire, and the trial after which it was shown.
struct GivenAnswers {
  SessionInfo info = {};
  PlannedTrial plan = {};
  QuestionAnswers answers = {};
};

/// Everything that tables and reports of a study show.
struct StudyResults {
  StudyFiles files = {};
  std::vector<MeasuredTrial> trials = {};
  std::vector<GivenAnswers> answers = {};
  std::vector<std::string> unfinished = {};  ///< as in the result of export_study()

  [[nodiscard]] const StudyCondition& condition_of(const PlannedTrial& plan) const {
    return files.study.conditions[plan.condition];
  }
  [[nodiscard]] const StudyShape& shape_of(const PlannedTrial& plan) const {
    return files.study.shapes[plan.shape];
  }
  /// Returns true if all participants are simulated, and there is at least one.
  [[nodiscard]] bool is_simulated() const;
};

/// Returns the position of the condition of each trial among the conditions of its block: 1 for the
/// first condition; 0 for practice trials.
std::vector<int> condition_positions(const std::vector<PlannedTrial>& plan);

/// Scores of a questionnaire. Each is nullopt if the answers are those of another form.
struct QuestionScores {
  std::optional<double> tlx_mean;                                 ///< raw TLX, 0 to 100
  std::optional<double> ueq_pragmatic, ueq_hedonic, ueq_overall;  ///< -3 to 3
};
QuestionScores scores_of(const QuestionAnswers& answers);

}  // namespace felt
