#include "felt/studies/export/hypothesis_results.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/base/check.h"
#include "felt/trial/study_hypothesis.h"
#include "felt/trial/trial_columns.h"

namespace felt {
namespace {

TrialMetric metric_named(std::string_view name) {
  const auto columns = trial_metric_columns();
  const auto at = std::find_if(columns.begin(), columns.end(),
                               [name](const TrialColumn& c) { return c.name == name; });
  FELT_CHECK(at != columns.end());
  return at->value;
}

HypothesisResult tested(const StudyResults& results, const StudyHypothesis& hypothesis) {
  const Study& study = results.files.study;
  const LogRatios ratios = log_ratios(
      results, hypothesis_session(study, hypothesis), condition_index(study, hypothesis.condition),
      condition_index(study, hypothesis.against), metric_named(hypothesis.measure));
  std::vector<double> logs;
  for (const auto& [person, log] : ratios.logs) logs.push_back(log);
  HypothesisResult result{hypothesis, ratios.left_out, test_ratios(logs, hypothesis.margin)};
  if (!result.tests) return result;
  switch (hypothesis.kind) {
    case HypothesisKind::kLess:
      result.p = result.tests->p_different;
      break;
    case HypothesisKind::kNotWorse:
      result.p = result.tests->p_not_worse;
      break;
    case HypothesisKind::kSame:
      result.p = result.tests->p_same();
      break;
  }
  return result;
}

/// The values of a shape in each of two conditions, by participant and shape.
using PairedValues = std::map<int, std::map<std::size_t, std::array<std::vector<double>, 2>>>;

}  // namespace

LogRatios log_ratios(const StudyResults& results, SessionKind session, std::size_t condition,
                     std::size_t against, TrialMetric metric, TrialChoice choice) {
  PairedValues values;  // by person and shape
  for (const MeasuredTrial& trial : results.trials) {
    const TrialMetrics::Value& value = trial.metrics.*metric;
    const bool is_one = trial.plan.condition == condition;
    if (trial.plan.is_practice || trial.plan.session != session ||
        !(is_one || trial.plan.condition == against)) {
      continue;
    }
    auto& shapes = values[trial.info.participant];  // also of those who have no valid trial
    if (!value || (choice == TrialChoice::kValid && !trial.result.invalid.empty())) continue;
    shapes[trial.plan.shape][is_one ? 0 : 1].push_back(*value);
  }
  LogRatios ratios;
  for (const auto& [person, shapes] : values) {
    std::vector<double> one, other;
    for (const auto& [shape, both] : shapes) {
      if (both[0].empty() || both[1].empty()) continue;
      one.push_back(mean_of(both[0]));
      other.push_back(mean_of(both[1]));
    }
    if (mean_of(one) > 0.0 && mean_of(other) > 0.0) {
      ratios.logs[person] = std::log(mean_of(one) / mean_of(other));
    } else {
      ++ratios.left_out;
    }
  }
  return ratios;
}

std::vector<HypothesisResult> hypothesis_results(const StudyResults& results) {
  std::vector<HypothesisResult> all;
  std::vector<double> probabilities;
  for (const StudyHypothesis& hypothesis : results.files.study.hypotheses) {
    all.push_back(tested(results, hypothesis));
    probabilities.push_back(all.back().p);
  }
  const std::vector<double> corrected = holm_corrected(probabilities);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].p_holm = corrected[i];
  return all;
}

}  // namespace felt
