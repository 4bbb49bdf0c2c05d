#include "felt/studies/export/study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <pugixml.hpp>

#include <cstdlib>
#include <fstream>

#include "felt/studies/export/testing/made_study.h"

namespace felt::study_report_test {
namespace {

using ::testing::HasSubstr;
using testing::made_results;
using ::testing::Not;

constexpr const char* kSimulated = "These people are simulated";

/// Returns the root of a page of HTML that is also XML.
pugi::xml_document parsed(const std::string& html) {
  pugi::xml_document document;
  std::string xml = html;
  for (const char* open : {"<meta charset=\"utf-8\">", "initial-scale=1\">"}) {
    const std::size_t at = xml.find(open);
    EXPECT_NE(at, std::string::npos) << open;
    xml.insert(at + std::string(open).size() - 1, "/");
  }
  const auto result = document.load_string(xml.c_str(), pugi::parse_default | pugi::parse_doctype);
  EXPECT_TRUE(result) << result.description() << " at " << result.offset;
  return document;
}

TEST(StudyReport, HtmlIsSelfContainedAndAccessible) {
  const std::string html = report_html(study_report(made_results()));
  const pugi::xml_document page = parsed(html);
  EXPECT_STREQ(page.child("html").attribute("lang").value(), "en");
  EXPECT_STREQ(page.child("html").child("head").child("title").text().get(), "Made, \"for\" tests");
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("href=")));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme: dark"));
  int figures = 0;
  for (const auto& found : page.select_nodes("//svg")) {
    ++figures;
    EXPECT_STREQ(found.node().attribute("role").value(), "img");
    EXPECT_STRNE(found.node().child("title").text().get(), "");
    EXPECT_STRNE(found.node().child("desc").text().get(), "");
  }
  EXPECT_EQ(figures, 4);
}

TEST(StudyReport, SaysThatPeopleAreSimulatedOnlyIfTheyAre) {
  EXPECT_THAT(report_html(study_report(made_results())), HasSubstr(kSimulated));
  EXPECT_THAT(report_html(study_report(made_results({.is_simulated = false}))),
              Not(HasSubstr(kSimulated)));
}

TEST(StudyReport, ShowsThePlantedDifference) {
  const StudyResults results = made_results({.people = 40});
  const auto difference =
      difference_of(person_means(results, SessionKind::kTrain, 0, &TrialMetrics::err_mean_mm),
                    person_means(results, SessionKind::kTrain, 1, &TrialMetrics::err_mean_mm));
  EXPECT_EQ(difference.differences.size(), 40U);
  EXPECT_NEAR(*difference.ratio, 0.8, 0.04);
  ASSERT_TRUE(difference.mean.interval);
  EXPECT_LT(difference.mean.interval->high, 0.0);
  EXPECT_LT(*difference.dz, -0.5);
  EXPECT_THAT(report_html(study_report(results)),
              HasSubstr(report_number(difference.mean.mean) + " [" +
                        report_number(difference.mean.interval->low)));
}

TEST(StudyReport, InvalidAndPracticeTrialsDoNotCountButAreReported) {
  StudyResults results = made_results({.people = 1, .invalid_every = 3});
  MeasuredTrial& practice = results.trials.front();
  ASSERT_TRUE(practice.plan.is_practice);
  const auto mean = [&](TrialChoice choice) {
    return person_means(results, SessionKind::kTrain, practice.plan.condition,
                        &TrialMetrics::err_mean_mm, choice);
  };
  const PersonValues valid = mean(TrialChoice::kValid), all = mean(TrialChoice::kAll);
  EXPECT_NE(valid, all);
  practice.metrics.err_mean_mm = 1000.0;
  EXPECT_EQ(mean(TrialChoice::kAll), all);
  const TrialCounts counts = count_trials(results);
  EXPECT_EQ(counts.practice, 3U);
  EXPECT_EQ(counts.valid + counts.invalid.at("max_lifts"), results.trials.size() - 3);
  EXPECT_THAT(report_html(study_report(results)), HasSubstr("<th scope=\"row\">max_lifts</th>"));
}

TEST(StudyReport, EachShapeCountsEqually) {
  StudyResults results = made_results({.people = 1});
  std::erase_if(results.trials, [](const MeasuredTrial& t) {
    return t.plan.is_practice || t.plan.condition != 0 || (t.plan.shape == 1 && t.plan.block > 1);
  });
  for (MeasuredTrial& trial : results.trials) {
    trial.metrics.err_mean_mm = trial.plan.shape == 0 ? 1.0 : 3.0;
  }
  EXPECT_EQ(results.trials.size(), 4U);
  const auto means = person_means(results, SessionKind::kTrain, 0, &TrialMetrics::err_mean_mm);
  EXPECT_EQ(means, (PersonValues{{1, 2.0}}));
}

TEST(StudyReport, WorksWithFewOrNoData) {
  for (const int people : {0, 1, 2, 5}) {
    for (const int invalid_every : {0, 1}) {
      const StudyResults results = made_results({.people = people, .invalid_every = invalid_every});
      const Report report = study_report(results);
      const std::string html = report_html(report);
      parsed(html);
      EXPECT_THAT(html, Not(HasSubstr("nan")));
      EXPECT_THAT(html, Not(HasSubstr("inf,")));
      EXPECT_EQ(html.find("There are no trials yet") != std::string::npos, people == 0);
      const bool has_interval = html.find(" [") != std::string::npos;
      EXPECT_EQ(has_interval, people >= 5) << people;  // the differences of all trials
      EXPECT_THAT(report_pdf(report), HasSubstr("%%EOF"));
    }
  }
}

TEST(StudyReport, HasAPartForEachSessionWithTrials) {
  testing::MadeStudy made;
  made.text = std::string("sessions = [\"pre\", \"train\", \"retention\"]\n") + made.text;
  StudyResults results = made_results(made);
  std::erase_if(results.trials,
                [](const MeasuredTrial& t) { return t.plan.session == SessionKind::kRetention; });
  const std::string html = report_html(study_report(results));
  EXPECT_THAT(html, HasSubstr("Session pre"));
  EXPECT_THAT(html, HasSubstr("Session train"));
  EXPECT_THAT(html, Not(HasSubstr("Session retention")));
}

TEST(StudyReport, WorksWithOneCondition) {
  testing::MadeStudy made;
  made.text =
      "id = \"one\"\n[[condition]]\nname = \"only\"\n[[shape]]\nname = \"l\"\nkind = \"line\"\n";
  const std::string html = report_html(study_report(made_results(made)));
  parsed(html);
  EXPECT_THAT(html, Not(HasSubstr("Differences within")));
}

TEST(StudyReport, R75_TestsTheHypothesesOfTheStudy) {
  testing::MadeStudy made;
  made.text = made.text + std::string(R"(
[[hypothesis]]
condition = "guided"
against = "free"
measure = "err_mean_mm"
[[hypothesis]]
condition = "null"
against = "free"
measure = "movement_s"
kind = "same"
margin = 0.3
[[hypothesis]]
condition = "null"
against = "free"
measure = "err_total_mm"
)");
  const std::string html = report_html(study_report(made_results(made)));
  parsed(html);
  EXPECT_THAT(html, HasSubstr("H1: err_mean_mm is smaller in &quot;Guided&quot; than in "
                              "&quot;Free&quot;"));
  EXPECT_THAT(html, HasSubstr("supported"));
  EXPECT_THAT(html, HasSubstr("too few people"));
  EXPECT_THAT(html, HasSubstr("Tests against the margin"));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
  EXPECT_THAT(report_html(study_report(made_results())), Not(HasSubstr("Hypotheses")));
}

TEST(ReportPdf, HasPagesAndAValidTableOfObjects) {
  const Report report = study_report(made_results());
  const std::string pdf = report_pdf(report);
  EXPECT_EQ(pdf, report_pdf(report));
  const std::size_t start = pdf.rfind("startxref\n");
  const auto table = static_cast<std::size_t>(std::atol(pdf.c_str() + start + 10));
  ASSERT_EQ(pdf.substr(table, 5), "xref\n");
  const int objects = std::atoi(pdf.c_str() + table + 7);
  ASSERT_GT(objects, 7);
  for (int i = 1; i < objects; ++i) {
    // Each line of the table has 20 bytes; it follows "xref", the counts and object 0.
    const std::size_t line = pdf.find('\n', table + 5) + 1 + 20 * static_cast<std::size_t>(i);
    const auto place = static_cast<std::size_t>(std::atol(pdf.c_str() + line));
    EXPECT_EQ(pdf.substr(place, 8).find(std::to_string(i) + " 0 obj"), 0U) << i;
  }
}

TEST(ReportPdf, WidthsAreThoseOfHelvetica) {
  EXPECT_DOUBLE_EQ(helvetica_width("Wi~"), 0.944 + 0.222 + 0.584);
  EXPECT_DOUBLE_EQ(helvetica_width("\xc3\xa9"), 0.556);
}

TEST(ReportNumber, HasThreeDigitsOrMore) {
  EXPECT_EQ(report_number(0.12345), "0.123");
  EXPECT_EQ(report_number(-0.0001), "0.000");
  EXPECT_EQ(report_number(-3.14159), "-3.14");
  EXPECT_EQ(report_number(31.4159), "31.4");
  EXPECT_EQ(report_number(314.159), "314");
}

}  // namespace
}  // namespace felt::study_report_test
