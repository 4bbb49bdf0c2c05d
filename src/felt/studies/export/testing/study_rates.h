#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "felt/studies/export/testing/paired_study.h"

namespace felt::testing {

/// How often the tests of a report were right in many made studies. Shares of the studies.
struct StudyRates {
  /// Null hypotheses of each hypothesis that were rejected before and after Holm's correction.
  std::array<double, 4> rejected{}, rejected_holm{};
  double any_rejected_holm = 0.0;   ///< studies in which at least one was rejected
  double any_rejected = 0.0;        ///< the same without the correction
  std::array<double, 4> covered{};  ///< the interval of 95 % contains the true ratio
  double covered_mm = 0.0;  ///< the same for the difference in mm of default and air in the report
};

/// Makes studies and tests their hypotheses with hypothesis_results(), as the report does. The same
/// arguments give the same rates. covered_mm is 0 for a heavy tail, because the mean in mm of such
/// people does not exist.
StudyRates study_rates(const PairedStudy& made, std::size_t studies, std::uint64_t seed);

}  // namespace felt::testing
