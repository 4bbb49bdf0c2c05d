#include "felt/studies/export/study_report.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "felt/trial/study_order.h"

namespace felt {
namespace {

constexpr TrialMetric kError = &TrialMetrics::err_mean_mm;

struct ReportedMetric {
  TrialMetric metric;
  const char* name;
  const char* unit;
};
// The error comes with time and speed, because people can trade one for the other.
constexpr std::array<ReportedMetric, 3> kReportedMetrics = {
    {{kError, "Error", "mm"},
     {&TrialMetrics::movement_s, "Time", "s"},
     {&TrialMetrics::speed_mean_mm_per_s, "Speed", "mm/s"}}};

std::string interval_text(const PeopleMean& mean) {
  if (mean.people == 0) return "-";
  if (!mean.interval) return report_number(mean.mean);
  return report_number(mean.mean) + " [" + report_number(mean.interval->low) + ", " +
         report_number(mean.interval->high) + "]";
}

std::string plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void add_introduction(const StudyResults& results, Report& report) {
  const Study& study = results.files.study;
  report.push_back(ReportTitle{study.label});
  std::set<int> people;
  std::set<std::string> devices;
  for (const MeasuredTrial& trial : results.trials) {
    people.insert(trial.info.participant);
    devices.insert(trial.info.device);
  }
  std::string text = "Study " + study.id + ": " + plural(people.size(), "participant") + ", " +
                     plural(study.conditions.size(), "condition") + ", " +
                     plural(study.shapes.size(), "shape") + ".";
  for (const std::string& device : devices) {
    text += (device == *devices.begin() ? " Device: " : ", ") + device;
  }
  if (!devices.empty()) text += ".";
  if (!study.source.empty()) text += " After: " + study.source + ".";
  report.push_back(ReportText{text});
  if (results.is_simulated()) {
    report.push_back(ReportText{
        "These people are simulated: they show that the method works, and how forces act on a "
        "model of a hand; they do not show what people would do."});
  }
  if (!results.unfinished.empty()) {
    std::string rest = "Unfinished, so that trials are missing here: ";
    for (const std::string& session : results.unfinished) {
      rest += (&session == &results.unfinished.front() ? "" : "; ") + session;
    }
    report.push_back(ReportText{rest + "."});
  }
  report.push_back(ReportText{
      "Error is the mean distance between the drawn line and the shape, in mm (err_mean_mm in "
      "trials.csv). The value of a participant is the mean over shapes. Brackets contain 95 % "
      "intervals of the mean over participants (studentised bootstrap, DOI "
      "10.1080/00031305.2015.1089789); with fewer than " +
      std::to_string(kMinIntervalValues) + " participants there is no interval."});
}

ReportTable means_table(const StudyResults& results, SessionKind session) {
  ReportTable table{"Means of the conditions", {{"Condition", "People"}}};
  for (const ReportedMetric& metric : kReportedMetrics) {
    table.rows[0].push_back(std::string(metric.name) + ", " + metric.unit);
  }
  for (const std::size_t condition : conditions_in(results.files.study, session)) {
    const std::size_t people = person_means(results, session, condition, kError).size();
    std::vector<std::string> row = {results.files.study.conditions[condition].label,
                                    std::to_string(people)};
    for (const ReportedMetric& metric : kReportedMetrics) {
      row.push_back(
          interval_text(people_mean(person_means(results, session, condition, metric.metric))));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable differences_table(const StudyResults& results, SessionKind session) {
  const std::vector<std::size_t> conditions = conditions_in(results.files.study, session);
  const Study& study = results.files.study;
  ReportTable table{
      "Differences within participants: each condition minus " +
          study.conditions[conditions[0]].label,
      {{"Condition", "People", "Error, mm", "d_z", "Ratio", "Time, s", "Error, all trials, mm"}}};
  for (std::size_t i = 1; i < conditions.size(); ++i) {
    const auto of = [&](TrialMetric metric, TrialChoice choice) {
      return difference_of(person_means(results, session, conditions[0], metric, choice),
                           person_means(results, session, conditions[i], metric, choice));
    };
    const PersonDifference error = of(kError, TrialChoice::kValid);
    table.rows.push_back({study.conditions[conditions[i]].label, std::to_string(error.mean.people),
                          interval_text(error.mean), error.dz ? report_number(*error.dz) : "-",
                          error.ratio ? report_number(*error.ratio) : "-",
                          interval_text(of(&TrialMetrics::movement_s, TrialChoice::kValid).mean),
                          interval_text(of(kError, TrialChoice::kAll).mean)});
  }
  return table;
}

void add_session(const StudyResults& results, SessionKind session, Report& report) {
  const std::string name(kSessionKinds[static_cast<std::size_t>(session)]);
  report.push_back(ReportHeading{"Session " + name});
  report.push_back(condition_figure(results, session, kError,
                                    "Error of each participant and mean of each condition"));
  report.push_back(means_table(results, session));
  if (conditions_in(results.files.study, session).size() < 2) return;
  report.push_back(difference_figure(
      results, session, kError, "Difference in error of each participant, and mean with interval"));
  report.push_back(differences_table(results, session));
  report.push_back(ReportText{
      "Negative differences: smaller error, or less time. An interval that does not contain 0 "
      "speaks for a difference between the conditions. d_z is the mean difference divided by the "
      "standard deviation of the differences. Ratio is the mean error divided by that of the first "
      "condition. The last column also counts the invalid trials: if it differs much from the "
      "column Error, the result depends on the rules that exclude trials."});
  report.push_back(
      drawn_figure(results, session, "The last line of each participant on each shape"));
}

void add_counts(const StudyResults& results, Report& report) {
  const TrialCounts counts = count_trials(results);
  std::size_t invalid = 0;
  for (const auto& [reason, count] : counts.invalid) invalid += count;
  report.push_back(ReportHeading{"Trials"});
  report.push_back(ReportText{plural(counts.valid, "valid trial") + ", " +
                              plural(invalid, "invalid trial") + ", " +
                              plural(counts.practice, "practice trial") +
                              ". Means contain only "
                              "valid trials that are not practice."});
  if (counts.invalid.empty()) return;
  ReportTable table{"Invalid trials", {{"Rule", "Trials"}}};
  for (const auto& [reason, count] : counts.invalid) {
    table.rows.push_back({reason, std::to_string(count)});
  }
  report.push_back(std::move(table));
}

using QuestionScore = std::optional<double> QuestionScores::*;

PersonValues score_means(const StudyResults& results, std::size_t condition, QuestionScore score) {
  std::map<int, std::vector<double>> all;
  for (const GivenAnswers& given : results.answers) {
    if (given.plan.condition != condition) continue;
    if (const auto value = scores_of(given.answers).*score) {
      all[given.info.participant].push_back(*value);
    }
  }
  PersonValues means;
  for (const auto& [person, values] : all) means[person] = mean_of(values);
  return means;
}

void add_questionnaires(const StudyResults& results, Report& report) {
  if (results.answers.empty()) return;
  report.push_back(ReportHeading{"Questionnaires"});
  ReportTable table{"Means of the answers",
                    {{"Condition", "Workload (raw TLX, 0 to 100)", "Pragmatic quality (-3 to 3)",
                      "Hedonic quality (-3 to 3)"}}};
  for (std::size_t i = 0; i < results.files.study.conditions.size(); ++i) {
    std::vector<std::string> row = {results.files.study.conditions[i].label};
    for (const QuestionScore score : {&QuestionScores::tlx_mean, &QuestionScores::ueq_pragmatic,
                                      &QuestionScores::ueq_hedonic}) {
      row.push_back(interval_text(people_mean(score_means(results, i, score))));
    }
    table.rows.push_back(std::move(row));
  }
  report.push_back(std::move(table));
  if (results.files.study.question_time == QuestionTime::kSession) {
    report.push_back(ReportText{
        "The questions came at the end of a session, and so the answers stand with the last "
        "condition of the session, although they are about all of them."});
  }
}

}  // namespace

std::string report_number(double value) {
  std::array<char, 40> text{};
  const double size = std::abs(value);
  const int digits = size < 1.0 ? 3 : size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
  const double power = std::pow(10.0, digits);
  // Adding 0 turns -0 into 0.
  const double rounded = std::isfinite(value) ? std::round(value * power) / power + 0.0 : value;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), rounded,
                                     std::chars_format::fixed, digits)
                           .ptr};
}

Report study_report(const StudyResults& results) {
  Report report;
  add_introduction(results, report);
  const std::vector<SessionKind> sessions = sessions_with_trials(results);
  if (sessions.empty()) {
    report.push_back(ReportText{"There are no trials yet."});
    return report;
  }
  add_hypotheses(results, report);
  for (const SessionKind session : sessions) add_session(results, session, report);
  report.push_back(ReportHeading{"Learning"});
  report.push_back(learning_figure(results, kError, "Error in the order of the study"));
  add_questionnaires(results, report);
  add_counts(results, report);
  report.push_back(ReportHeading{"The other files"});
  report.push_back(ReportText{
      "trials.csv has one row for each attempt of a trial; trials.json describes its columns. "
      "analysis.R and analysis.py fit a mixed model to it. The folder bids has the movements in "
      "the form of the Brain Imaging Data Structure, and recordings has the files of Feltline."});
  return report;
}

}  // namespace felt
