#pragma once

#include <string>

#include "felt/studies/export/report_page.h"
#include "felt/studies/export/study_results.h"
#include "felt/studies/export/study_summary.h"

namespace felt {

/// Returns the report about a study: the tests of its hypotheses, the means of each condition, the
/// differences of each participant from the first condition, learning, lines, questionnaires and
/// invalid trials.
Report study_report(const StudyResults& results);

/// Returns a number for readers, with three significant digits or more: "0.412", "12.3", "154".
std::string report_number(double value);

/// Adds the tests of the hypotheses of the study; nothing if it has none.
void add_hypotheses(const StudyResults& results, Report& report);

// The figures of the report.

/// The means of each participant and of all in each condition.
ReportFigure condition_figure(const StudyResults& results, SessionKind session, TrialMetric metric,
                              const std::string& title);
/// The differences of each participant from the first condition.
ReportFigure difference_figure(const StudyResults& results, SessionKind session, TrialMetric metric,
                               const std::string& title);
/// The metric over the blocks of the study, or over the trials of a condition if there is only one
/// block: one panel for each condition, one line for each participant.
ReportFigure learning_figure(const StudyResults& results, TrialMetric metric,
                             const std::string& title);
/// The last valid line of each participant, for some shapes: one row for each shape, one column for
/// each condition.
ReportFigure drawn_figure(const StudyResults& results, SessionKind session,
                          const std::string& title);
inline constexpr std::size_t kMaxDrawnShapes = 4;
inline constexpr std::size_t kMaxDrawnConditions = 6;

}  // namespace felt
