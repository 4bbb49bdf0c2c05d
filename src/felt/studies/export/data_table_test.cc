#include "felt/studies/export/data_table.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

#include "felt/base/testing/csv_rows.h"
#include "felt/studies/export/testing/made_study.h"
#include "felt/trial/trial_columns.h"

namespace felt::data_table_test {
namespace {

using testing::made_results;

struct Table {
  explicit Table(const std::string& csv) : rows(testing::csv_rows(csv)) {}
  std::string cell(std::size_t row, const std::string& column) const {
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
      if (rows[0][i] == column) return rows[row + 1][i];
    }
    ADD_FAILURE() << "no column " << column;
    return "";
  }
  std::vector<std::vector<std::string>> rows;
};

Table trials_table(const StudyResults& results) {
  return Table(csv_text(trial_columns(results), results.trials));
}

TEST(TrialsTable, EveryRowHasEveryColumn) {
  const StudyResults results = made_results({.people = 2});
  const Table table = trials_table(results);
  ASSERT_EQ(table.rows.size(), results.trials.size() + 1);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.rows[0].size());
  const std::set<std::string> names(table.rows[0].begin(), table.rows[0].end());
  EXPECT_EQ(names.size(), table.rows[0].size());
  for (const TrialColumn& metric : trial_metric_columns()) {
    EXPECT_TRUE(names.contains(std::string(metric.name))) << metric.name;
  }
}

TEST(TrialsTable, HasTheFactorsOfEachCondition) {
  const StudyResults results = made_results({.people = 1});
  const Table table = trials_table(results);
  std::set<std::string> seen;
  for (std::size_t row = 0; row < results.trials.size(); ++row) {
    const std::string condition = table.cell(row, "condition");
    seen.insert(condition);
    EXPECT_EQ(table.cell(row, "forces"), condition == "free" ? "air" : "all");
    EXPECT_EQ(table.cell(row, "guidance"), condition == "guided" ? "groove" : "none");
    EXPECT_EQ(table.cell(row, "guidance_strength"), condition == "guided" ? "0.5" : "");
    EXPECT_EQ(table.cell(row, "pencil.snap"), condition == "free" ? "off" : "");
    EXPECT_EQ(table.cell(row, "pencil.stabiliser_length_mm"), condition == "null" ? "8" : "");
    EXPECT_EQ(table.cell(row, "shape_tunnel_mm"), table.cell(row, "shape") == "wave" ? "4" : "");
    EXPECT_EQ(table.cell(row, "is_practice") == "true", table.cell(row, "position") == "0");
    EXPECT_EQ(table.cell(row, "person_seed"), "1001");
    EXPECT_EQ(table.cell(row, "study_hash").size(), 6U + 16U);
  }
  EXPECT_EQ(seen, (std::set<std::string>{"free", "guided", "null"}));
}

TEST(TrialsTable, NumbersComeBackAndMissingOnesAreEmpty) {
  StudyResults results = made_results({.people = 1, .is_simulated = false});
  results.trials.resize(2);
  results.trials[0].metrics.err_mean_mm = 0.1 + 0.2;
  results.trials[0].metrics.work_mj = -1.0 / 3.0;
  results.trials[1].metrics.err_mean_mm = 5e-324;
  results.trials[1].plan.seed = ~std::uint64_t{0};
  results.trials[1].info.device = "a \"new\", long\nname";
  const Table table = trials_table(results);
  const auto number = [&](std::size_t row, const char* column) {
    const std::string text = table.cell(row, column);
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  };
  EXPECT_EQ(number(0, "err_mean_mm"), 0.1 + 0.2);
  EXPECT_EQ(number(0, "work_mj"), -1.0 / 3.0);
  EXPECT_EQ(number(1, "err_mean_mm"), 5e-324);
  EXPECT_EQ(table.cell(1, "work_mj"), "");
  EXPECT_EQ(table.cell(1, "person_seed"), "");
  EXPECT_EQ(table.cell(1, "seed"), "18446744073709551615");
  EXPECT_EQ(table.cell(1, "device"), "a \"new\", long\nname");
}

TEST(TrialsTable, AnotherStudyHasAnotherHash) {
  StudyResults results = made_results({.people = 1});
  const std::string before = trials_table(results).cell(0, "study_hash");
  results.files.sources[0].second += " ";
  EXPECT_NE(trials_table(results).cell(0, "study_hash"), before);
}

TEST(DataDictionary, DescribesEveryColumn) {
  const StudyResults results = made_results({.people = 1});
  const auto check = [](const auto& columns) {
    auto dictionary = nlohmann::ordered_json::parse(dictionary_text(infos_of(columns)));
    EXPECT_EQ(dictionary.size(), columns.size());
    for (const auto& column : columns) {
      const auto found = dictionary.find(column.info.name);
      EXPECT_TRUE(found != dictionary.end() &&
                  found->at("Description").template get<std::string>().size() > 5)
          << column.info.name;
    }
    return dictionary;
  };
  const auto trials = check(trial_columns(results));
  EXPECT_EQ(trials["condition"]["Levels"].begin().key(), "free");
  EXPECT_EQ(trials["err_mean_mm"]["Units"], "mm");
  EXPECT_EQ(trials["sparc"]["TermURL"], "https://doi.org/10.1186/s12984-015-0090-9");
  check(answer_columns(results));
}

TEST(AnswersTable, HasItemsAndScores) {
  StudyResults results = made_results({.people = 1});
  results.answers.resize(2);
  results.answers[0].answers = {3, Questionnaire::kNasaTlx, {10, 20, 30, 40, 50, 90}};
  results.answers[1].answers = {3, Questionnaire::kUeqS, {7, 7, 6, 6, 3, 3, 4, 4}};
  const Table table(csv_text(answer_columns(results), results.answers));
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.cell(0, "form"), "nasa-tlx");
  EXPECT_EQ(table.cell(0, "tlx_performance"), "40");
  EXPECT_EQ(table.cell(0, "tlx_mean"), "40");
  EXPECT_EQ(table.cell(0, "ueq_1"), "");
  EXPECT_EQ(table.cell(0, "ueq_overall"), "");
  EXPECT_EQ(table.cell(1, "ueq_pragmatic"), "2.5");
  EXPECT_EQ(table.cell(1, "ueq_hedonic"), "-0.5");
  EXPECT_EQ(table.cell(1, "ueq_overall"), "1");
  EXPECT_EQ(table.cell(1, "tlx_mean"), "");
}

TEST(ConditionPositions, CountConditionsInEachBlock) {
  std::vector<PlannedTrial> plan(6);
  plan[0].is_practice = true;
  const std::vector<int> blocks = {0, 1, 1, 1, 2, 2};
  const std::vector<std::size_t> conditions = {1, 2, 2, 0, 0, 2};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    plan[i].block = blocks[i];
    plan[i].condition = conditions[i];
  }
  EXPECT_EQ(condition_positions(plan), (std::vector<int>{0, 1, 1, 2, 1, 2}));
}

}  // namespace
}  // namespace felt::data_table_test
