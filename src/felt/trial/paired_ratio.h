#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "felt/trial/statistics.h"

namespace felt {

/// The tests of one comparison of two conditions, from the ratio of each participant: the measure
/// in one condition divided by the measure in the other. All tests are Student's t tests of the
/// logarithms, because errors and times are about lognormal (Bland, Altman, "The use of
/// transformation when comparing two means", BMJ 312, 1996, DOI 10.1136/bmj.312.7039.1153).
struct RatioTests {
  std::size_t people = 0;
  /// The geometric mean of the ratios and its interval of 95 %. It excludes 1 if p_different is
  /// below 0.05.
  MeanInterval ratio;
  /// The interval of 90 %. It is within the margin if p_same is below 0.05.
  MeanInterval narrow_ratio;
  double deviation = 0.0;    ///< standard deviation of the logarithms of the ratios
  double p_different = 1.0;  ///< two-sided; null hypothesis: the ratio is 1
  /// One-sided; null hypothesis: the ratio is 1 + margin or more. 1 without a margin.
  double p_not_worse = 1.0;
  /// One-sided; null hypothesis: the ratio is 1 / (1 + margin) or less. 1 without a margin.
  double p_not_better = 1.0;
  /// Equivalence by two one-sided tests: the larger one of the two above.
  [[nodiscard]] double p_same() const noexcept {
    return p_not_worse > p_not_better ? p_not_worse : p_not_better;
  }
};

/// Confidence of RatioTests::ratio; the other interval leaves out twice as much.
inline constexpr double kRatioConfidence = 0.95;

/// Returns the tests for the logarithms of the ratios of participants. `margin` is a share above 0,
/// or 0 for no margin: with 0.15, a ratio of 1.15 or more is worse, and of 1 / 1.15 or less better.
/// Returns nullopt for fewer than kMinIntervalValues participants, or if a number is not finite or
/// the margin is negative. If all ratios are equal, each probability is 0 or 1.
///
/// Sources: Schuirmann, "A comparison of the two one-sided tests procedure and the power approach",
/// J Pharmacokinet Biopharm 15, 1987, DOI 10.1007/BF01068419; Lakens, "Equivalence tests", Soc
/// Psychol Personal Sci 8, 2017, DOI 10.1177/1948550617697177; Walker, Nowacki, "Understanding
/// equivalence and noninferiority testing", J Gen Intern Med 26, 2011, DOI
/// 10.1007/s11606-010-1513-8.
std::optional<RatioTests> test_ratios(std::span<const double> log_ratios, double margin);

/// Returns the probabilities after Holm's correction, in the same order: if each hypothesis is
/// rejected whose corrected probability is at most 0.05, then any false rejection among them has a
/// probability of at most 0.05, however the hypotheses depend on each other. Source: Holm, "A
/// simple sequentially rejective multiple test procedure", Scand J Statist 6, 1979, pages 65-70,
/// https://www.jstor.org/stable/4615733.
std::vector<double> holm_corrected(std::span<const double> probabilities);

}  // namespace felt
