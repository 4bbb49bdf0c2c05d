#include "felt/studies/export/preregistration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/studies/export/data_table.h"
#include "felt/studies/export/testing/paired_study.h"
#include "felt/trial/study_file.h"

namespace felt::preregistration_test {
namespace {

using ::testing::HasSubstr;

StudyFiles files_with(const std::string& top) {
  const std::string text = testing::paired_study_text();
  StudyFiles files;
  files.study = read_study(top + text, "s.toml").value();
  files.sources = {{"s.toml", top + text}};
  return files;
}

TEST(Preregistration, R75_HasHypothesesNumberExclusionsAndFingerprint) {
  StudyFiles files = files_with(
      "order = \"balanced-latin-square\"\ncatch = { max_lifts = 3, min_length_share = 0.5 }\n");
  const std::string text = preregistration_text(files, 10, "feltline 1.2").value();
  EXPECT_THAT(text, HasSubstr("* H1: err_mean_mm is smaller in \"Default\" than in \"Air\""));
  EXPECT_THAT(text, HasSubstr("* H4: err_mean_mm in \"Default\" is less than 15 % larger"));
  EXPECT_THAT(text, HasSubstr("10 participants"));
  EXPECT_THAT(text, HasSubstr("10 is not a multiple of 4"));
  EXPECT_THAT(text, HasSubstr("shorter than 50 % of the shape"));
  EXPECT_THAT(text, HasSubstr("lifted more than 3 times"));
  EXPECT_THAT(text, HasSubstr("over all 4 of them"));
  EXPECT_THAT(text, HasSubstr("Program: feltline 1.2."));
  // The fingerprint is that of trials.csv, where the study has the name study.toml.
  files.sources[0].first = "study.toml";
  EXPECT_THAT(text, HasSubstr(study_hash(files)));
  EXPECT_EQ(text, preregistration_text(files, 10, "feltline 1.2").value());
}

TEST(Preregistration, R75_SaysWhatTheNumberOfPeopleCanShow) {
  // The exact power with 8 people and an SD of 0.13 is 0.86 for -15 %, and 0.80 for -13.6 %.
  const std::string text = preregistration_text(files_with(""), 8, "feltline").value();
  EXPECT_THAT(text, HasSubstr("13.9 % smaller with an SD of 0.13"));
}

TEST(Preregistration, FailsWithoutHypothesesOrPeople) {
  StudyFiles files = files_with("");
  EXPECT_THAT(preregistration_text(files, 1, "f").error().message, HasSubstr("people is 1"));
  files.study.hypotheses.clear();
  EXPECT_THAT(preregistration_text(files, 8, "f").error().message,
              HasSubstr("the study has no hypothesis"));
}

}  // namespace
}  // namespace felt::preregistration_test
