// Makes studies with a known effect, and counts how often the tests and intervals of the report
// (felt/studies/export/hypothesis_results.h) are right.
//   bench_hypotheses [--studies N] [--seed N]
//
// The people come from a lognormal model (paired_study.h): the logarithm of the ratio of two
// conditions has a standard deviation of 0.13 or 0.20, or of 0.13 with a heavy tail. Four
// hypotheses are tested: three of the kind less, one of the kind not-worse with a margin of 15 %.
// Without effect, all four null hypotheses are true, the last one because its ratio is
// exactly 1.15.
//
// The exit status is 1 if the lognormal model gives a false positive rate outside 5 +- 1.5 % for
// one kind of test (the mean of the three tests of the kind less; a single share of 1,000 studies
// has a standard error of 0.7 %), a family-wise error above 6.5 % after Holm's correction, or a
// coverage of an interval outside 93 to 97 %.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "felt/studies/export/testing/study_rates.h"

namespace felt::bench {
namespace {

using testing::PairedStudy;
using testing::RatioSpread;
using testing::StudyRates;

struct HypothesisOptions {
  std::size_t studies = 1000;
  std::uint64_t seed = 1;
};

HypothesisOptions hypothesis_options_of(int argc, char** argv) {
  HypothesisOptions options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
    const auto number = std::strtoull(value.c_str(), nullptr, 10);
    if (name == "--studies" && number > 0) {
      options.studies = number;
    } else if (name == "--seed") {
      options.seed = number;
    } else {
      fmt::print(stderr, "bench_hypotheses: unknown option {} {}\n", name, value);
      std::exit(2);
    }
  }
  return options;
}

struct PeopleModel {
  const char* name;
  double deviation;
  RatioSpread spread;
};
constexpr std::array<PeopleModel, 3> kModels = {
    {{"0.13", 0.13, RatioSpread::kNormal},
     {"0.20", 0.20, RatioSpread::kNormal},
     {"0.13, heavy tail", 0.13, RatioSpread::kHeavyTail}}};
constexpr std::array<int, 3> kPeople = {8, 12, 16};

/// The exact power of the test of the kind less with 8, 12 and 16 people, from the noncentral t
/// distribution, for normally distributed logarithms with an SD of 0.13 and 0.20.
struct PlannedPower {
  double effect;
  std::array<std::array<double, 3>, 2> power;
};
constexpr std::array<PlannedPower, 4> kPlannedPowers = {
    {{-0.05, {{{0.16, 0.24, 0.31}, {0.09, 0.13, 0.16}}}},
     {-0.10, {{{0.51, 0.72, 0.86}, {0.25, 0.38, 0.50}}}},
     {-0.15, {{{0.86, 0.98, 1.00}, {0.51, 0.73, 0.86}}}},
     {-0.20, {{{0.98, 1.00, 1.00}, {0.77, 0.94, 0.99}}}}}};

bool is_within(double share, double low, double high) {
  return share >= low - 1e-9 && share <= high + 1e-9;
}

/// Returns true if the bars hold.
bool check_without_effect(const HypothesisOptions& options) {
  fmt::print("Without effect: false positives of each test at 5 %, of any, of any after Holm\n");
  fmt::print("{:>18} {:>3} | {:>5} {:>5} {:>5} {:>9} | {:>5} {:>5} | {:>8} {:>12}\n", "SD", "n",
             "less", "less", "less", "not worse", "any", "Holm", "coverage", "in mm");
  bool is_good = true;
  std::uint64_t seed = options.seed;
  for (const PeopleModel& model : kModels) {
    for (const int people : kPeople) {
      PairedStudy made{people, model.deviation, model.spread};
      made.effects[1] = -std::log(1.15);
      const StudyRates r = testing::study_rates(made, options.studies, seed++);
      double low = 1.0, high = 0.0;
      for (const double share : r.covered) {
        low = std::min(low, share);
        high = std::max(high, share);
      }
      fmt::print("{:>18} {:>3} | {:5.1f} {:5.1f} {:5.1f} {:9.1f} | {:5.1f} {:5.1f} | {:.1f}-{:.1f}",
                 model.name, people, 100 * r.rejected[0], 100 * r.rejected[1], 100 * r.rejected[2],
                 100 * r.rejected[3], 100 * r.any_rejected, 100 * r.any_rejected_holm, 100 * low,
                 100 * high);
      if (model.spread == RatioSpread::kHeavyTail) {
        fmt::print("\n");
        continue;
      }
      fmt::print(" {:>10.1f}\n", 100 * r.covered_mm);
      const double less = (r.rejected[0] + r.rejected[1] + r.rejected[2]) / 3.0;
      for (const double share : {less, r.rejected[3]}) {
        is_good = is_good && is_within(share, 0.035, 0.065);
      }
      is_good = is_good && r.any_rejected_holm <= 0.065 && is_within(low, 0.93, 0.97) &&
                is_within(high, 0.93, 0.97) && is_within(r.covered_mm, 0.93, 0.97);
    }
  }
  return is_good;
}

/// Prints the power of one test of the kind less, and beside it the exact one.
void print_power(const HypothesisOptions& options) {
  fmt::print(
      "\nPower of one test at 5 % (in brackets: the exact power without a heavy tail) and after "
      "Holm\n");
  fmt::print("{:>18} {:>7} | {:>17} {:>18} {:>18}\n", "SD", "effect", "n = 8", "n = 12", "n = 16");
  std::uint64_t seed = options.seed + 1000;
  for (const PeopleModel& model : kModels) {
    for (const PlannedPower& planned : kPlannedPowers) {
      fmt::print("{:>18} {:>5.0f} % |", model.name, 100 * planned.effect);
      for (std::size_t i = 0; i < kPeople.size(); ++i) {
        PairedStudy made{kPeople[i], model.deviation, model.spread};
        made.effects[2] = std::log1p(planned.effect);
        const StudyRates r = testing::study_rates(made, options.studies, seed++);
        fmt::print("  {:.2f} ({:.2f}) {:.2f}", r.rejected[0],
                   planned.power[model.deviation > 0.15 ? 1 : 0][i], r.rejected_holm[0]);
      }
      fmt::print("\n");
    }
  }
  fmt::print(
      "\nPower of not worse by 15 % without a true difference (exact: 0.90 with n = 9 for SD 0.13, "
      "0.90 with n = 19 for 0.20)\n");
  for (const PeopleModel& model : kModels) {
    fmt::print("{:>18} |", model.name);
    for (const int people : {8, 9, 12, 16, 19}) {
      const StudyRates r =
          testing::study_rates({people, model.deviation, model.spread}, options.studies, seed++);
      fmt::print("  n = {}: {:.2f}", people, r.rejected[3]);
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  using namespace felt::bench;
  const HypothesisOptions options = hypothesis_options_of(argc, argv);
  fmt::print("{} studies in each cell, seed {}\n\n", options.studies, options.seed);
  const bool is_good = check_without_effect(options);
  print_power(options);
  fmt::print("\n{}\n", is_good ? "All bars hold." : "A bar does not hold.");
  return is_good ? 0 : 1;
}
