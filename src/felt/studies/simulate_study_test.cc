#include "felt/studies/simulate_study.h"

#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <map>
#include <utility>

#include "felt/base/read_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/replay/apply_recording.h"
#include "felt/session/session.h"
#include "felt/store/felt_file.h"
#include "felt/studies/measured_trial.h"
#include "felt/studies/simulated_trial.h"
#include "felt/studies/testing/study_fixture.h"

namespace felt::simulate_study_test {
namespace {

using ::testing::HasSubstr;

SimulateOptions options(std::size_t people = 2, const char* device = "premium") {
  return {.people = people, .seed = 1, .device = *find_stylus_preset(device), .program = "test 1"};
}

class SimulateStudyTest : public felt::testing::StudyFixture {
 protected:
  StudyFolder simulate(const std::string& name, const SimulateOptions& with) const {
    StudyFolder folder = StudyFolder::create(path(name), small_study()).value();
    const Result<void> done = simulate_study(folder, with);
    EXPECT_TRUE(done) << done.error().message;
    return folder;
  }
};

TEST_F(SimulateStudyTest, EveryPersonDrawsEveryTrial) {
  const StudyFolder folder = simulate("out", options());
  const std::vector<StudySession> sessions = folder.sessions().value();
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_NE(sessions[0].info.person_seed, sessions[1].info.person_seed);
  EXPECT_EQ(sessions[0].info.device, "simulated premium");
  EXPECT_EQ(sessions[0].info.started, "");
  for (const StudySession& session : sessions) {
    ASSERT_EQ(session.results.size(), session.plan.size());
    for (const TrialResult& result : session.results) {
      EXPECT_EQ(result.invalid, "");
      const auto recording = folder.recording(session.info, result).value();
      const PlannedTrial& trial = session.plan[static_cast<std::size_t>(result.trial - 1)];
      const TrialMetrics metrics =
          measure_recorded_trial(folder.files(), trial, trial_samples(recording));
      EXPECT_LT(*metrics.err_mean_mm, 3.0);
      const StudyForces forces = folder.files().study.conditions[trial.condition].forces;
      EXPECT_GT(*metrics.coverage, 0.6);  // also with a towed nib, for which people plan ahead
      EXPECT_EQ(*metrics.force_mean_n > 0.0, forces == StudyForces::kAll);
    }
  }
}

TEST_F(SimulateStudyTest, AnInterruptedSimulationIsContinuedToTheSameFiles) {
  simulate("whole", options());
  StudyFolder folder = StudyFolder::create(path("parts"), small_study()).value();
  int trials = 0;
  for (bool goes_on = true; goes_on;) {  // each run ends after two trials more
    const int before = trials;
    int seen = 0;
    ASSERT_TRUE(simulate_study(folder, options(), [&](double) { return ++seen < before + 2; }));
    trials = 0;
    const std::vector<StudySession> sessions = folder.sessions().value();
    for (const StudySession& session : sessions) {
      trials += static_cast<int>(session.results.size());
    }
    goes_on = trials > before;
  }
  const StudyFolder whole = StudyFolder::open(path("whole")).value();
  const std::vector<StudySession> wanted = whole.sessions().value();
  EXPECT_EQ(folder.sessions().value(), wanted);
  for (const StudySession& session : wanted) {
    for (const TrialResult& result : session.results) {
      EXPECT_EQ(read_regular_file(folder.file_of(session.info, result.recording), 1 << 24).value(),
                read_regular_file(whole.file_of(session.info, result.recording), 1 << 24).value());
    }
  }
}

TEST_F(SimulateStudyTest, EqualConditionsGiveEqualInk) {
  write("equal.toml", R"(id = "equal"
repetitions = 2
[[condition]]
name = "a"
settings = { "pencil.strength" = 0.5 }
[[condition]]
name = "b"
settings = { "pencil.strength" = 0.5 }
[[condition]]
name = "c"
settings = { "pencil.strength" = 0.9 }
[[shape]]
name = "line"
kind = "line"
size_mm = 30
)");
  StudyFolder folder =
      StudyFolder::create(path("out"), read_study_files(path("equal.toml")).value()).value();
  ASSERT_TRUE(simulate_study(folder, options(1)));
  const StudySession session = folder.sessions().value().at(0);
  std::map<std::pair<std::size_t, int>, double> error_mm;  // by condition and repetition
  for (const TrialResult& result : session.results) {
    const PlannedTrial& trial = session.plan[static_cast<std::size_t>(result.trial - 1)];
    if (trial.is_practice) continue;
    const auto recording = folder.recording(session.info, result).value();
    error_mm[{trial.condition, trial.repetition}] =
        *measure_recorded_trial(folder.files(), trial, trial_samples(recording)).err_mean_mm;
  }
  ASSERT_EQ(error_mm.size(), 6U);
  for (const int repetition : {1, 2}) {
    EXPECT_EQ((error_mm[{0, repetition}]), (error_mm[{1, repetition}]));
    EXPECT_NE((error_mm[{0, repetition}]), (error_mm[{2, repetition}]));
  }
  EXPECT_NE((error_mm[{0, 1}]), (error_mm[{0, 2}])) << "repetitions differ";
}

TEST_F(SimulateStudyTest, PeopleCarryOutTheTasksOfEditing) {
  write("tasks.toml", R"(id = "tasks"
[[condition]]
name = "plane"
forces = "plane"
[[condition]]
name = "all"
[[shape]]
name = "over"
kind = "wave"
task = "retrace"
[[shape]]
name = "around"
kind = "circle"
size_mm = 30
task = "close"
[[shape]]
name = "broad"
kind = "line"
task = "width"
width_mm = 3
[[shape]]
name = "rub"
kind = "line"
size_mm = 90
task = "erase"
)");
  StudyFolder folder =
      StudyFolder::create(path("out"), read_study_files(path("tasks.toml")).value()).value();
  ASSERT_TRUE(simulate_study(folder, options(2)));
  std::map<StudyTask, std::array<TrialMetrics, 2>> sums;  // without and with the forces
  const std::vector<StudySession> sessions = folder.sessions().value();
  for (const StudySession& session : sessions) {
    for (const TrialResult& result : session.results) {
      const PlannedTrial& trial = session.plan[static_cast<std::size_t>(result.trial - 1)];
      std::string bytes;
      const auto recording = folder.recording(session.info, result, &bytes).value();
      const Drawing drawing = parse_felt(bytes).value();
      Session replayed(make_tools(), {});
      ASSERT_TRUE(apply_recording(drawing, {}, replayed));
      EXPECT_EQ(visible_strokes(replayed.document()).size(),
                visible_strokes(drawing.document).size())
          << "the recording has the ink at the start";
      const TrialMetrics metrics =
          measure_recorded_trial(folder.files(), trial, trial_samples(recording), drawing.document);
      const StudyTask task = folder.files().study.shapes[trial.shape].task;
      EXPECT_EQ(metrics.is_closed.has_value(), task == StudyTask::kClose);
      EXPECT_EQ(metrics.width_cv.has_value(), task == StudyTask::kWidth);
      EXPECT_EQ(metrics.erased_left_mm.has_value(), task == StudyTask::kErase);
      EXPECT_EQ(metrics.err_mean_mm.has_value(), task != StudyTask::kErase);
      if (task == StudyTask::kClose) {
        EXPECT_EQ(metrics.is_closed, 1.0);
      }
      if (task == StudyTask::kWidth) {
        EXPECT_NEAR(*metrics.width_mean_mm, 3.0, 0.3);
      }
      if (task == StudyTask::kErase) {
        EXPECT_LT(*metrics.erased_left_mm, 5.0);
      }
      TrialMetrics& sum = sums[task][trial.condition];
      sum.err_mean_mm = sum.err_mean_mm.value_or(0.0) + metrics.err_mean_mm.value_or(0.0);
      sum.erased_extra_mm =
          sum.erased_extra_mm.value_or(0.0) + metrics.erased_extra_mm.value_or(0.0);
    }
  }
  const auto& over = sums[StudyTask::kRetrace];
  EXPECT_LT(*over[1].err_mean_mm, 0.9 * *over[0].err_mean_mm) << "the line of ink is felt";
  const auto& rub = sums[StudyTask::kErase];
  EXPECT_LE(*rub[1].erased_extra_mm, *rub[0].erased_extra_mm) << "other lines push the eraser away";
}

TEST_F(SimulateStudyTest, TheBaselinesAreWhatTheirNamesSay) {
  write("base.toml", R"(id = "base"
[[condition]]
name = "air"
forces = "air"
[[condition]]
name = "plane"
forces = "plane"
[[condition]]
name = "weak"
settings = { "pencil.strength" = 0 }
[[condition]]
name = "default"
[[shape]]
name = "line"
kind = "line"
size_mm = 100
)");
  const StudyFiles files = read_study_files(path("base.toml")).value();
  const auto metrics = [&files](std::size_t condition, const Person& person) {
    const PlannedTrial trial{.condition = condition, .shape = 0};
    const auto drawn = simulate_trial(files, trial, person, *find_stylus_preset("premium"));
    return drawn.value().back().metrics;
  };
  for (const Person& person : population(4, 3, PersonModel::kResting)) {
    const TrialMetrics air = metrics(0, person), plane = metrics(1, person);
    const TrialMetrics weak = metrics(2, person), usual = metrics(3, person);
    EXPECT_EQ(air.force_mean_n, 0.0);
    EXPECT_EQ(plane.force_mean_n, 0.0) << "along the surface";
    EXPECT_GT(*usual.force_mean_n, 0.0);
    EXPECT_GT(*air.coverage, 0.9) << "the depth of the pen draws";
    EXPECT_GT(*air.err_total_mm, 1.2 * *plane.err_total_mm);
    EXPECT_LT(*air.movement_s, 0.95 * *plane.movement_s);
    EXPECT_NEAR(*weak.err_mean_mm, *plane.err_mean_mm, 0.01 * *plane.err_mean_mm);
    EXPECT_NE(usual.err_mean_mm, plane.err_mean_mm);
  }
}

TEST_F(SimulateStudyTest, OtherPeopleDoNotContinueAFolder) {
  StudyFolder folder = simulate("out", options(1));
  SimulateOptions others = options(1);
  others.seed = 2;
  const Result<void> done = simulate_study(folder, others);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("participant 1 is someone else there"));
  others = options(1);
  others.model = PersonModel::kUnsteady;
  const Result<void> in_other_model = simulate_study(folder, others);
  ASSERT_FALSE(in_other_model);
  EXPECT_THAT(in_other_model.error().message, HasSubstr("another seed, model,"));
}

TEST_F(SimulateStudyTest, ARecordingGivesTheSameDrawing) {
  const StudyFolder folder = simulate("out", options(1));
  const StudySession session = folder.sessions().value().at(0);
  for (const TrialResult& result : session.results) {
    const Drawing drawing = read_felt(folder.file_of(session.info, result.recording)).value();
    EXPECT_EQ(drawing.document.stroke_count(), 1U);
    Session played(make_tools(), {});
    ASSERT_TRUE(apply_recording(drawing, {}, played));
    EXPECT_EQ(played.document(), drawing.document) << result.recording;
  }
}

TEST_F(SimulateStudyTest, TheSameOptionsGiveTheSameBytes) {
  const StudyFolder a = simulate("a", options()), b = simulate("b", options());
  SimulateOptions other = options();
  other.seed = 2;
  const StudyFolder c = simulate("c", other);
  int files = 0, changed = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(a.path())) {
    if (!entry.is_regular_file()) continue;
    const std::string name = entry.path().string().substr(a.path().size());
    const std::string bytes = read_file(entry.path(), 1 << 24).value();
    EXPECT_EQ(bytes, read_file(b.path() + name, 1 << 24).value()) << name;
    if (name.ends_with(".felt")) ++files;
    if (name.ends_with(".felt")) changed += bytes != read_file(c.path() + name, 1 << 24).value();
  }
  EXPECT_EQ(files, 8);
  EXPECT_EQ(changed, 8) << "other people draw other lines";
}

TEST_F(SimulateStudyTest, EndsEarlyAndKeepsWhatIsFinished) {
  StudyFolder folder = StudyFolder::create(path("out"), small_study()).value();
  double last = 0.0;
  const auto progress = [&last](double share) {
    EXPECT_GT(share, last);
    last = share;
    return share < 0.6;
  };
  EXPECT_TRUE(simulate_study(folder, options(), progress));
  EXPECT_DOUBLE_EQ(last, 0.625) << "five of eight trials";
  const std::vector<StudySession> sessions = folder.sessions().value();
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[0].results.size(), 4U);
  EXPECT_EQ(sessions[1].results.size(), 1U);
}

TEST_F(SimulateStudyTest, RepeatsAnInvalidTrialWithOtherNoise) {
  std::string text = felt::testing::kSmallStudy;
  text.replace(text.find("min_length_share = 0.5"), 22, "max_mm_per_s = 1");  // nobody is so slow
  write("slow.toml", text);
  StudyFolder folder =
      StudyFolder::create(path("out"), read_study_files(path("slow.toml")).value()).value();
  ASSERT_TRUE(simulate_study(folder, options(1)));
  const StudySession session = folder.sessions().value().at(0);
  ASSERT_EQ(session.results.size(), 3 * session.plan.size()) << "two repeats";
  EXPECT_EQ(session.results[0].invalid, "max_mm_per_s");
  EXPECT_EQ(session.results[2].attempt, 3);
  EXPECT_NE(folder.recording(session.info, session.results[0]).value(),
            folder.recording(session.info, session.results[1]).value());
}

TEST_F(SimulateStudyTest, RefusesAConditionThatTheDeviceCannotMake) {
  StudyFolder folder = StudyFolder::create(path("out"), small_study()).value();
  const Result<void> done = simulate_study(folder, options(1, "mouse"));
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("condition.needs"));
  EXPECT_FALSE(simulate_study(folder, options(0)));
  EXPECT_FALSE(simulate_study(folder, options(10'000)));
  EXPECT_TRUE(folder.sessions().value().empty());
}

}  // namespace
}  // namespace felt::simulate_study_test
