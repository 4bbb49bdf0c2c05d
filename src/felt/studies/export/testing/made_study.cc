#include "felt/studies/export/testing/made_study.h"

#include <cmath>

#include "felt/base/check.h"
#include "felt/base/random.h"
#include "felt/trial/study_file.h"
#include "felt/trial/study_shapes.h"

namespace felt::testing {
namespace {

constexpr double kShapeMm = 60.0;

MeasuredTrial made_trial(const StudyResults& results, const PlannedTrial& plan, double skill,
                         Random& random) {
  MeasuredTrial trial;
  trial.plan = plan;
  trial.result = {plan.number, 1, "", "trial-" + std::to_string(plan.number) + ".felt"};
  trial.recording = "recordings/" + trial.result.recording;
  trial.path = results.files.paths[plan.shape].points;
  trial.is_closed = results.files.paths[plan.shape].ends == TrialPathEnds::kClosed;
  const double error = 0.5 * std::exp(skill + 0.25 * random.normal() - 0.05 * plan.block) *
                       (plan.condition == 1 ? 0.8 : 1.0);
  trial.metrics.err_mean_mm = error;
  trial.metrics.movement_s = 4.0 * std::exp(0.2 * random.normal());
  trial.metrics.speed_mean_mm_per_s = 100.0 / *trial.metrics.movement_s;
  const double phase = random.between(0.0, 6.0);
  trial.touches = {0};
  for (std::size_t i = 0; i < trial.path.size(); i += 2) {
    const double at = 0.07 * static_cast<double>(i) + phase;
    trial.ink.push_back(trial.path[i] + 2.0 * error * Vec{std::sin(at), std::cos(1.3 * at)});
  }
  return trial;
}

std::vector<double> made_answers(Questionnaire form, Random& random) {
  std::vector<double> values;
  for (std::size_t i = 0; i < item_count(form); ++i) {
    values.push_back(form == Questionnaire::kNasaTlx ? std::floor(random.between(0.0, 100.0))
                                                     : std::floor(random.between(1.0, 8.0)));
  }
  return values;
}

}  // namespace

const char* const MadeStudy::kStudyText = R"(
id = "made"
label = "Made, \"for\" tests"
order = "balanced-latin-square"
blocks = 3
practice_trials = 1
questions = { forms = ["nasa-tlx", "ueq-s"] }
[[condition]]
name = "free"
forces = false
settings = { "pencil.snap" = "off" }
[[condition]]
name = "guided"
guidance = "groove"
strength = 0.5
[[condition]]
name = "null"
settings = { "pencil.stabiliser" = "towed", "pencil.stabiliser_length_mm" = 8 }
[[shape]]
name = "circle"
kind = "circle"
[[shape]]
name = "wave"
kind = "wave"
task = "tunnel"
tunnel_mm = 4
)";

StudyResults made_results(const MadeStudy& made) {
  StudyResults results;
  const Result<Study> study = read_study(made.text, "made.toml");
  FELT_CHECK(study);
  results.files.study = *study;
  results.files.sources = {{"made.toml", made.text}};
  for (const StudyShape& shape : study->shapes) {
    const bool is_closed = shape.kind == StudyShapeKind::kCircle;
    results.files.paths.push_back({shape_path(shape.kind, kShapeMm),
                                   is_closed ? TrialPathEnds::kClosed : TrialPathEnds::kOpen});
  }
  Random random(7);
  int trials = 0;
  for (int person = 1; person <= made.people; ++person) {
    const double skill = 0.3 * random.normal();
    for (const SessionKind session : study->sessions) {
      SessionInfo info{person, session, "Made device", "made 1.0"};
      if (made.is_simulated) info.person_seed = 1000 + static_cast<std::uint64_t>(person);
      const auto plan = plan_trials(*study, person, session);
      const std::vector<int> positions = condition_positions(*plan);
      for (std::size_t i = 0; i < plan->size(); ++i) {
        MeasuredTrial trial = made_trial(results, (*plan)[i], skill, random);
        trial.info = info;
        trial.position = positions[i];
        if (made.invalid_every > 0 && ++trials % made.invalid_every == 0) {
          trial.result.invalid = "max_lifts";
        }
        results.trials.push_back(std::move(trial));
        if (!(*plan)[i].asks_questions) continue;
        for (const Questionnaire form : study->questionnaires) {
          results.answers.push_back(
              {info, (*plan)[i], {(*plan)[i].number, form, made_answers(form, random)}});
        }
      }
    }
  }
  return results;
}

}  // namespace felt::testing
