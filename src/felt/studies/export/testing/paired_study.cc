#include "felt/studies/export/testing/paired_study.h"

#include <array>
#include <cmath>

#include "felt/base/check.h"
#include "felt/trial/study_file.h"
#include "felt/trial/study_shapes.h"

namespace felt::testing {
namespace {

/// Returns a number with mean 0 and standard deviation 1. Student's t with 3 degrees of freedom has
/// the variance 3.
double spread_number(RatioSpread spread, Random& random) {
  const double normal = random.normal();
  if (spread == RatioSpread::kNormal) return normal;
  double squares = 0.0;
  for (int i = 0; i < 3; ++i) squares += std::pow(random.normal(), 2.0);
  return normal / std::sqrt(squares / 3.0) / std::sqrt(3.0);
}

}  // namespace

std::string paired_study_text() {
  std::string text = "id = \"paired\"\n";
  for (const char* name : {"air", "plane", "default", "retrace"}) {
    text += "[[condition]]\nname = \"" + std::string(name) + "\"\n";
  }
  text += "[[shape]]\nname = \"line\"\nkind = \"line\"\n";
  constexpr std::array<std::array<const char*, 3>, 4> kHypotheses = {
      {{"default", "air", ""},
       {"retrace", "default", ""},
       {"retrace", "air", ""},
       {"default", "plane", "kind = \"not-worse\"\nmargin = 0.15\n"}}};
  for (const auto& [condition, against, rest] : kHypotheses) {
    text += std::string("[[hypothesis]]\nmeasure = \"err_mean_mm\"\ncondition = \"") + condition +
            "\"\nagainst = \"" + against + "\"\n" + rest;
  }
  return text;
}

StudyResults paired_results(const PairedStudy& made, Random& random) {
  static const Study study = read_study(paired_study_text(), "paired.toml").value();
  StudyResults results;
  results.files.study = study;
  results.files.sources = {{"paired.toml", paired_study_text()}};
  results.files.paths = {{shape_path(StudyShapeKind::kLine, 80.0), TrialPathEnds::kOpen}};
  for (int person = 1; person <= made.people; ++person) {
    const double skill = kPairedSkillDeviation * random.normal();
    for (std::size_t condition = 0; condition < study.conditions.size(); ++condition) {
      // The difference of two independent reactions has the deviation of the ratio.
      const double reaction = made.deviation / std::sqrt(2.0) * spread_number(made.spread, random);
      MeasuredTrial trial;
      trial.info = {person, SessionKind::kTrain, "Made device", "made 1.0"};
      trial.plan.condition = condition;
      trial.plan.number = static_cast<int>(condition) + 1;
      trial.plan.block = 1;
      trial.metrics.err_mean_mm =
          kPairedErrorMm * std::exp(skill + made.effects[condition] + reaction);
      results.trials.push_back(std::move(trial));
    }
  }
  return results;
}

}  // namespace felt::testing
