#include "felt/studies/export/study_summary.h"

#include <algorithm>

namespace felt {
namespace {

std::vector<double> values_of(const PersonValues& people) {
  std::vector<double> values;
  for (const auto& [person, value] : people) values.push_back(value);
  return values;
}

}  // namespace

PersonValues person_means(const StudyResults& results, SessionKind session, std::size_t condition,
                          TrialMetric metric, TrialChoice choice) {
  std::map<int, std::map<std::size_t, std::vector<double>>> values;  // by person and shape
  for (const MeasuredTrial& trial : results.trials) {
    const TrialMetrics::Value& value = trial.metrics.*metric;
    if (trial.plan.is_practice || trial.plan.session != session ||
        trial.plan.condition != condition || !value ||
        (choice == TrialChoice::kValid && !trial.result.invalid.empty())) {
      continue;
    }
    values[trial.info.participant][trial.plan.shape].push_back(*value);
  }
  PersonValues means;
  for (const auto& [person, shapes] : values) {
    std::vector<double> of_shapes;
    for (const auto& [shape, of_shape] : shapes) of_shapes.push_back(mean_of(of_shape));
    means[person] = mean_of(of_shapes);
  }
  return means;
}

PeopleMean people_mean(const PersonValues& values) {
  const std::vector<double> numbers = values_of(values);
  return {numbers.size(), mean_of(numbers), mean_interval(numbers, kReportConfidence)};
}

PersonDifference difference_of(const PersonValues& first, const PersonValues& other) {
  PersonDifference result;
  std::vector<double> a, b;
  for (const auto& [person, value] : other) {
    const auto found = first.find(person);
    if (found == first.end()) continue;
    result.differences[person] = value - found->second;
    a.push_back(found->second);
    b.push_back(value);
  }
  result.mean = people_mean(result.differences);
  result.dz = effect_size_dz(values_of(result.differences));
  if (mean_of(a) > 0.0) result.ratio = mean_of(b) / mean_of(a);
  return result;
}

std::vector<SessionKind> sessions_with_trials(const StudyResults& results) {
  std::vector<SessionKind> sessions;
  for (const SessionKind session : results.files.study.sessions) {
    if (std::any_of(results.trials.begin(), results.trials.end(),
                    [session](const MeasuredTrial& t) { return t.plan.session == session; })) {
      sessions.push_back(session);
    }
  }
  return sessions;
}

TrialCounts count_trials(const StudyResults& results) {
  TrialCounts counts;
  for (const MeasuredTrial& trial : results.trials) {
    if (trial.plan.is_practice) {
      ++counts.practice;
    } else if (trial.result.invalid.empty()) {
      ++counts.valid;
    } else {
      ++counts.invalid[trial.result.invalid];
    }
  }
  return counts;
}

}  // namespace felt
