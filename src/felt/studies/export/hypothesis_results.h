#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "felt/studies/export/study_summary.h"
#include "felt/trial/paired_ratio.h"

namespace felt {

/// The primary hypotheses are tested at this level, after Holm's correction.
inline constexpr double kHypothesisLevel = 0.05;

/// What the data of a study say about one of its hypotheses.
struct HypothesisResult {
  StudyHypothesis hypothesis = {};
  std::size_t left_out = 0;              ///< participants who have no ratio (log_ratios())
  std::optional<RatioTests> tests = {};  ///< absent for fewer than kMinIntervalValues ratios
  double p = 1.0;                        ///< of the test of this kind; 1 without tests
  double p_holm = 1.0;                   ///< corrected over all hypotheses of the study
  /// Returns true if the null hypothesis is rejected at kHypothesisLevel. A hypothesis of the kind
  /// kLess may then be refuted: the ratio is above 1.
  [[nodiscard]] bool is_rejected() const noexcept { return p_holm <= kHypothesisLevel; }
  [[nodiscard]] bool is_supported() const noexcept {
    return is_rejected() && (hypothesis.kind != HypothesisKind::kLess || tests->ratio.mean < 1.0);
  }
};

/// Returns the tests of all hypotheses of the study, in its order. A hypothesis that cannot be
/// tested yet counts in the correction, too, so that the correction is the planned one.
std::vector<HypothesisResult> hypothesis_results(const StudyResults& results);

/// The logarithm of the ratio of each participant, by number.
struct LogRatios {
  PersonValues logs;
  std::size_t left_out = 0;
};
/// Returns the logarithm of the ratio of a metric in two conditions for each participant. As in
/// person_means(), the value of a participant is a mean over shapes; only shapes with trials in
/// both conditions count. A participant has no ratio without such a shape, or if a mean is not
/// above 0.
LogRatios log_ratios(const StudyResults& results, SessionKind session, std::size_t condition,
                     std::size_t against, TrialMetric metric,
                     TrialChoice choice = TrialChoice::kValid);

}  // namespace felt
