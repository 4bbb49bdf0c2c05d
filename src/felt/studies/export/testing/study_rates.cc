#include "felt/studies/export/testing/study_rates.h"

#include <cmath>

#include "felt/studies/export/hypothesis_results.h"
#include "felt/trial/study_hypothesis.h"

namespace felt::testing {
namespace {

/// Returns the mean difference in mm between default and air of all people: the mean of a lognormal
/// number is exp(mean + variance / 2).
double true_difference_mm(const PairedStudy& made) {
  const double variance =
      kPairedSkillDeviation * kPairedSkillDeviation + 0.5 * made.deviation * made.deviation;
  return kPairedErrorMm * std::exp(0.5 * variance) *
         (std::exp(made.effects[2]) - std::exp(made.effects[0]));
}

bool covers_difference_mm(const StudyResults& results, double truth_mm) {
  const auto means = [&results](std::size_t condition) {
    return person_means(results, SessionKind::kTrain, condition, &TrialMetrics::err_mean_mm);
  };
  const auto interval = difference_of(means(0), means(2)).mean.interval;
  return interval && interval->low <= truth_mm && truth_mm <= interval->high;
}

}  // namespace

StudyRates study_rates(const PairedStudy& made, std::size_t studies, std::uint64_t seed) {
  Random random(seed);
  StudyRates rates;
  const double each = 1.0 / static_cast<double>(studies);
  for (std::size_t i = 0; i < studies; ++i) {
    const StudyResults results = paired_results(made, random);
    const std::vector<HypothesisResult> tested = hypothesis_results(results);
    bool is_any = false, is_any_holm = false;
    for (std::size_t h = 0; h < tested.size(); ++h) {
      const HypothesisResult& result = tested[h];
      const Study& study = results.files.study;
      const double truth =
          std::exp(made.effects[condition_index(study, result.hypothesis.condition)] -
                   made.effects[condition_index(study, result.hypothesis.against)]);
      const bool is_rejected = result.p <= kHypothesisLevel;
      if (is_rejected) rates.rejected[h] += each;
      if (result.is_rejected()) rates.rejected_holm[h] += each;
      if (result.tests->ratio.low <= truth && truth <= result.tests->ratio.high) {
        rates.covered[h] += each;
      }
      is_any |= is_rejected;
      is_any_holm |= result.is_rejected();
    }
    if (is_any) rates.any_rejected += each;
    if (is_any_holm) rates.any_rejected_holm += each;
    if (made.spread == RatioSpread::kNormal &&
        covers_difference_mm(results, true_difference_mm(made))) {
      rates.covered_mm += each;
    }
  }
  return rates;
}

}  // namespace felt::testing
