#include "felt/studies/export/hypothesis_table.h"

#include <string>
#include <utility>

#include "felt/material/number_text.h"
#include "felt/trial/study_hypothesis.h"

namespace felt {
namespace {

using Row = HypothesisRow;

/// Returns a column with a number of the tests; empty for too few people.
DataColumn<Row> number_column(const char* name, const char* description,
                              double (*number)(const HypothesisResult&)) {
  return {{name, description, "1"}, [number](const Row& row) {
            return row.result.tests ? number_text(number(row.result)) : std::string();
          }};
}

void add_tests(std::vector<DataColumn<Row>>& columns) {
  using Result = HypothesisResult;
  columns.push_back(number_column(
      "ratio", "Geometric mean over participants of the measure in condition divided by against.",
      [](const Result& r) { return r.tests->ratio.mean; }));
  columns.push_back(number_column("ratio_low", "Lower end of the 95 % interval of the ratio.",
                                  [](const Result& r) { return r.tests->ratio.low; }));
  columns.push_back(number_column("ratio_high", "Upper end of the 95 % interval of the ratio.",
                                  [](const Result& r) { return r.tests->ratio.high; }));
  columns.push_back(number_column("p", "Probability of the test of this kind, not corrected.",
                                  [](const Result& r) { return r.p; }));
  columns.push_back(number_column("p_holm",
                                  "Probability after Holm's correction over all hypotheses.",
                                  [](const Result& r) { return r.p_holm; }));
  columns.back().info.source = "https://www.jstor.org/stable/4615733";
  columns.push_back(number_column("p_not_worse",
                                  "One-sided test against a ratio of 1 + margin; 1 without margin.",
                                  [](const Result& r) { return r.tests->p_not_worse; }));
  columns.back().info.source = "10.1007/s11606-010-1513-8";
  columns.push_back(number_column(
      "p_not_better", "One-sided test against a ratio of 1 / (1 + margin); 1 without margin.",
      [](const Result& r) { return r.tests->p_not_better; }));
  columns.back().info.source = "10.1007/BF01068419";
}

}  // namespace

std::vector<HypothesisRow> hypothesis_rows(const StudyResults& results) {
  std::vector<HypothesisRow> rows;
  const Study& study = results.files.study;
  for (HypothesisResult& result : hypothesis_results(results)) {
    const StudyHypothesis& hypothesis = result.hypothesis;
    rows.push_back(
        {"H" + std::to_string(rows.size() + 1) + ": " + hypothesis_text(study, hypothesis),
         hypothesis_session(study, hypothesis), std::move(result)});
  }
  return rows;
}

std::vector<DataColumn<HypothesisRow>> hypothesis_columns() {
  std::vector<DataColumn<Row>> columns = {
      {{"hypothesis", "The hypothesis as a sentence."}, [](const Row& r) { return r.text; }},
      {{"condition", "The condition about which it says something."},
       [](const Row& r) { return r.result.hypothesis.condition; }},
      {{"against", "The condition with which it is compared."},
       [](const Row& r) { return r.result.hypothesis.against; }},
      {{"measure", "The column of trials.csv that is compared."},
       [](const Row& r) { return r.result.hypothesis.measure; }},
      {{"kind", "less, not-worse or same."},
       [](const Row& r) {
         return std::string(kHypothesisKinds[static_cast<std::size_t>(r.result.hypothesis.kind)]);
       }},
      {{"margin", "Share by which the measure may be larger; 0 for the kind less.", "1"},
       [](const Row& r) { return number_text(r.result.hypothesis.margin); }},
      {{"session", "The session in which it is tested."},
       [](const Row& r) {
         return std::string(kSessionKinds[static_cast<std::size_t>(r.session)]);
       }},
      {{"people", "Participants with a ratio.", "1"},
       [](const Row& r) { return std::to_string(r.result.tests ? r.result.tests->people : 0); }}};
  add_tests(columns);
  return columns;
}

}  // namespace felt
