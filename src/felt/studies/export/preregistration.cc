#include "felt/studies/export/preregistration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "felt/material/number_text.h"
#include "felt/studies/export/data_table.h"
#include "felt/studies/export/hypothesis_results.h"
#include "felt/studies/export/study_report.h"
#include "felt/trial/student_t.h"
#include "felt/trial/study_hypothesis.h"
#include "felt/trial/study_order.h"
#include "felt/trial/trial_columns.h"

namespace felt {
namespace {

/// SDs of the logarithm of the ratio of two conditions, for what a number of people can show: as
/// measured between two surfaces by Arora and others (DOI 10.1145/3025453.3025474), and a cautious
/// one.
constexpr std::array<double, 2> kPlannedDeviations = {0.13, 0.20};
constexpr double kPlannedPower = 0.8;

/// Returns the ratio below 1 that a two-sided test at 5 % finds with a power of 80 %. The sum of
/// the two quantiles of Student's t is a good approximation of the noncentral distribution.
double smallest_ratio(int people, double deviation) {
  const auto freedom = static_cast<std::size_t>(people - 1);
  const double sum = student_t_quantile(1.0 - 0.5 * kHypothesisLevel, freedom) +
                     student_t_quantile(kPlannedPower, freedom);
  return std::exp(-sum * deviation / std::sqrt(static_cast<double>(people)));
}

class Preregistration {
 public:
  Preregistration(const StudyFiles& files, int people, const std::string& program)
      : files_(files), study_(files.study), people_(people), program_(program) {}

  std::string text() && {
    line("# Preregistration: " + study_.label);
    line("Written by " + program_ + " from the study `" + study_.id +
         "`. Lines in brackets are left for the researcher.");
    add_study();
    add_design();
    add_sampling();
    add_variables();
    add_analysis();
    add_fingerprints();
    return std::move(out_);
  }

 private:
  void line(const std::string& text) { out_ += (out_.empty() ? "" : "\n") + text + "\n"; }
  void item(const std::string& text) { out_ += "* " + text + "\n"; }
  void heading(const std::string& text) { line("## " + text); }
  void field(const std::string& name, const std::string& text) {
    line("### " + name);
    line(text);
  }

  void add_study() {
    heading("Study information");
    field("Title", study_.label);
    field("Authors", "[names]");
    if (!study_.source.empty()) field("After", study_.source);
    line("### Hypotheses");
    out_ += "\n";
    for (std::size_t i = 0; i < study_.hypotheses.size(); ++i) {
      const StudyHypothesis& hypothesis = study_.hypotheses[i];
      item("H" + std::to_string(i + 1) + ": " + hypothesis_text(study_, hypothesis) + " (session " +
           session_text(hypothesis_session(study_, hypothesis)) + ").");
    }
  }

  static std::string session_text(SessionKind session) {
    return std::string(kSessionKinds[static_cast<std::size_t>(session)]);
  }

  void add_design() {
    heading("Design plan");
    field("Study type", "Experiment. Every participant draws in every condition.");
    field("Blinding", study_.is_blind
                          ? "Participants see letters instead of the names of the conditions, in "
                            "an order of their own. They can feel some differences all the same, "
                            "such as a pen without a surface."
                          : "None: participants see the names of the conditions.");
    std::string design = "Conditions: ";
    for (const StudyCondition& condition : study_.conditions) {
      design += (&condition == &study_.conditions.front() ? "" : ", ") + condition.name;
    }
    design += ". Shapes: ";
    for (const StudyShape& shape : study_.shapes) {
      design += (&shape == &study_.shapes.front() ? "" : ", ") + shape.name + " (" +
                std::string(kStudyTasks[static_cast<std::size_t>(shape.task)]) + ")";
    }
    for (const SessionKind session : study_.sessions) {
      design += ". Session " + session_text(session) + ": " +
                std::to_string(trial_count(study_, session)) + " trials";
    }
    field("Study design", design + ", practice included.");
    field("Randomisation", order_text());
  }

  [[nodiscard]] std::string order_text() const {
    switch (study_.order) {
      case StudyOrder::kSequential:
        return "None: the conditions come in the order of the study.";
      case StudyOrder::kRandom:
        return "The conditions are shuffled for each participant and block.";
      case StudyOrder::kBalancedLatinSquare:
        break;
    }
    // The number of rows with which every session is balanced.
    std::size_t rows = 1;
    for (const SessionKind session : study_.sessions) {
      rows = std::lcm(rows, williams_rows(conditions_in(study_, session).size()));
    }
    std::string text = "A Williams design (DOI 10.1071/CH9490149) of " + std::to_string(rows) +
                       " rows: participant p uses row p in the first block.";
    if (static_cast<std::size_t>(people_) % rows != 0) {
      text += " " + std::to_string(people_) + " is not a multiple of " + std::to_string(rows) +
              ", so positions and neighbours are not exactly balanced.";
    }
    return text;
  }

  void add_sampling() {
    heading("Sampling plan");
    field("Existing data", "None: this text is written before the first participant.");
    field("Recruitment", "[who is asked, where, and what they get]");
    field("Sample size", std::to_string(people_) + " participants with complete sessions.");
    std::string rationale;
    for (const double deviation : kPlannedDeviations) {
      const double change = 100.0 * (1.0 - smallest_ratio(people_, deviation));
      rationale += (rationale.empty() ? "" : ", and ") + report_number(change) +
                   " % smaller with an SD of " + number_text(deviation);
    }
    field("Why this size",
          "With a power of 80 %, one two-sided test finds a measure that is " + rationale +
              " (SD: the standard deviation over participants of the logarithm of the ratio). "
              "After Holm's correction, the difference must be larger. [why this is "
              "enough]");
    field("Stopping rule",
          "The number is fixed. Nobody looks at the tests before all of them have "
          "taken part.");
  }

  void add_variables() {
    heading("Variables");
    field("Manipulated", "The condition.");
    line("### Primary measures");
    out_ += "\n";
    std::set<std::string> said;
    for (const StudyHypothesis& hypothesis : study_.hypotheses) {
      if (!said.insert(hypothesis.measure).second) continue;
      for (const TrialColumn& column : trial_metric_columns()) {
        if (column.name != hypothesis.measure) continue;
        item("`" + hypothesis.measure + "` (" + std::string(column.unit) +
             "): " + std::string(column.formula) +
             (column.source.empty() ? "" : " DOI " + std::string(column.source) + "."));
      }
    }
    field("Indices",
          "The value of a participant in a condition is the mean over shapes of the "
          "mean over trials. The ratio of two conditions contains only shapes with valid "
          "trials in both.");
  }

  void add_analysis() {
    heading("Analysis plan");
    field("Model",
          "Student's t test of the logarithm of each participant's ratio. Smaller: "
          "two-sided against a ratio of 1. Not worse: one-sided against 1 + margin "
          "(DOI 10.1007/s11606-010-1513-8). The same: two one-sided tests against 1 + "
          "margin and 1 / (1 + margin) (DOI 10.1007/BF01068419). Intervals of 95 % beside "
          "each ratio, and the lines of all participants.");
    field("Inference",
          "All hypotheses are primary. A hypothesis is supported if its probability "
          "after Holm's correction over all " +
              std::to_string(study_.hypotheses.size()) +
              " of them (https://www.jstor.org/stable/4615733) is at most 0.05 and its "
              "ratio has the stated direction.");
    line("### Exclusions");
    out_ += "\n";
    add_exclusions();
    field("Missing data",
          "A participant without valid trials in both conditions, or whose measure "
          "is 0, has no ratio and is left out of that test; the report counts them. "
          "Nothing is imputed.");
    field("Exploratory",
          "Time and speed beside each error; the mixed model of analysis.R; all "
          "other columns of trials.csv; the tests with invalid trials.");
  }

  void add_exclusions() {
    const CatchRules& rules = study_.catch_rules;
    item("Practice trials do not count.");
    if (rules.min_length_share > 0.0) {
      item("A trial is invalid if its line is shorter than " +
           number_text(100.0 * rules.min_length_share) + " % of the shape.");
    }
    if (rules.max_lifts) {
      item("A trial is invalid if the pen is lifted more than " + std::to_string(*rules.max_lifts) +
           " times before the end.");
    }
    if (rules.max_mm_per_s) {
      item("A trial is invalid if the mean speed of the pen is above " +
           number_text(*rules.max_mm_per_s) + " mm/s.");
    }
    if (rules.left_tunnel) item("A trial is invalid if the pen leaves the tunnel.");
    if (rules.device_fault) item("A trial is invalid if the device reports a fault.");
    item(rules.action == CatchAction::kRepeat ? "An invalid trial is repeated, at most " +
                                                    std::to_string(rules.max_repeats) + " times."
                                              : "An invalid trial is not repeated.");
    item("[who is left out altogether, and why]");
  }

  void add_fingerprints() {
    StudyFiles named = files_;
    if (!named.sources.empty()) named.sources.front().first = kStudyFileName;
    heading("Other");
    out_ += "\n";
    item("Fingerprint of the study and of the files that it names: `" + study_hash(named) +
         "`. Each row of trials.csv has it as `study_hash`.");
    item("Program: " + program_ + ".");
    item("Seed of the order: " + std::to_string(study_.seed) + ".");
  }

  const StudyFiles& files_;
  const Study& study_;
  int people_;
  const std::string& program_;
  std::string out_;
};

}  // namespace

Result<std::string> preregistration_text(const StudyFiles& files, int people,
                                         const std::string& program) {
  if (people < kMinParticipants || people > kMaxParticipants) {
    return fail(ErrorCode::kInvalidArgument,
                "people is " + std::to_string(people) + ", it must be " +
                    std::to_string(kMinParticipants) + " to " + std::to_string(kMaxParticipants));
  }
  if (files.study.hypotheses.empty()) {
    return fail(ErrorCode::kInvalidArgument,
                "the study has no hypothesis; add a table [[hypothesis]] with condition, against "
                "and measure");
  }
  return Preregistration(files, people, program).text();
}

}  // namespace felt
