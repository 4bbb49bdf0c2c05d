#include "felt/trial/study_hypothesis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/trial/study_file.h"

namespace felt::study_hypothesis_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kTop = R"(id = "s"
sessions = ["pre", "train"]
[[condition]]
name = "air"
[[condition]]
name = "all-forces"
[[condition]]
name = "late"
sessions = ["train"]
[[shape]]
name = "line"
kind = "line"
)";

std::string text_with(const std::string& hypothesis) {
  return std::string(kTop) + "[[hypothesis]]\n" + hypothesis + "\n";
}

std::string error_of(const std::string& hypothesis) {
  const Result<Study> study = read_study(text_with(hypothesis), "s.toml");
  return study ? "none" : study.error().message;
}

constexpr const char* kLess =
    "condition = \"all-forces\"\nagainst = \"air\"\nmeasure = \"err_mean_mm\"\n";

TEST(StudyHypothesis, R75_IsReadWithItsDefaults) {
  const Result<Study> study =
      read_study(text_with(kLess) + "[[hypothesis]]\ncondition = \"late\"\nagainst = \"air\"\n" +
                     "measure = \"movement_s\"\nkind = \"not-worse\"\nmargin = 0.15\n",
                 "s.toml");
  ASSERT_TRUE(study) << study.error().message;
  ASSERT_EQ(study->hypotheses.size(), 2U);
  const StudyHypothesis first = {
      .condition = "all-forces", .against = "air", .measure = "err_mean_mm", .line = 14};
  EXPECT_TRUE(study->hypotheses[0] == first);
  EXPECT_EQ(study->hypotheses[1].kind, HypothesisKind::kNotWorse);
  EXPECT_EQ(study->hypotheses[1].margin, 0.15);
  EXPECT_EQ(hypothesis_session(*study, study->hypotheses[0]), SessionKind::kPre);
  EXPECT_EQ(hypothesis_session(*study, study->hypotheses[1]), SessionKind::kTrain);
  EXPECT_EQ(hypothesis_text(*study, study->hypotheses[0]),
            "err_mean_mm is smaller in \"All forces\" than in \"Air\"");
  EXPECT_EQ(hypothesis_text(*study, study->hypotheses[1]),
            "movement_s in \"Late\" is less than 15 % larger than in \"Air\"");
}

TEST(StudyHypothesis, R75_TheTextHasTheMarginThatIsTested) {
  for (const auto& [margin, percent] : {std::pair{"0.125", "12.5"},
                                        {"0.015", "1.5"},
                                        {"0.07", "7"},
                                        {"0.29", "29"},
                                        {"1", "100"}}) {
    const Result<Study> study = read_study(
        text_with(std::string(kLess) + "kind = \"not-worse\"\nmargin = " + margin), "s.toml");
    ASSERT_TRUE(study) << study.error().message;
    EXPECT_EQ(hypothesis_text(*study, study->hypotheses[0]),
              "err_mean_mm in \"All forces\" is less than " + std::string(percent) +
                  " % larger than in \"Air\"");
  }
}

TEST(StudyHypothesis, R75_ProblemsNameLineAndReason) {
  EXPECT_EQ(error_of("condition = \"air\"\nmeasure = \"err_mean_mm\""),
            "s.toml:14: hypothesis.against is missing; it must be the name of a condition");
  EXPECT_EQ(error_of("condition = \"air\"\nagainst = \"wind\"\nmeasure = \"err_mean_mm\""),
            "s.toml:15: hypothesis.against is wind, it must be the name of a condition: air, "
            "all-forces, late");
  EXPECT_EQ(error_of("condition = \"air\"\nagainst = \"air\"\nmeasure = \"err_mean_mm\""),
            "s.toml:15: hypothesis.against is \"air\", it must be another condition than "
            "hypothesis.condition");
  EXPECT_EQ(error_of("condition = \"late\"\nagainst = \"air\""),
            "s.toml:14: hypothesis.measure is missing; it must be a metric of trials.csv, such as "
            "err_total_mm");
  EXPECT_THAT(error_of("condition = \"late\"\nagainst = \"air\"\nmeasure = \"error\""),
              HasSubstr("s.toml:16: hypothesis.measure is error, it must be a metric of "
                        "trials.csv: samples, "));
  for (const std::string measure : {"sparc", "is_closed", "err_signed_mm", "coverage"}) {
    EXPECT_EQ(error_of("condition = \"late\"\nagainst = \"air\"\nmeasure = \"" + measure + "\""),
              "s.toml:16: hypothesis.measure is " + measure +
                  ", which may be negative, or of which more is better");
  }
  EXPECT_EQ(error_of(std::string(kLess) + "kind = \"same\""),
            "s.toml:17: hypothesis.margin is missing; the kind same requires it, 0.01 to 1");
  EXPECT_EQ(error_of(std::string(kLess) + "margin = 0.1"),
            "s.toml:17: hypothesis.margin has no effect with the kind less");
  EXPECT_EQ(error_of("condition = \"late\"\nagainst = \"air\"\nmeasure = \"err_mean_mm\"\n"
                     "session = \"pre\""),
            "s.toml:17: hypothesis.session is \"pre\", it must be a session of the study that has "
            "both conditions");
  EXPECT_EQ(error_of(std::string(kLess) + "[[hypothesis]]\n" + kLess),
            "s.toml:18: hypothesis is the same as the one in line 14");
  EXPECT_THAT(error_of(std::string(kLess) + "name = \"x\""),
              HasSubstr("hypothesis.name is unknown; [[hypothesis]] has condition, against"));
}

TEST(StudyHypothesis, AtMostTwentyAndInTheRightForm) {
  std::string many = kLess;
  for (std::size_t i = 0; i < kMaxStudyHypotheses; ++i)
    many += "[[hypothesis]]\n" + std::string(kLess);
  bool is_reported = false;
  for (const Error& error : study_problems(text_with(many), "s.toml")) {
    is_reported |= error.message.find("a study has at most 20 of them") != std::string::npos;
  }
  EXPECT_TRUE(is_reported);
  EXPECT_THAT(
      study_problems(std::string(kTop) + "[hypothesis]\ncondition = \"air\"\n", "s")[0].message,
      HasSubstr("hypothesis must be written as [[hypothesis]]"));
  EXPECT_THAT(error_of(""), HasSubstr("hypothesis.condition is missing"));
}

}  // namespace
}  // namespace felt::study_hypothesis_test
