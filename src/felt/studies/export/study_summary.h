#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "felt/studies/export/study_results.h"
#include "felt/trial/statistics.h"

namespace felt {

/// Confidence of all intervals in a report.
inline constexpr double kReportConfidence = 0.95;

/// A metric of TrialMetrics, for example &TrialMetrics::err_mean_mm.
using TrialMetric = TrialMetrics::Value TrialMetrics::*;

/// Which trials count. Practice trials never count.
enum class TrialChoice {
  kValid,  ///< trials that broke no rule
  kAll,    ///< also invalid trials
};

/// A value for each participant, by number.
using PersonValues = std::map<int, double>;

/// Returns the mean of a metric for each participant in a condition of a session: the mean over the
/// shapes of the mean over the trials of the shape. So each shape counts equally, even if some of
/// its trials are invalid. Participants without a trial have no value.
PersonValues person_means(const StudyResults& results, SessionKind session, std::size_t condition,
                          TrialMetric metric, TrialChoice choice = TrialChoice::kValid);

/// A mean over participants.
struct PeopleMean {
  std::size_t people = 0;
  double mean = 0.0;                       ///< 0 without people
  std::optional<MeanInterval> interval{};  ///< absent for fewer than kMinIntervalValues people
};
PeopleMean people_mean(const PersonValues& values);

/// The difference of each participant between two conditions.
struct PersonDifference {
  PersonValues differences;  ///< `other` minus `first`, of participants who have both
  PeopleMean mean;
  std::optional<double> dz;     ///< effect size
  std::optional<double> ratio;  ///< mean of `other` divided by the mean of `first`
};
PersonDifference difference_of(const PersonValues& first, const PersonValues& other);

/// Returns the sessions of which there are trials, in the order of the study.
std::vector<SessionKind> sessions_with_trials(const StudyResults& results);

/// Returns the number of trials that count, and of invalid ones by reason.
struct TrialCounts {
  std::size_t valid = 0, practice = 0;
  std::map<std::string, std::size_t> invalid;
};
TrialCounts count_trials(const StudyResults& results);

}  // namespace felt
