#include <algorithm>
#include <cmath>
#include <set>

#include "felt/geometry/rect.h"
#include "felt/studies/export/study_report.h"
#include "felt/trial/study_order.h"

namespace felt {
namespace {

constexpr double kLabelSize = 8.0;
constexpr ReportInk kQuietInk{ReportInk::kQuiet}, kFaintInk{ReportInk::kFaint},
    kPersonInk{ReportInk::kPerson};

/// An axis from `low` to `high` with ticks at multiples of `step`.
struct ReportAxis {
  double low = 0.0, high = 1.0, step = 0.2;
  double begin = 0.0, end = 100.0;  ///< in points

  [[nodiscard]] double at(double value) const {
    return begin + (end - begin) * (value - low) / (high - low);
  }
};

/// Returns an axis whose ends are ticks. The steps are 1, 2 or 5 times a power of ten.
ReportAxis axis_for(double low, double high, double begin, double end) {
  if (!(high > low)) {
    low -= 0.5;
    high += 0.5;
  }
  constexpr double kSteps = 5.0;
  const double raw = (high - low) / kSteps;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double factor = raw / power;
  const double step = power * (factor <= 1.0   ? 1.0
                               : factor <= 2.0 ? 2.0
                               : factor <= 5.0 ? 5.0
                                               : 10.0);
  return {std::floor(low / step) * step, std::ceil(high / step) * step, step, begin, end};
}

std::string tick_text(double value, double step) {
  // Numbers like 0.30000000000000004 come from adding steps.
  const double rounded = std::round(value / step) * step;
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  std::string text =
      std::to_string(std::round(rounded * std::pow(10.0, digits)) / std::pow(10.0, digits) + 0.0);
  const std::size_t point = text.find('.');
  return text.substr(0, digits == 0 ? point : point + 1 + static_cast<std::size_t>(digits));
}

std::size_t tick_count(const ReportAxis& axis) {
  return static_cast<std::size_t>(std::lround((axis.high - axis.low) / axis.step)) + 1;
}

void add_vertical_axis(ReportFigure& figure, const ReportAxis& y, double left, double right,
                       const std::string& unit) {
  for (std::size_t i = 0; i < tick_count(y); ++i) {
    const double value = y.low + static_cast<double>(i) * y.step;
    const double at = y.at(value);
    figure.marks.emplace_back(ReportLine{{{left, at}, {right, at}}, kFaintInk, 0.5});
    figure.marks.emplace_back(ReportWords{
        {left - 5.0, at + 3.0}, tick_text(value, y.step), ReportAlign::kRight, kQuietInk});
  }
  figure.marks.emplace_back(
      ReportWords{{left - 5.0, y.end - 9.0}, unit, ReportAlign::kRight, kQuietInk});
}

/// Returns a label that is not wider than `width`.
std::string shortened(std::string text, double width) {
  if (helvetica_width(text) * kLabelSize <= width) return text;
  while (!text.empty() && helvetica_width(text + "...") * kLabelSize > width) {
    // A character of UTF-8 is removed with all of its bytes.
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80)
      text.pop_back();
    if (!text.empty()) text.pop_back();
  }
  return text + "...";
}

void extend(double& low, double& high, double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

/// Adds the mean and its interval as a dot on a bar. An axis that points up gives an upright bar.
void add_mean(ReportFigure& figure, const PeopleMean& mean, const ReportAxis& axis, double across,
              ReportInk ink) {
  if (mean.people == 0) return;
  const bool is_upright = axis.begin > axis.end;
  const auto place = [&](double value) {
    return is_upright ? Point{across, axis.at(value)} : Point{axis.at(value), across};
  };
  if (mean.interval) {
    figure.marks.emplace_back(
        ReportLine{{place(mean.interval->low), place(mean.interval->high)}, ink, 2.5});
  }
  figure.marks.emplace_back(ReportDot{place(mean.mean), 4.0, ink});
}

std::vector<PersonValues> values_by_condition(const StudyResults& results, SessionKind session,
                                              const std::vector<std::size_t>& conditions,
                                              TrialMetric metric) {
  std::vector<PersonValues> all;
  all.reserve(conditions.size());
  for (const std::size_t condition : conditions) {
    all.push_back(person_means(results, session, condition, metric));
  }
  return all;
}

}  // namespace

ReportFigure condition_figure(const StudyResults& results, SessionKind session, TrialMetric metric,
                              const std::string& title) {
  ReportFigure figure{title, "", 220.0, {}};
  const std::vector<std::size_t> conditions = conditions_in(results.files.study, session);
  const std::vector<PersonValues> values =
      values_by_condition(results, session, conditions, metric);
  double high = 0.0;
  for (const PersonValues& people : values) {
    for (const auto& [person, value] : people) high = std::max(high, value);
    const PeopleMean mean = people_mean(people);
    if (mean.interval) high = std::max(high, mean.interval->high);
  }
  const double left = 36.0, right = kReportWidth - 4.0;
  const ReportAxis y = axis_for(0.0, high, 196.0, 16.0);
  add_vertical_axis(figure, y, left, right, "mm");
  const double pitch = (right - left) / static_cast<double>(conditions.size());
  const auto x_of = [&](std::size_t i) { return left + pitch * (static_cast<double>(i) + 0.5); };

  std::map<int, ReportLine> lines;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (const auto& [person, value] : values[i]) {
      lines[person].points.push_back({x_of(i), y.at(value)});
    }
  }
  for (auto& [person, line] : lines) {
    line.ink = kPersonInk;
    line.width = 0.6;
    for (const Point p : line.points) figure.marks.emplace_back(ReportDot{p, 1.2, kPersonInk});
    if (line.points.size() > 1) figure.marks.emplace_back(line);
  }
  figure.description = "Thin lines are participants, dots with bars are means with 95 % intervals.";
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const PeopleMean mean = people_mean(values[i]);
    const StudyCondition& condition = results.files.study.conditions[conditions[i]];
    add_mean(figure, mean, y, x_of(i), {ReportInk::kCondition, conditions[i]});
    figure.marks.emplace_back(ReportWords{
        {x_of(i), 211.0}, shortened(condition.label, pitch - 6.0), ReportAlign::kMiddle});
    figure.description += " " + condition.label + ": " + report_number(mean.mean) + " mm.";
  }
  return figure;
}

ReportFigure difference_figure(const StudyResults& results, SessionKind session, TrialMetric metric,
                               const std::string& title) {
  const std::vector<std::size_t> conditions = conditions_in(results.files.study, session);
  const std::vector<PersonValues> values =
      values_by_condition(results, session, conditions, metric);
  constexpr double kRow = 34.0, kLabels = 130.0;
  ReportFigure figure{title, "", kRow * static_cast<double>(conditions.size() - 1) + 40.0, {}};
  std::vector<PersonDifference> differences;
  double low = 0.0, high = 0.0;
  for (std::size_t i = 1; i < conditions.size(); ++i) {
    differences.push_back(difference_of(values[0], values[i]));
    const PersonDifference& difference = differences.back();
    for (const auto& [person, value] : difference.differences) extend(low, high, value);
    if (difference.mean.interval) {
      extend(low, high, difference.mean.interval->low);
      extend(low, high, difference.mean.interval->high);
    }
  }
  const ReportAxis x = axis_for(low, high, kLabels + 10.0, kReportWidth - 12.0);
  const double bottom = figure.height - 28.0;
  for (std::size_t i = 0; i < tick_count(x); ++i) {
    const double value = x.low + static_cast<double>(i) * x.step, at = x.at(value);
    const bool is_zero = std::abs(value) < 0.5 * x.step;
    figure.marks.emplace_back(ReportLine{
        {{at, 4.0}, {at, bottom}}, is_zero ? ReportInk{} : kFaintInk, is_zero ? 0.9 : 0.5});
    figure.marks.emplace_back(ReportWords{
        {at, bottom + 11.0}, tick_text(value, x.step), ReportAlign::kMiddle, kQuietInk});
  }
  figure.marks.emplace_back(ReportWords{
      {0.5 * (x.begin + x.end), bottom + 23.0},
      "mm; left of 0: more accurate than " + results.files.study.conditions[conditions[0]].label,
      ReportAlign::kMiddle,
      kQuietInk});
  figure.description =
      "Small dots are participants, large dots with bars are means with intervals.";
  for (std::size_t i = 1; i < conditions.size(); ++i) {
    const PersonDifference& difference = differences[i - 1];
    const double y = 4.0 + kRow * (static_cast<double>(i) - 0.5);
    const StudyCondition& condition = results.files.study.conditions[conditions[i]];
    figure.marks.emplace_back(ReportWords{{0.0, y + 3.0}, shortened(condition.label, kLabels)});
    for (const auto& [person, value] : difference.differences) {
      figure.marks.emplace_back(ReportDot{{x.at(value), y + 9.0}, 1.5, kPersonInk});
    }
    add_mean(figure, difference.mean, x, y, {ReportInk::kCondition, conditions[i]});
    figure.description +=
        " " + condition.label + ": " + report_number(difference.mean.mean) + " mm.";
  }
  return figure;
}

namespace {

/// A position on the x axis of the learning figure: session and block, or the number of the trial.
using LearningStep = std::pair<std::size_t, int>;

struct LearningData {
  std::set<LearningStep> steps;
  bool is_by_block = true;
  /// Values by condition, participant and step.
  std::map<std::size_t, std::map<int, std::map<LearningStep, std::vector<double>>>> values;
};

LearningData learning_data(const StudyResults& results, TrialMetric metric) {
  LearningData data;
  const std::vector<SessionKind>& sessions = results.files.study.sessions;
  data.is_by_block = sessions.size() > 1 || results.files.study.blocks > 1;
  std::map<std::pair<int, std::size_t>, int> trials;  // by participant and condition
  for (const MeasuredTrial& trial : results.trials) {
    const TrialMetrics::Value& value = trial.metrics.*metric;
    if (trial.plan.is_practice || !trial.result.invalid.empty() || !value) continue;
    LearningStep step;
    if (data.is_by_block) {
      const auto found = std::find(sessions.begin(), sessions.end(), trial.plan.session);
      step = {static_cast<std::size_t>(found - sessions.begin()), trial.plan.block};
    } else {
      step = {0, ++trials[{trial.info.participant, trial.plan.condition}]};
    }
    data.steps.insert(step);
    data.values[trial.plan.condition][trial.info.participant][step].push_back(*value);
  }
  return data;
}

/// Draws the lines of one condition. `x` counts the steps.
void add_learning_panel(ReportFigure& figure, const LearningData& data, std::size_t condition,
                        const ReportAxis& x, const ReportAxis& y) {
  const auto x_of = [&](const LearningStep& step) {
    return x.at(static_cast<double>(std::distance(data.steps.begin(), data.steps.find(step))));
  };
  const auto found = data.values.find(condition);
  if (found == data.values.end()) return;
  std::map<LearningStep, std::vector<double>> all;
  for (const auto& [person, steps] : found->second) {
    ReportLine line{{}, kPersonInk, 0.5};
    for (const auto& [step, values] : steps) {
      line.points.push_back({x_of(step), y.at(mean_of(values))});
      all[step].push_back(mean_of(values));
    }
    if (line.points.size() > 1) figure.marks.emplace_back(std::move(line));
  }
  ReportLine mean{{}, {ReportInk::kCondition, condition}, 2.0};
  for (const auto& [step, values] : all) mean.points.push_back({x_of(step), y.at(mean_of(values))});
  for (const Point p : mean.points) figure.marks.emplace_back(ReportDot{p, 2.4, mean.ink});
  if (mean.points.size() > 1) figure.marks.emplace_back(std::move(mean));
}

}  // namespace

ReportFigure learning_figure(const StudyResults& results, TrialMetric metric,
                             const std::string& title) {
  const LearningData data = learning_data(results, metric);
  const std::vector<StudyCondition>& conditions = results.files.study.conditions;
  double high = 0.0;
  for (const auto& [condition, people] : data.values) {
    for (const auto& [person, steps] : people) {
      for (const auto& [step, values] : steps) high = std::max(high, mean_of(values));
    }
  }
  constexpr std::size_t kColumns = 3;
  constexpr double kPanel = 130.0, kLeft = 30.0;
  const std::size_t rows = (conditions.size() + kColumns - 1) / kColumns;
  const std::size_t columns = std::min(kColumns, conditions.size());
  const double width = (kReportWidth - 30.0 - kLeft) / static_cast<double>(columns) - 12.0;
  ReportFigure figure{title, "", kPanel * static_cast<double>(rows) + 16.0, {}};
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const double left = kLeft + (width + 24.0) * static_cast<double>(i % columns);
    const std::size_t row = i / columns;
    const double top = kPanel * static_cast<double>(row);
    const ReportAxis y = axis_for(0.0, high, top + kPanel - 14.0, top + 24.0);
    add_vertical_axis(figure, y, left, left + width, "mm");
    figure.marks.emplace_back(
        ReportWords{{left, top + 9.0}, shortened(conditions[i].label, width)});
    const double last = static_cast<double>(std::max<std::size_t>(data.steps.size(), 2) - 1);
    add_learning_panel(figure, data, i, {0.0, last, 1.0, left + 8.0, left + width - 8.0}, y);
  }
  figure.marks.emplace_back(ReportWords{{0.5 * kReportWidth, figure.height - 4.0},
                                        data.is_by_block
                                            ? "blocks of all sessions, from the first to the last"
                                            : "trials of the condition, from the first to the last",
                                        ReportAlign::kMiddle,
                                        kQuietInk});
  figure.description =
      "One panel for each condition. Thin lines are participants, the thick line is their mean.";
  return figure;
}

namespace {

/// Returns the last valid trial of each participant with a shape in a condition.
std::map<int, const MeasuredTrial*> last_trials(const StudyResults& results, SessionKind session,
                                                std::size_t shape, std::size_t condition) {
  std::map<int, const MeasuredTrial*> trials;
  for (const MeasuredTrial& trial : results.trials) {
    if (trial.plan.session == session && !trial.plan.is_practice && trial.result.invalid.empty() &&
        trial.plan.shape == shape && trial.plan.condition == condition) {
      trials[trial.info.participant] = &trial;
    }
  }
  return trials;
}

Rect extent_of(std::span<const Point> points) {
  Rect box;
  for (const Point p : points) box.extend(p);
  return box;
}

/// Where the lines of one shape in one condition are drawn.
struct DrawnCell {
  Point center;
  double scale = 1.0;
};

/// Draws the line of a trial, and returns its path on the figure.
std::vector<Point> add_drawn_line(ReportFigure& figure, const MeasuredTrial& trial,
                                  const DrawnCell& cell, ReportInk color) {
  // The path of the task `copy` is moved to the ink, so each trial has its own place.
  const Rect own = extent_of(trial.path);
  const Point middle{0.5 * (own.x0 + own.x1), 0.5 * (own.y0 + own.y1)};
  const auto placed = [&](std::span<const Point> points) {
    std::vector<Point> result;
    result.reserve(points.size());
    for (const Point p : points) result.push_back(cell.center + cell.scale * (p - middle));
    return result;
  };
  for (std::size_t touch = 0; touch < trial.touches.size(); ++touch) {
    const std::size_t begin = trial.touches[touch];
    const bool is_last = touch + 1 == trial.touches.size();
    const std::size_t end = is_last ? trial.ink.size() : trial.touches[touch + 1];
    if (end < begin + 2) continue;
    figure.marks.emplace_back(
        ReportLine{placed(std::span(trial.ink).subspan(begin, end - begin)), color, 0.4});
  }
  std::vector<Point> path = placed(trial.path);
  if (trial.is_closed) path.push_back(path.front());
  return path;
}

void add_drawn_lines(ReportFigure& figure, const std::map<int, const MeasuredTrial*>& trials,
                     const DrawnCell& cell, ReportInk color) {
  ReportLine path{{}, {}, 0.8, true};
  for (const auto& [person, trial] : trials) {
    if (!trial->path.empty()) path.points = add_drawn_line(figure, *trial, cell, color);
  }
  if (path.points.size() > 1) figure.marks.emplace_back(std::move(path));
}

}  // namespace

ReportFigure drawn_figure(const StudyResults& results, SessionKind session,
                          const std::string& title) {
  constexpr double kGap = 24.0, kMaxHeight = 120.0, kHeading = 14.0;
  const Study& study = results.files.study;
  std::vector<std::size_t> conditions = conditions_in(study, session);
  std::vector<std::size_t> shapes = shapes_in(study, session);
  conditions.resize(std::min(conditions.size(), kMaxDrawnConditions));
  shapes.resize(std::min(shapes.size(), kMaxDrawnShapes));
  const double width = kReportWidth / static_cast<double>(conditions.size());
  ReportFigure figure{
      title, "One row for each shape, one column for each condition.", kHeading, {}};
  const auto x_of = [width](std::size_t column) {
    return width * (static_cast<double>(column) + 0.5);
  };
  for (std::size_t column = 0; column < conditions.size(); ++column) {
    const std::string& label = study.conditions[conditions[column]].label;
    figure.marks.emplace_back(
        ReportWords{{x_of(column), 9.0}, shortened(label, width - 6.0), ReportAlign::kMiddle});
  }
  for (const std::size_t shape : shapes) {
    const Rect box = extent_of(results.files.paths[shape].points);
    if (box.empty()) continue;
    const double scale = std::min((width - kGap) / std::max(box.width(), 1.0),
                                  (kMaxHeight - kGap) / std::max(box.height(), 1.0));
    const double height = scale * box.height() + kGap;
    for (std::size_t column = 0; column < conditions.size(); ++column) {
      add_drawn_lines(figure, last_trials(results, session, shape, conditions[column]),
                      {{x_of(column), figure.height + 0.5 * height}, scale},
                      {ReportInk::kCondition, conditions[column]});
    }
    figure.height += height;
  }
  return figure;
}

}  // namespace felt
