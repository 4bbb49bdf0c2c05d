#include "felt/trial/study_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace felt::study_order_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Study study_with(std::size_t conditions, std::size_t shapes, StudyOrder order) {
  Study study;
  study.id = "test";
  study.order = order;
  for (std::size_t i = 0; i < conditions; ++i) {
    const std::string name = "condition-" + std::to_string(i);
    study.conditions.push_back({.name = name, .label = name});
  }
  for (std::size_t i = 0; i < shapes; ++i) {
    study.shapes.push_back({.name = "shape-" + std::to_string(i)});
  }
  return study;
}

std::vector<PlannedTrial> plan(const Study& study, int participant,
                               SessionKind session = SessionKind::kTrain) {
  return plan_trials(study, participant, session).value();
}

/// Returns the conditions of a block, each visit once.
std::vector<std::size_t> conditions_of(const std::vector<PlannedTrial>& trials, int block) {
  std::vector<std::size_t> order;
  for (const PlannedTrial& trial : trials) {
    if (trial.block == block && (order.empty() || order.back() != trial.condition)) {
      order.push_back(trial.condition);
    }
  }
  return order;
}

TEST(StudyOrder, IsThatOfWilliamsForFour) {
  EXPECT_EQ(williams_rows(4), 4u);
  EXPECT_THAT(williams_row(4, 0), ElementsAre(0, 1, 3, 2));
  EXPECT_THAT(williams_row(4, 1), ElementsAre(1, 2, 0, 3));
  EXPECT_EQ(williams_row(4, 5), williams_row(4, 1));
}

TEST(StudyOrder, HasTwoSquaresForThree) {
  EXPECT_EQ(williams_rows(3), 6u);
  EXPECT_THAT(williams_row(3, 0), ElementsAre(0, 1, 2));
  EXPECT_THAT(williams_row(3, 3), ElementsAre(2, 1, 0));
}

// A design of Williams for 2 to 8 conditions: in all rows together, each condition is equally often
// in each position, and each one comes equally often directly after each other one: once if the
// number is even, twice in the two squares of an odd number.
TEST(StudyOrder, R75_IsBalancedForFirstOrderCarryOverFromTwoToEight) {
  for (std::size_t count = 2; count <= 8; ++count) {
    const std::size_t squares = count % 2 == 0 ? 1 : 2;
    ASSERT_EQ(williams_rows(count), squares * count);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> in_position, after;
    for (std::size_t row = 0; row < williams_rows(count); ++row) {
      const std::vector<std::size_t> order = williams_row(count, row);
      ASSERT_EQ(order.size(), count);
      for (std::size_t i = 0; i < count; ++i) {
        ++in_position[{order[i], i}];
        if (i > 0) ++after[{order[i - 1], order[i]}];
      }
    }
    EXPECT_EQ(in_position.size(), count * count) << count;
    for (const auto& [pair, times] : in_position) EXPECT_EQ(times, squares) << count;
    EXPECT_EQ(after.size(), count * (count - 1)) << count;
    for (const auto& [pair, times] : after) EXPECT_EQ(times, squares) << count;
  }
}

TEST(StudyOrder, BalancesPositionsAndNeighboursInEveryBlockOfAFullDesign) {
  for (std::size_t count = 1; count <= 11; ++count) {
    Study study = study_with(count, 2, StudyOrder::kBalancedLatinSquare);
    study.blocks = 3;
    study.sessions = {SessionKind::kPre, SessionKind::kPost};
    const auto rows = static_cast<int>(williams_rows(count));
    for (int block = 1; block <= 3; ++block) {
      std::map<std::pair<std::size_t, std::size_t>, int> at, next_to;
      for (int participant = 1; participant <= rows; ++participant) {
        const auto order = conditions_of(plan(study, participant, SessionKind::kPost), block);
        ASSERT_EQ(order.size(), count);
        for (std::size_t i = 0; i < count; ++i) ++at[{order[i], i}];
        for (std::size_t i = 1; i < count; ++i) ++next_to[{order[i - 1], order[i]}];
      }
      const int each = rows / static_cast<int>(count);
      EXPECT_EQ(at.size(), count * count);
      EXPECT_EQ(next_to.size(), count * (count - 1));
      for (const auto& [pair, times] : at) EXPECT_EQ(times, each);
      for (const auto& [pair, times] : next_to) EXPECT_EQ(times, each);
    }
  }
}

RC_GTEST_PROP(StudyOrder, HasEveryTrialOnceAndIsAlwaysTheSame, ()) {
  Study study =
      study_with(*rc::gen::inRange<std::size_t>(1, 8), *rc::gen::inRange<std::size_t>(1, 6),
                 static_cast<StudyOrder>(*rc::gen::inRange(0, 3)));
  study.shape_order = static_cast<StudyOrder>(*rc::gen::inRange(0, 3));
  study.seed = *rc::gen::arbitrary<std::uint32_t>();
  study.blocks = *rc::gen::inRange(1, 4);
  study.repetitions = *rc::gen::inRange(1, 4);
  study.practice_trials = *rc::gen::inRange(0, 4);
  const int participant = *rc::gen::inRange(1, kMaxParticipants + 1);
  const std::vector<PlannedTrial> trials = plan(study, participant);
  RC_ASSERT(trials == plan(study, participant));
  RC_ASSERT(trials.size() == trial_count(study, SessionKind::kTrain));

  std::set<std::tuple<int, std::size_t, std::size_t, int>> counted;
  std::set<std::uint64_t> seeds;
  std::size_t practice = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const PlannedTrial& trial = trials[i];
    RC_ASSERT(trial.number == static_cast<int>(i) + 1);
    RC_ASSERT(trial.is_practice == (trial.block == 0));
    if (i > 0) RC_ASSERT(trials[i - 1].block <= trial.block);  // RC_ASSERT evaluates all of a || b
    seeds.insert(trial.seed);
    if (trial.is_practice) {
      ++practice;
    } else {
      counted.insert({trial.block, trial.condition, trial.shape, trial.repetition});
    }
  }
  RC_ASSERT(seeds.size() == trials.size());
  RC_ASSERT(practice + counted.size() == trials.size());
}

TEST(StudyOrder, OfASequentialStudyIsThatOfTheFile) {
  Study study = study_with(2, 2, StudyOrder::kSequential);
  study.repetitions = 2;
  std::vector<std::size_t> conditions, shapes;
  for (const PlannedTrial& trial : plan(study, 3)) {
    conditions.push_back(trial.condition);
    shapes.push_back(trial.shape);
  }
  EXPECT_THAT(conditions, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
  EXPECT_THAT(shapes, ElementsAre(0, 1, 0, 1, 0, 1, 0, 1));
}

TEST(StudyOrder, DiffersBetweenParticipantsBlocksSessionsAndSeeds) {
  Study study = study_with(8, 1, StudyOrder::kRandom);
  study.blocks = 2;
  study.sessions = {SessionKind::kPre, SessionKind::kTrain};
  const auto order = conditions_of(plan(study, 1), 1);
  EXPECT_NE(order, conditions_of(plan(study, 1), 2));
  EXPECT_NE(order, conditions_of(plan(study, 2), 1));
  EXPECT_NE(order, conditions_of(plan(study, 1, SessionKind::kPre), 1));
  for (const StudyOrder kind : {StudyOrder::kRandom, StudyOrder::kBalancedLatinSquare}) {
    study.order = kind;
    study.seed = 1;
    const auto first = conditions_of(plan(study, 1), 1);
    study.seed = 2;
    EXPECT_NE(first, conditions_of(plan(study, 1), 1));
  }
}

TEST(StudyOrder, OfRandomConditionsHasEachOneInEachPosition) {
  const Study study = study_with(4, 1, StudyOrder::kRandom);
  std::map<std::pair<std::size_t, std::size_t>, int> at;
  for (int participant = 1; participant <= 4000; ++participant) {
    const auto order = conditions_of(plan(study, participant), 1);
    for (std::size_t i = 0; i < order.size(); ++i) ++at[{order[i], i}];
  }
  // 1000 are expected, with a standard deviation of 27.
  for (const auto& [pair, times] : at) EXPECT_NEAR(times, 1000, 140);
}

// A fingerprint of one plan: a change would give participants of a running study another order.
TEST(StudyOrder, StaysTheSameInLaterVersions) {
  const auto order = conditions_of(plan(study_with(6, 1, StudyOrder::kRandom), 1), 1);
  const auto square = conditions_of(plan(study_with(6, 1, StudyOrder::kBalancedLatinSquare), 1), 1);
  EXPECT_THAT(order, ElementsAre(1, 4, 2, 3, 5, 0));
  EXPECT_THAT(square, ElementsAre(2, 3, 5, 0, 1, 4));
}

TEST(StudyOrder, HidesTheNamesOfABlindStudy) {
  Study study = study_with(3, 2, StudyOrder::kSequential);
  EXPECT_EQ(plan(study, 1).front().shown_condition, "condition-0");
  study.is_blind = true;
  study.sessions = {SessionKind::kPre, SessionKind::kPost};
  std::set<std::vector<std::string>> all;
  for (int participant = 1; participant <= 60; ++participant) {
    std::vector<std::string> labels = blind_labels(study, participant);
    for (const SessionKind session : study.sessions) {
      for (const PlannedTrial& trial : plan(study, participant, session)) {
        EXPECT_EQ(trial.shown_condition, labels[trial.condition]);
      }
    }
    all.insert(labels);
    std::sort(labels.begin(), labels.end());
    EXPECT_THAT(labels, ElementsAre("A", "B", "C"));
  }
  EXPECT_EQ(all.size(), 6u);
}

TEST(StudyOrder, HasOnlyTheConditionsAndShapesOfTheSession) {
  Study study = study_with(3, 2, StudyOrder::kBalancedLatinSquare);
  study.sessions = {SessionKind::kTrain, SessionKind::kTransfer};
  study.conditions[1].sessions = {SessionKind::kTrain};
  study.shapes[0].sessions = {SessionKind::kTrain};
  for (const PlannedTrial& trial : plan(study, 1, SessionKind::kTransfer)) {
    EXPECT_NE(trial.condition, 1u);
    EXPECT_EQ(trial.shape, 1u);
  }
  EXPECT_EQ(plan(study, 1, SessionKind::kTransfer).size(), 2u);
  EXPECT_EQ(plan(study, 1, SessionKind::kTrain).size(), 6u);
}

TEST(StudyOrder, RestsBetweenBlocksAndAfterManyTrials) {
  Study study = study_with(1, 5, StudyOrder::kSequential);
  study.blocks = 2;
  study.practice_trials = 1;
  study.rest_s = 30.0;
  const auto rests_of = [](const std::vector<PlannedTrial>& trials) {
    std::vector<int> rests;
    for (const PlannedTrial& trial : trials) {
      if (trial.rest_before_s == 30.0) rests.push_back(trial.number);
    }
    return rests;
  };
  EXPECT_THAT(rests_of(plan(study, 1)), ElementsAre(2, 7));
  study.rest_after_trials = 3;
  EXPECT_THAT(rests_of(plan(study, 1)), ElementsAre(2, 5, 7, 10));
}

TEST(StudyOrder, AsksQuestionsAfterEachConditionOrAfterTheSession) {
  Study study = study_with(2, 2, StudyOrder::kSequential);
  study.blocks = 2;
  const auto asked_in = [&study] {
    std::vector<int> asked;
    for (const PlannedTrial& trial : plan(study, 1)) {
      if (trial.asks_questions) asked.push_back(trial.number);
    }
    return asked;
  };
  EXPECT_THAT(asked_in(), ElementsAre());
  study.questionnaires = {Questionnaire::kUeqS};
  EXPECT_THAT(asked_in(), ElementsAre(6, 8));
  study.question_time = QuestionTime::kSession;
  EXPECT_THAT(asked_in(), ElementsAre(8));
}

TEST(StudyOrder, FailsForParticipantsAndSessionsThatDoNotExist) {
  Study study = study_with(2, 2, StudyOrder::kSequential);
  for (const int participant : {-1, 0, kMaxParticipants + 1}) {
    EXPECT_THAT(plan_trials(study, participant, SessionKind::kTrain).error().message,
                HasSubstr("it must be 1 to 9999"));
  }
  EXPECT_EQ(plan_trials(study, 1, SessionKind::kPost).error().message,
            "the study has no session \"post\"; it has train");
  study.shapes.clear();
  EXPECT_THAT(plan_trials(study, 1, SessionKind::kTrain).error().message, HasSubstr("no trials"));
  study = study_with(26, 100, StudyOrder::kSequential);
  EXPECT_EQ(plan_trials(study, 1, SessionKind::kTrain).error().code, ErrorCode::kLimitExceeded);
}

}  // namespace
}  // namespace felt::study_order_test
