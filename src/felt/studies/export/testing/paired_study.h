#pragma once

#include <cstdint>
#include <string>

#include "felt/base/random.h"
#include "felt/studies/export/study_results.h"

namespace felt::testing {

/// How the participants of a made study differ from each other.
enum class RatioSpread {
  kNormal,     ///< the logarithms of ratios are normally distributed
  kHeavyTail,  ///< they come from Student's t with 3 degrees of freedom
};

inline constexpr double kPairedSkillDeviation = 0.3;  ///< of the logarithm of the error
inline constexpr double kPairedErrorMm = 0.5;         ///< of the median participant

/// A study whose participants come from a known model: the error of participant p in condition c is
/// 0.5 mm * exp(skill(p) + effect(c) + reaction(p, c)). The logarithm of the ratio of two
/// conditions has the standard deviation `deviation`, and the mean effect(c) - effect(d), between
/// any two. Condition 0 is "air", 1 "plane", 2 "default", 3 "retrace".
struct PairedStudy {
  int people = 8;
  double deviation = 0.13;
  RatioSpread spread = RatioSpread::kNormal;
  double effects[4] = {0.0, 0.0, 0.0, 0.0};  ///< logarithms
};

/// Returns the text of the study, with three hypotheses of the kind less (default against air,
/// retrace against default, retrace against air) and one of the kind not-worse: default against
/// plane, with a margin of 15 %. In this order.
std::string paired_study_text();

/// Returns the results of such a study; the next call with the same generator gives other people.
StudyResults paired_results(const PairedStudy& made, Random& random);

}  // namespace felt::testing
