#include "felt/studies/export/hypothesis_results.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/studies/export/testing/paired_study.h"
#include "felt/studies/export/testing/study_rates.h"
#include "felt/trial/study_file.h"

namespace felt::hypothesis_results_test {
namespace {

using testing::paired_results;
using testing::PairedStudy;
using testing::RatioSpread;
using testing::StudyRates;

StudyResults made_with(const PairedStudy& made, std::uint64_t seed = 3) {
  Random random(seed);
  return paired_results(made, random);
}

TEST(HypothesisResults, R75_RatiosAreThoseOfThePeople) {
  StudyResults results = made_with({.people = 6});
  for (MeasuredTrial& trial : results.trials) {
    const double person = trial.info.participant;
    trial.metrics.err_mean_mm = trial.plan.condition == 2 ? 0.8 * person : person;
  }
  const std::vector<HypothesisResult> all = hypothesis_results(results);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].tests->people, 6U);
  EXPECT_NEAR(all[0].tests->ratio.mean, 0.8, 1e-12);
  EXPECT_TRUE(all[0].is_supported());
  // retrace is 1.25 times default: significant, but in the other direction.
  EXPECT_NEAR(all[1].tests->ratio.mean, 1.25, 1e-12);
  EXPECT_TRUE(all[1].is_rejected());
  EXPECT_FALSE(all[1].is_supported());
  EXPECT_EQ(all[2].p, 1.0);
  EXPECT_TRUE(all[3].is_supported());
}

TEST(HypothesisResults, OnlyShapesAndPeopleWithBothConditionsCount) {
  StudyResults results = made_with({.people = 7});
  const LogRatios all = log_ratios(results, SessionKind::kTrain, 2, 0, &TrialMetrics::err_mean_mm);
  ASSERT_EQ(all.logs.size(), 7U);
  // A second shape that only one condition has changes nothing.
  MeasuredTrial other = results.trials[2];
  other.plan.shape = 1;
  other.metrics.err_mean_mm = 100.0;
  results.trials.push_back(other);
  const auto same = [&](const StudyResults& r) {
    return log_ratios(r, SessionKind::kTrain, 2, 0, &TrialMetrics::err_mean_mm);
  };
  EXPECT_EQ(same(results).logs, all.logs);
  // Participant 1 has an invalid trial, 2 an error of 0, and 3 none: they have no ratio.
  results.trials[0].result.invalid = "max_lifts";
  results.trials[4].metrics.err_mean_mm = 0.0;
  results.trials[8].metrics.err_mean_mm.reset();
  EXPECT_EQ(same(results).left_out, 3U);
  EXPECT_EQ(same(results).logs.size(), 4U);
  EXPECT_EQ(
      log_ratios(results, SessionKind::kTrain, 2, 0, &TrialMetrics::err_mean_mm, TrialChoice::kAll)
          .left_out,
      2U);
  // Too few people for a test; the correction still counts the hypothesis.
  const std::vector<HypothesisResult> tested = hypothesis_results(results);
  EXPECT_FALSE(tested[0].tests);
  EXPECT_EQ(tested[0].p_holm, 1.0);
  EXPECT_NEAR(tested[3].p_holm, 4.0 * tested[3].p, 1e-12);
  EXPECT_FALSE(tested[0].is_supported());
}

// The bars of the study: in 1,000 studies 5 +- 1.5 % false positives and 93 to 97 % coverage.
// `./dev bench hypotheses` prints the whole table.
TEST(HypothesisResults, R75_FalsePositivesAndCoverageOfAThousandStudies) {
  for (const int people : {8, 12, 16}) {
    for (const double deviation : {0.13, 0.20}) {
      PairedStudy made{.people = people, .deviation = deviation};
      made.effects[1] = -std::log(1.15);  // default is exactly 15 % worse than plane
      const std::uint64_t seed = 100 + static_cast<std::uint64_t>(people);
      SCOPED_TRACE("people " + std::to_string(people) + ", SD " + std::to_string(deviation) +
                   ", seed " + std::to_string(seed));
      const StudyRates rates = testing::study_rates(made, 1000, seed);
      const double less = (rates.rejected[0] + rates.rejected[1] + rates.rejected[2]) / 3.0;
      EXPECT_NEAR(less, 0.05, 0.015);
      EXPECT_NEAR(rates.rejected[3], 0.05, 0.015);
      EXPECT_LE(rates.any_rejected_holm, 0.065);
      EXPECT_GT(rates.any_rejected, 0.10);  // what the correction is for
      for (const double covered : rates.covered) EXPECT_NEAR(covered, 0.95, 0.02);
      EXPECT_NEAR(rates.covered_mm, 0.95, 0.02);
    }
  }
}

TEST(HypothesisResults, R75_AHeavyTailGivesNoMoreFalsePositives) {
  for (const int people : {8, 16}) {
    PairedStudy made{.people = people, .spread = RatioSpread::kHeavyTail};
    made.effects[1] = -std::log(1.15);
    const StudyRates rates = testing::study_rates(made, 1000, 5);
    for (const double rejected : rates.rejected) EXPECT_LE(rejected, 0.065) << people;
    EXPECT_LE(rates.any_rejected_holm, 0.065) << people;
    for (const double covered : rates.covered) EXPECT_GE(covered, 0.93) << people;
  }
}

TEST(HypothesisResults, R75_PowerIsThatOfThePlan) {
  PairedStudy made{.people = 12};
  made.effects[2] = std::log(0.85);
  EXPECT_NEAR(testing::study_rates(made, 400, 9).rejected[0], 0.98, 0.02);
  made.effects[2] = std::log(0.9);
  EXPECT_NEAR(testing::study_rates(made, 400, 10).rejected[0], 0.72, 0.07);
}

}  // namespace
}  // namespace felt::hypothesis_results_test
