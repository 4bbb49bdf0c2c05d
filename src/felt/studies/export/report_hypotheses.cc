#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "felt/studies/export/hypothesis_results.h"
#include "felt/studies/export/study_report.h"
#include "felt/trial/study_hypothesis.h"

namespace felt {
namespace {

std::string probability_text(double probability) {
  return probability < 0.001 ? "< 0.001" : report_number(probability);
}

std::string ratio_text(const MeanInterval& ratio) {
  return report_number(ratio.mean) + " [" + report_number(ratio.low) + ", " +
         report_number(ratio.high) + "]";
}

std::string result_text(const HypothesisResult& result) {
  if (!result.tests) return "too few people";
  if (result.is_supported()) return "supported";
  return result.is_rejected() ? "the opposite" : "not supported";
}

ReportTable hypotheses_table(const Study& study, const std::vector<HypothesisResult>& all) {
  ReportTable table{"Tests of the hypotheses",
                    {{"Hypothesis", "People", "Ratio", "p", "p, Holm", "Result"}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const HypothesisResult& result = all[i];
    table.rows.push_back(
        {"H" + std::to_string(i + 1) + ": " + hypothesis_text(study, result.hypothesis),
         std::to_string(result.tests ? result.tests->people : 0),
         result.tests ? ratio_text(result.tests->ratio) : "-",
         result.tests ? probability_text(result.p) : "-",
         result.tests ? probability_text(result.p_holm) : "-", result_text(result)});
  }
  return table;
}

/// Both one-sided tests of each hypothesis with a margin; no rows if there is none.
ReportTable margins_table(const std::vector<HypothesisResult>& all) {
  ReportTable table{
      "Tests against the margin",
      {{"Hypothesis", "Margin, %", "Ratio, 90 %", "p not worse", "p not better", "p the same"}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& tests = all[i].tests;
    if (all[i].hypothesis.kind == HypothesisKind::kLess || !tests) continue;
    table.rows.push_back(
        {"H" + std::to_string(i + 1), report_number(100.0 * all[i].hypothesis.margin),
         ratio_text(tests->narrow_ratio), probability_text(tests->p_not_worse),
         probability_text(tests->p_not_better), probability_text(tests->p_same())});
  }
  return table;
}

}  // namespace

void add_hypotheses(const StudyResults& results, Report& report) {
  const std::vector<HypothesisResult> all = hypothesis_results(results);
  if (all.empty()) return;
  report.push_back(ReportHeading{"Hypotheses"});
  report.push_back(hypotheses_table(results.files.study, all));
  std::string text =
      "Ratio is the geometric mean over participants of the measure in the first condition divided "
      "by that in the second one, with its 95 % interval. The tests are Student's t tests of the "
      "logarithms of these ratios: two-sided for \"smaller\" (supported if the ratio is also below "
      "1), one-sided for a margin (non-inferiority, DOI 10.1007/s11606-010-1513-8; equivalence by "
      "two one-sided tests, DOI 10.1007/BF01068419 and 10.1177/1948550617697177). p, Holm is "
      "corrected over all hypotheses (Holm 1979, jstor.org/stable/4615733); a hypothesis is "
      "supported if it is at most 0.05. \"Not supported\" does not mean that there is no "
      "difference.";
  std::size_t most_left_out = 0;
  for (const HypothesisResult& result : all) {
    most_left_out = std::max(most_left_out, result.left_out);
  }
  if (most_left_out > 0) {
    text +=
        " Participants without a ratio, because valid trials are missing or the measure is 0, "
        "are left out: up to " +
        std::to_string(most_left_out) + ".";
  }
  report.push_back(ReportText{text});
  ReportTable margins = margins_table(all);
  if (margins.rows.size() < 2) return;
  report.push_back(std::move(margins));
  report.push_back(ReportText{
      "Not worse: the ratio is below 1 + margin. Not better: it is above 1 / (1 + margin). The "
      "same: both, which is so if the 90 % interval is within the margin. These probabilities are "
      "not corrected."});
}

}  // namespace felt
