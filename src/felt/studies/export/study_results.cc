#include "felt/studies/export/study_results.h"

#include <algorithm>

#include "felt/trial/statistics.h"

namespace felt {
namespace {

/// The first half of the items of UEQ-S is about the pragmatic quality. An answer of 4 is neutral
/// (Schrepp, Hinderks, Thomaschewski 2017, DOI 10.9781/ijimai.2017.09.001).
constexpr std::size_t kPragmaticItems = 4;
constexpr double kNeutralAnswer = 4.0;

}  // namespace

bool StudyResults::is_simulated() const {
  return !trials.empty() && std::all_of(trials.begin(), trials.end(), [](const MeasuredTrial& t) {
    return t.info.person_seed.has_value();
  });
}

std::vector<int> condition_positions(const std::vector<PlannedTrial>& plan) {
  std::vector<int> positions;
  std::vector<std::size_t> seen;  // the conditions of the block so far
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (i > 0 && plan[i].block != plan[i - 1].block) seen.clear();
    auto found = std::find(seen.begin(), seen.end(), plan[i].condition);
    if (found == seen.end()) found = seen.insert(seen.end(), plan[i].condition);
    positions.push_back(plan[i].is_practice ? 0 : static_cast<int>(found - seen.begin()) + 1);
  }
  return positions;
}

QuestionScores scores_of(const QuestionAnswers& answers) {
  QuestionScores scores;
  const std::span<const double> values = answers.values;
  if (values.size() != item_count(answers.form)) return scores;
  if (answers.form == Questionnaire::kNasaTlx) {
    scores.tlx_mean = mean_of(values);
  } else {
    scores.ueq_pragmatic = mean_of(values.first(kPragmaticItems)) - kNeutralAnswer;
    scores.ueq_hedonic = mean_of(values.subspan(kPragmaticItems)) - kNeutralAnswer;
    scores.ueq_overall = mean_of(values) - kNeutralAnswer;
  }
  return scores;
}

}  // namespace felt
