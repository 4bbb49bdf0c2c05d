#include "felt/studies/study_folder.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "felt/base/read_file.h"
#include "felt/studies/measured_trial.h"
#include "felt/studies/session_file.h"
#include "felt/studies/testing/study_fixture.h"
#include "felt/studies/trial_setup.h"
#include "felt/trial/study_file.h"

namespace felt::study_folder_test {
namespace {

using ::testing::HasSubstr;

SessionInfo simulated(int participant) {
  return {.participant = participant,
          .session = SessionKind::kTrain,
          .device = "simulated premium",
          .program = "feltline 9.9",
          .person_seed = 18'446'744'073'709'551'615ULL,
          .person_model = "resting"};
}

Drawing recorded_drawing(double x) {
  FeltRecording recording;
  recording.device = "test";
  RecordedSample sample;
  sample.pen.position = {x, 5.0, -0.1};
  recording.samples.push_back(sample);
  Drawing drawing;
  EXPECT_TRUE(add_recording(drawing, recording));
  return drawing;
}

TrialResult result_of(int trial, int attempt, const std::string& invalid = "") {
  TrialResult result;
  result.trial = trial;
  result.attempt = attempt;
  result.invalid = invalid;
  return result;
}

class StudyFolderTest : public felt::testing::StudyFixture {
 protected:
  StudyFolder folder() const { return StudyFolder::create(path("out"), small_study()).value(); }
  std::string session_file() const { return path("out/participant-0001/train/session.json"); }
  /// Replaces a part of session.json.
  void damage(const std::string& from, const std::string& to) const {
    std::string text = read_file(session_file(), kMaxSessionBytes).value();
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
    write("out/participant-0001/train/session.json", text);
  }
  /// Returns a folder with one session of two trials and an answer.
  StudyFolder filled() const {
    StudyFolder made = folder();
    StudySession session = made.begin_session(simulated(1)).value();
    EXPECT_TRUE(made.add_trial(session, result_of(1, 1, "max_lifts"), recorded_drawing(1.0)));
    EXPECT_TRUE(made.add_trial(session, result_of(1, 2), recorded_drawing(2.0)));
    EXPECT_TRUE(made.add_trial(session, result_of(2, 1), recorded_drawing(3.0)));
    EXPECT_TRUE(made.add_answers(session, {2, Questionnaire::kNasaTlx, {0, 20, 40, 60, 80, 100}}));
    return made;
  }
};

TEST_F(StudyFolderTest, KeepsTheStudyTheTrialsAndTheAnswers) {
  filled();
  EXPECT_EQ(read_file(path("out/study.toml"), 1 << 20).value(), felt::testing::kSmallStudy);
  const StudyFolder opened = StudyFolder::open(path("out")).value();
  EXPECT_EQ(opened.files().study, small_study().study);
  const std::vector<StudySession> sessions = opened.sessions().value();
  ASSERT_EQ(sessions.size(), 1U);
  EXPECT_EQ(sessions[0].info, simulated(1));
  EXPECT_EQ(sessions[0].plan, plan_trials(opened.files().study, 1, SessionKind::kTrain).value());
  ASSERT_EQ(sessions[0].results.size(), 3U);
  EXPECT_EQ(sessions[0].results[0].invalid, "max_lifts");
  EXPECT_EQ(sessions[0].results[1].recording, "trial-0001-2.felt");
  EXPECT_EQ(sessions[0].answers[0].values.back(), 100.0);
  const FeltRecording recording = opened.recording(simulated(1), sessions[0].results[1]).value();
  EXPECT_EQ(recording.samples.at(0).pen.position.x, 2.0);
}

TEST_F(StudyFolderTest, DoesNotUseAFolderThatHasFiles) {
  folder();
  const auto again = StudyFolder::create(path("out"), small_study());
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("out: exists and is not empty"));
  const auto other = StudyFolder::open(path(""));
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("not a folder with the results of a study"));
  EXPECT_FALSE(StudyFolder::create(path("no/such"), small_study()));
}

TEST_F(StudyFolderTest, ContinuesASession) {
  StudyFolder made = filled();
  SessionInfo later = simulated(1);
  later.device = "another";
  StudySession session = made.begin_session(later).value();
  EXPECT_EQ(session.info, simulated(1)) << "the device is that of the first call";
  EXPECT_EQ(session.results.size(), 3U);
  EXPECT_TRUE(made.add_trial(session, result_of(3, 1, "interrupted"), recorded_drawing(4.0)));
  EXPECT_EQ(made.sessions().value()[0], session);
}

TEST_F(StudyFolderTest, RefusesWhatDoesNotFitTheStudy) {
  StudyFolder made = filled();
  StudySession session = made.begin_session(simulated(1)).value();
  const StudySession before = session;
  const Drawing drawing = recorded_drawing(9.0);
  EXPECT_FALSE(made.add_trial(session, result_of(2, 1), drawing)) << "exists";
  EXPECT_FALSE(made.add_trial(session, result_of(5, 1), drawing)) << "is not planned";
  EXPECT_FALSE(made.add_trial(session, result_of(3, 2), drawing)) << "attempt 1 is missing";
  EXPECT_FALSE(made.add_trial(session, result_of(3, 1, "tired"), drawing)) << "unknown rule";
  EXPECT_FALSE(made.add_answers(session, {2, Questionnaire::kNasaTlx, {1, 1, 1, 1, 1, 1}}));
  EXPECT_FALSE(made.add_answers(session, {4, Questionnaire::kNasaTlx, {1, 1, 1, 1, 1}}));
  EXPECT_FALSE(made.add_answers(session, {4, Questionnaire::kNasaTlx, {1, 1, 1, 1, 1, 101}}));
  EXPECT_FALSE(made.add_answers(session, {4, Questionnaire::kNasaTlx, {1, 1, 1, 1, 1, 0.5}}));
  EXPECT_FALSE(made.add_answers(session, {3, Questionnaire::kUeqS, {1, 1, 1, 1, 1, 1, 1, 1}}));
  EXPECT_FALSE(made.add_answers(session, {4, Questionnaire::kUeqS, {1, 1, 1, 1, 1, 1, 1, 0}}));
  EXPECT_EQ(session, before);
  EXPECT_EQ(made.sessions().value()[0], before);
  EXPECT_FALSE(made.begin_session(simulated(0)));
  SessionInfo wrong = simulated(2);
  wrong.session = SessionKind::kPost;
  EXPECT_FALSE(made.begin_session(wrong));
  wrong = simulated(2);
  wrong.started = "yesterday";
  EXPECT_FALSE(made.begin_session(wrong));
  wrong.started = "2026-11-24T09:30:00Z";
  EXPECT_TRUE(made.begin_session(wrong));
  wrong.device = "two\nlines";
  wrong.participant = 3;
  EXPECT_FALSE(made.begin_session(wrong));
}

TEST_F(StudyFolderTest, ATrialNeedsASessionThatWasBegun) {
  StudyFolder made = folder();
  StudySession session = made.begin_session(simulated(1)).value();
  std::filesystem::remove_all(path("out/participant-0001"));
  const Result<void> added = made.add_trial(session, result_of(1, 1), recorded_drawing(1.0));
  ASSERT_FALSE(added);
  EXPECT_THAT(added.error().message, HasSubstr("was not begun"));
}

TEST_F(StudyFolderTest, OrdersSessionsByParticipant) {
  StudyFolder made = folder();
  for (const int participant : {12, 3, 9999}) {
    EXPECT_TRUE(made.begin_session(simulated(participant)));
  }
  std::filesystem::create_directory(path("out/participant-0005"));  // a crash before session.json
  const std::vector<StudySession> sessions = made.sessions().value();
  ASSERT_EQ(sessions.size(), 3U);
  EXPECT_EQ(sessions[0].info.participant, 3);
  EXPECT_EQ(sessions[2].info.participant, 9999);
  std::filesystem::create_directory(path("out/participant-12"));
  ASSERT_FALSE(made.sessions());
  EXPECT_THAT(made.sessions().error().message, HasSubstr("participant-12"));
}

TEST_F(StudyFolderTest, SaysWhereADamagedSessionIsWrong) {
  const std::vector<std::array<std::string, 3>> cases = {
      {"\"version\":1", "\"version\":2", "version 2 is not supported"},
      {"\"version\":1", "\"version\":1,\"version\":1", "key \"version\" occurs twice"},
      {"\"version\":1", "\"versions\":1", "key \"versions\" is unknown"},
      {"\"version\":1,", "", "key \"version\" is missing"},
      {"feltline-study-session", "other", "format is \"other\""},
      {"\"participant\":1", "\"participant\":2", "participant is 2"},
      {"\"participant\":1", "\"participant\":-1", "participant must be a whole number"},
      {"\"session\":\"train\"", "\"session\":\"post\"", "session is \"post\""},
      {"simulated premium", "two\\nlines", "device: not one line"},
      {"\"attempt\":2", "\"attempt\":1", "trial 1, attempt 1 occurs twice"},
      {"\"trial\":2", "\"trial\":2000000000", "trials[2]: trial must be a whole number"},
      {"\"trial\":2", "\"trial\":1e3", "trial must be a whole number"},
      {"\"attempt\":2", "\"attempt\":3", "trial 1, attempt 3 comes before"},
      {"\"free\"", "\"drag\"", "trials[0]: condition is \"drag\", it must be \"free\""},
      {"max_lifts", "boredom", "invalid: \"boredom\" is unknown"},
      {"trial-0002.felt", "../trial.felt", "it must be trial-0002.felt"},
      {"nasa-tlx", "tlx", "answers[0]: form \"tlx\" is unknown"},
      {"[0,20", "[NaN,20", "not JSON"},
      {"[0,20", "[\"0\",20", "values must be numbers"},
      {"[0,20", "[1e300,20", "whole numbers from 0 to 100"},
      {"[0,20", "[{},20", "values must be numbers"},
      {"[0,20,40,60,80,100]", "null", "values must be a list"},
      {"[0,20,", "[", "must be 6 whole numbers"},
      {"18446744073709551615", "18446744073709551616", ""},
      {"18446744073709551615", "null", "person_model belongs to a person_seed"},
      {"\"fingerprint\":\"fnv1a-", "\"fingerprint\":\"fnv1b-", "fingerprint must be"},
      {"\"resting\"", "\"dancing\"", "person_model is unknown"},
      {"null,\"person_seed\"", "\"2026\",\"person_seed\"", "started: \"2026\""}};
  for (const auto& [from, to, message] : cases) {
    std::filesystem::remove_all(path("out"));
    const StudyFolder made = filled();
    damage(from, to);
    const auto sessions = made.sessions();
    ASSERT_FALSE(sessions) << from << " -> " << to;
    EXPECT_THAT(sessions.error().message, HasSubstr(session_file() + ": "));
    EXPECT_THAT(sessions.error().message, HasSubstr(message)) << to;
  }
}

TEST_F(StudyFolderTest, ARecordingBelongsToItsTrial) {
  const StudyFolder made = filled();
  const std::vector<TrialResult> results = made.sessions().value()[0].results;
  const auto file = [&](std::size_t i) { return made.file_of(simulated(1), results[i].recording); };
  for (const TrialResult& result : results) EXPECT_TRUE(made.recording(simulated(1), result));
  std::filesystem::rename(file(0), path("first"));
  std::filesystem::rename(file(2), file(0));
  std::filesystem::rename(path("first"), file(2));
  for (const std::size_t i : {0U, 2U}) {
    const auto recording = made.recording(simulated(1), results[i]);
    ASSERT_FALSE(recording);
    EXPECT_THAT(recording.error().message, HasSubstr(file(i) + ": is not the recording of trial"));
  }
  EXPECT_TRUE(made.recording(simulated(1), results[1]));
}

TEST_F(StudyFolderTest, AFileOfAStudyIsARegularFile) {
  const StudyFolder made = filled();
  const TrialResult result = made.sessions().value()[0].results[0];
  const std::string file = made.file_of(simulated(1), result.recording);
  const auto expect_refused = [&] {
    const auto recording = made.recording(simulated(1), result);
    ASSERT_FALSE(recording);
    EXPECT_THAT(recording.error().message, HasSubstr(file + ": not a regular file"));
    std::filesystem::remove(file);
  };
  std::filesystem::remove(file);
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  expect_refused();
  std::filesystem::create_symlink("/dev/zero", file);
  expect_refused();
}

// A folder of before there were fingerprints: the options at the start of the recording count.
TEST_F(StudyFolderTest, AnOlderRecordingHasTheOptionsOfItsCondition) {
  StudyFolder made = folder();
  StudySession session = made.begin_session(simulated(1)).value();
  for (int trial = 1; trial <= 4; ++trial) {
    const PlannedTrial& planned = session.plan[static_cast<std::size_t>(trial - 1)];
    FeltRecording recording;
    for (const Event& event : setup_events(made.files(), planned, Capabilities())) {
      // A live pen hovers while the trial is set up.
      recording.samples.push_back({static_cast<std::int64_t>(recording.samples.size()),
                                   PenEvent{{0, 0, 5}, {}, 0, {}},
                                   {}});
      recording.events.push_back({recording.samples.size(), event});
    }
    recording.samples.push_back(
        {static_cast<std::int64_t>(recording.samples.size()), PenEvent{{0, 0, -1}, {}, 0, {}}, {}});
    Drawing drawing;
    ASSERT_TRUE(add_recording(drawing, recording));
    ASSERT_TRUE(made.add_trial(session, result_of(trial, 1), drawing));
  }
  const std::size_t drag = session.plan[0].condition == 1 ? 0 : 2, free = drag == 0 ? 2 : 0;
  ASSERT_NE(session.plan[0].condition, session.plan[2].condition);
  for (TrialResult& result : session.results) {
    result.fingerprint.clear();
    EXPECT_TRUE(made.recording(simulated(1), result));
  }
  std::filesystem::copy_file(made.file_of(simulated(1), session.results[free].recording),
                             made.file_of(simulated(1), session.results[drag].recording),
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_FALSE(made.recording(simulated(1), session.results[drag]));
}

TEST_F(StudyFolderTest, ASessionStartsAtATimeThatExists) {
  StudyFolder made = folder();
  int participant = 1;
  for (const char* time : {"2026-13-45T99:99:99Z", "2026-02-29T00:00:00Z", "2026-00-10T00:00:00Z",
                           "2026-04-31T00:00:00Z", "2026-04-00T00:00:00Z", "2026-04-01T24:00:00Z",
                           "2026-04-01T23:60:00Z", "2026-04-01T23:59:60Z", "2026-04-01T23:59:59"}) {
    SessionInfo info = simulated(++participant);
    info.started = time;
    EXPECT_FALSE(made.begin_session(info)) << time;
  }
  for (const char* time :
       {"2024-02-29T23:59:59Z", "2000-02-29T00:00:00Z", "1999-12-31T12:00:00Z"}) {
    SessionInfo info = simulated(++participant);
    info.started = time;
    EXPECT_TRUE(made.begin_session(info)) << time;
  }
}

TEST_F(StudyFolderTest, DoesNotReadAHugeSession) {
  const StudyFolder made = filled();
  write("out/participant-0001/train/session.json", std::string(kMaxSessionBytes + 1, ' '));
  ASSERT_FALSE(made.sessions());
  EXPECT_THAT(made.sessions().error().message, HasSubstr(session_file()));
}

/// Returns a session of the small study with random results and answers.
rc::Gen<StudySession> random_session(const Study& study) {
  return rc::gen::exec([&study] {
    StudySession session;
    session.info.participant = *rc::gen::inRange(1, kMaxParticipants + 1);
    session.info.device = *rc::gen::container<std::string>(rc::gen::inRange(' ', '\x7f'));
    session.info.device.resize(std::min<std::size_t>(session.info.device.size(), 200));
    session.info.program = "feltline \"\\ \xc3\xa9";
    if (*rc::gen::arbitrary<bool>()) session.info.started = "2026-11-24T09:30:00Z";
    if (*rc::gen::arbitrary<bool>()) {
      session.info.person_seed = *rc::gen::arbitrary<std::uint64_t>();
      session.info.person_model = *rc::gen::element<std::string>("", "proportional", "resting");
    }
    session.plan = plan_trials(study, session.info.participant, SessionKind::kTrain).value();
    for (const PlannedTrial& trial : session.plan) {
      const int attempts = *rc::gen::inRange(0, 4);
      for (int attempt = 1; attempt <= attempts; ++attempt) {
        TrialResult result = result_of(trial.number, attempt,
                                       std::string(*rc::gen::element<std::string_view>(
                                           "", "interrupted", "left_tunnel", "device_fault")));
        result.recording = recording_name(result);
        if (*rc::gen::arbitrary<bool>()) result.fingerprint = fingerprint_of(result.recording);
        session.results.push_back(result);
      }
      if (!trial.asks_questions || *rc::gen::arbitrary<bool>()) continue;
      for (const Questionnaire form : study.questionnaires) {
        const ItemRange range = item_range(form);
        QuestionAnswers answers{trial.number, form, {}};
        for (std::size_t i = 0; i < item_count(form); ++i) {
          answers.values.push_back(*rc::gen::inRange(range.min, range.max + 1));
        }
        session.answers.push_back(answers);
      }
    }
    return session;
  });
}

RC_GTEST_PROP(SessionFile, ReadsWhatItWrote, ()) {
  const Study study = read_study(felt::testing::kSmallStudy).value();
  const StudySession session = *random_session(study);
  RC_ASSERT(check_session(session, study).has_value());
  const auto read = session_from_json(session_to_json(session, study), study, session.info);
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == session);
}

RC_GTEST_PROP(SessionFile, NeverReadsATruncatedFile, ()) {
  const Study study = read_study(felt::testing::kSmallStudy).value();
  const StudySession session = *random_session(study);
  const std::string text = session_to_json(session, study);
  const auto size = *rc::gen::inRange<std::size_t>(0, text.size() - 1);
  RC_ASSERT(!session_from_json(text.substr(0, size), study, session.info));
}

RC_GTEST_PROP(SessionFile, NeverCrashesOnDamagedBytes, ()) {
  const Study study = read_study(felt::testing::kSmallStudy).value();
  const StudySession session = *random_session(study);
  std::string text = session_to_json(session, study);
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
    text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::arbitrary<char>();
  }
  const auto read = session_from_json(text, study, session.info);
  if (read) RC_ASSERT(check_session(*read, study).has_value());
}

}  // namespace
}  // namespace felt::study_folder_test
