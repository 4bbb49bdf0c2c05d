#include "felt/store/felt_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>
#include <cstring>
#include <random>

#include "felt/autosave/autosave_database.h"
#include "felt/autosave/recovery.h"
#include "felt/autosave/testing/autosave_fixture.h"
#include "felt/session/session.h"
#include "felt/store/felt_extras.h"
#include "felt/store/felt_file.h"
#include "felt/tools/tool.h"

namespace felt::felt_recording_test {
namespace {

using ::testing::HasSubstr;

/// Records a session in which a pencil with forces draws, the user undoes, and it draws again.
struct Recorded {
  FeltRecording recording;
  Document document;
};

Recorded draw() {
  FeltRecorder recorder("virtual pen", 1'000'000);
  Session session(make_tools(), {.device = {},
                                 .document = {},
                                 .on_event = [&](const Event& e) { recorder.event(e); },
                                 .on_edit = {}});
  std::int64_t now_ns = 5'000'000;
  const auto apply = [&](auto what) { EXPECT_TRUE(session.apply({now_ns, what})); };
  const auto line = [&](double y) {
    for (int i = 0; i <= 300; ++i) {
      now_ns += i % 50 == 49 ? 1'250'000 : 1'000'000;
      const bool down = i > 20 && i < 280;
      const double x = 20.0 + 0.31 * i, wave = y + 9.0 * std::sin(0.05 * i);
      recorder.forces(now_ns, {0.1 * std::sin(i), 1.0 / 3.0, down ? 2.0 : 0.0},
                      {0.1 * std::sin(i), 0.3, down ? 1.5 : 0.0});
      EXPECT_TRUE(session.sample({now_ns, {x, wave, down ? -0.2 - 0.001 * i : 4.0}, {}, {}, 0}));
    }
  };
  apply(SelectTool{"pencil"});
  line(40.0);
  apply(SetOption{"pencil.snap", std::string("off")});
  line(70.0);
  apply(UndoEvent{});
  apply(LayerEvent{LayerEvent::Do::kAdd, {}, "Ideas \"2\"\n"});
  line(90.0);
  EXPECT_EQ(session.document().stroke_count(), 2u);
  return {recorder.take(), session.document()};
}

Drawing drawing_of(const Recorded& recorded) {
  Drawing drawing;
  drawing.document = recorded.document;
  EXPECT_TRUE(add_recording(drawing, recorded.recording));
  return drawing;
}

TEST(FeltRecording, PlayedBackGivesTheSameDrawing) {
  const Recorded recorded = draw();
  const std::string bytes = felt_bytes(drawing_of(recorded)).value();
  const Drawing back = parse_felt(bytes).value();
  const FeltRecording recording = read_recording(back, 0).value();
  EXPECT_TRUE(recording == recorded.recording);
  Session session(make_tools(), {.device = {}, .document = {}, .on_event = {}, .on_edit = {}});
  ASSERT_TRUE(play_recording(recording, [&](const Event& e) { return session.apply(e); }));
  EXPECT_TRUE(session.document() == recorded.document);
}

TEST(FeltRecording, IsCarriedUnreadAndOthersAreAdded) {
  const Recorded recorded = draw();
  Drawing drawing = parse_felt(felt_bytes(drawing_of(recorded)).value()).value();
  EXPECT_NE(felt_extras(drawing).file, nullptr);
  const std::string once = felt_bytes(drawing).value();
  EXPECT_EQ(felt_bytes(parse_felt(once).value()).value(), once);
  FeltRecording second;
  second.device = "mouse";
  second.samples.push_back({7, {{1.0, 2.0, 3.0}, 0.25, 9}, std::nullopt});
  ASSERT_TRUE(add_recording(drawing, second));
  drawing = parse_felt(felt_bytes(drawing).value()).value();
  const auto infos = recordings_of(drawing).value();
  ASSERT_EQ(infos.size(), 2u);
  EXPECT_EQ(infos[0].device, "virtual pen");
  EXPECT_EQ(infos[0].samples, 903);
  EXPECT_NEAR(infos[0].duration_s, 0.907, 0.002);
  EXPECT_TRUE(read_recording(drawing, 0).value() == recorded.recording);
  EXPECT_TRUE(read_recording(drawing, 1).value() == second);
  EXPECT_EQ(read_recording(drawing, 2).error().code, ErrorCode::kNotFound);
  EXPECT_TRUE(recordings_of(Drawing()).value().empty());
}

/// The recording of draw(), with a pen that is tilted in the middle part.
FeltRecording leaning() {
  FeltRecording recording = draw().recording;
  for (std::size_t i = 100; i < 700; ++i) {
    recording.samples[i].pen.tilt_deg = 0.1 * static_cast<double>(i);
  }
  return recording;
}

TEST(FeltRecording, APensTiltIsKept) {
  Drawing drawing;
  ASSERT_TRUE(add_recording(drawing, leaning()));
  const std::string once = felt_bytes(drawing).value();
  const Drawing back = parse_felt(once).value();
  EXPECT_TRUE(read_recording(back, 0).value() == leaning());
  EXPECT_EQ(felt_bytes(back).value(), once) << "carried as it is";
}

/// Recordings without tilt give the same files as before tilt was recorded.
TEST(FeltRecording, WithoutTiltItIsTheSameFileAsEver) {
  const std::string bytes = felt_bytes(drawing_of(draw())).value();
  EXPECT_EQ(bytes.find("tilt"), std::string::npos);
}

TEST(FeltRecording, OneThatTiltsStandsBesideOneThatDoesNot) {
  const FeltRecording plain = draw().recording, tilts = leaning();
  for (const bool plain_first : {true, false}) {
    Drawing drawing;
    ASSERT_TRUE(add_recording(drawing, plain_first ? plain : tilts));
    drawing = parse_felt(felt_bytes(drawing).value()).value();
    ASSERT_TRUE(add_recording(drawing, plain_first ? tilts : plain));
    drawing = parse_felt(felt_bytes(drawing).value()).value();
    EXPECT_TRUE(read_recording(drawing, 0).value() == (plain_first ? plain : tilts));
    EXPECT_TRUE(read_recording(drawing, 1).value() == (plain_first ? tilts : plain));
  }
}

/// The autosave does not contain recordings: they are still in the user's file.
TEST(FeltRecording, IsThereAfterARecovery) {
  const felt::testing::TestFolder folder;
  ASSERT_TRUE(write_felt(folder.at("a.felt"), drawing_of(draw())));
  const Drawing drawing = read_felt(folder.at("a.felt")).value();
  std::string left;
  {
    AutosaveDatabase store = AutosaveDatabase::create(folder.at("state"), "a").value();
    ASSERT_TRUE(store.write_base(drawing));
    ASSERT_TRUE(store.put_info({"a", folder.at("a.felt"), false, drawing}));
    ASSERT_TRUE(store.commit());
    left = store.folder();
  }
  const Recovered recovered = recover_autosave(left).value();
  EXPECT_TRUE(recovered.drawing.document == drawing.document);
  EXPECT_EQ(recordings_of(recovered.drawing).value().size(), 1u);
}

/// A program that opened a.felt, draws on, and crashes.
class AfterACrash : public ::testing::Test {
 protected:
  AfterACrash() : fixture_({.roots = {folder_.path}}) {}

  void open(const Drawing& drawing) {
    ASSERT_TRUE(write_felt(path_, drawing));
    Drawing read = read_felt(path_).value();
    has_extras_ = read.extras != nullptr;
    read.document = fixture_.session->document();
    drawing_ = read;
    fixture_.autosave->session_began(*fixture_.session, std::move(read), "a", path_, false);
    fixture_.autosave->process();
    fixture_.draw(5);
    fixture_.autosave->process();
  }
  void save() {
    drawing_.document = fixture_.session->document();
    ASSERT_TRUE(write_felt(path_, drawing_));
    fixture_.autosave->post({.name = "a", .path = path_, .modified = false});
    fixture_.draw(6);
    fixture_.autosave->process();
  }
  [[nodiscard]] std::size_t recordings_of_recovered() {
    recovered_ = fixture_.crashed();
    EXPECT_EQ(recovered_.drawing.document, fixture_.session->document());
    return recordings_of(recovered_.drawing).value().size();
  }
  [[nodiscard]] std::string problem() const {
    EXPECT_LE(recovered_.problems.size(), 1u);
    return recovered_.problems.empty() ? "" : recovered_.problems.front();
  }

  felt::testing::TestFolder folder_;
  std::string path_ = folder_.at("a.felt");
  felt::testing::AutosaveFixture fixture_;
  Drawing drawing_;
  bool has_extras_ = false;
  Recovered recovered_;
};

TEST_F(AfterACrash, RecordingsOfTheFileAreThereBeforeAndAfterASave) {
  open(drawing_of(draw()));
  ASSERT_TRUE(has_extras_);
  EXPECT_EQ(recordings_of_recovered(), 1u);
  save();
  EXPECT_EQ(recordings_of_recovered(), 1u);
  EXPECT_EQ(problem(), "");
}

TEST_F(AfterACrash, AnotherDrawingInTheFileGivesNoneOfItsRecordings) {
  open(drawing_of(draw()));
  Drawing other = drawing_of(draw());
  ASSERT_TRUE(add_recording(other, draw().recording));
  ASSERT_TRUE(write_felt(path_, other));
  EXPECT_EQ(recordings_of_recovered(), 0u);
  EXPECT_THAT(problem(), HasSubstr(path_ + " has changed since Feltline last read or saved it"));
}

TEST_F(AfterACrash, AMissingFileIsNamedOnlyIfItHadRecordings) {
  open(drawing_of(draw()));
  std::filesystem::remove(path_);
  EXPECT_EQ(recordings_of_recovered(), 0u);
  EXPECT_THAT(problem(), HasSubstr(path_ + " is not there any more"));
}

TEST_F(AfterACrash, ADrawingWithoutRecordingsTakesNone) {
  open(Drawing());
  ASSERT_FALSE(has_extras_);
  ASSERT_TRUE(write_felt(path_, drawing_of(draw())));
  EXPECT_EQ(recordings_of_recovered(), 0u);
  EXPECT_EQ(problem(), "") << "nothing was lost";
}

/// Reads the file as any program does that uses SQLite and does not know Feltline.
class Queries : public ::testing::Test {
 protected:
  Queries() : recorded_(draw()) {
    bytes_ = felt_bytes(drawing_of(recorded_)).value();
    open();
  }
  ~Queries() override { sqlite3_close(db_); }

  void open() {
    EXPECT_EQ(sqlite3_open(":memory:", &db_), SQLITE_OK);
    auto* data = reinterpret_cast<unsigned char*>(bytes_.data());
    const auto size = static_cast<sqlite3_int64>(bytes_.size());
    EXPECT_EQ(sqlite3_deserialize(db_, "main", data, size, size, 0), SQLITE_OK);
  }

  double number(const char* sql) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db_, sql, -1, &statement, nullptr), SQLITE_OK)
        << sqlite3_errmsg(db_);
    EXPECT_EQ(sqlite3_step(statement), SQLITE_ROW);
    const double value = sqlite3_column_double(statement, 0);
    sqlite3_finalize(statement);
    return value;
  }

  Recorded recorded_;
  std::string bytes_;
  sqlite3* db_ = nullptr;
};

TEST_F(Queries, PlainSqlReadsSamplesForcesAndEvents) {
  EXPECT_EQ(number("SELECT count(*) FROM recorded_samples WHERE recording = 1"), 903);
  EXPECT_EQ(number("SELECT samples FROM recordings"), 903);
  EXPECT_EQ(number("SELECT rate_hz FROM recordings"), 1000.0);
  const RecordedSample& s = recorded_.recording.samples[100];
  EXPECT_DOUBLE_EQ(number("SELECT t_ms FROM recorded_samples WHERE sample = 100"),
                   1e-6 * static_cast<double>(s.time_ns));
  EXPECT_EQ(number("SELECT x_mm FROM recorded_samples WHERE sample = 100"), s.pen.position.x);
  EXPECT_EQ(number("SELECT z_mm FROM recorded_samples WHERE sample = 100"), s.pen.position.z);
  EXPECT_NEAR(number("SELECT asked_y_n FROM recorded_samples WHERE sample = 100"), 1.0 / 3.0, 5e-5);
  EXPECT_NEAR(number("SELECT sent_y_n FROM recorded_samples WHERE sample = 100"), 0.3, 1e-12);
  EXPECT_NEAR(number("SELECT max(sent_z_n) FROM recorded_samples"), 1.5, 1e-12);
  EXPECT_NEAR(number("SELECT max(asked_z_n) FROM recorded_samples"), 2.0, 1e-12);
  EXPECT_EQ(number("SELECT count(*) FROM recorded_events"), 4);
  EXPECT_EQ(number("SELECT before_sample FROM recorded_events WHERE kind = 'undo'"), 602);
  EXPECT_EQ(number("SELECT line ->> 'value' = 'off' FROM recorded_events WHERE kind = 'option'"),
            1);
}

TEST_F(Queries, PlainSqlReadsTheTilt) {
  sqlite3_close(db_);
  Drawing drawing;
  ASSERT_TRUE(add_recording(drawing, leaning()));
  bytes_ = felt_bytes(drawing).value();
  open();
  EXPECT_EQ(number("SELECT count(lean_deg) FROM recorded_samples"), 600);
  EXPECT_EQ(number("SELECT lean_deg FROM recorded_samples WHERE sample = 325"), 32.5);
}

/// A tilt that was changed or removed is damage, which the checksum of the tilts detects.
TEST_F(Queries, AChangedTiltIsDamage) {
  sqlite3_close(db_);
  Drawing drawing;
  ASSERT_TRUE(add_recording(drawing, leaning()));
  const std::string good = felt_bytes(drawing).value();
  for (const char* change : {"UPDATE recording_sample SET lean_deg = 12.0 WHERE id = 326",
                             "UPDATE recording_sample SET lean_deg = NULL WHERE id = 326",
                             "UPDATE recording_sample SET lean_deg = 'x' WHERE id = 326",
                             "UPDATE recording_sample SET lean_deg = 120.0 WHERE id = 326"}) {
    bytes_ = good;
    open();
    EXPECT_EQ(sqlite3_exec(db_, change, nullptr, nullptr, nullptr), SQLITE_OK) << change;
    sqlite3_int64 size = 0;
    unsigned char* data = sqlite3_serialize(db_, "main", &size, 0);
    const std::string changed(reinterpret_cast<char*>(data), static_cast<std::size_t>(size));
    sqlite3_free(data);
    sqlite3_close(std::exchange(db_, nullptr));
    EXPECT_FALSE(read_recording(parse_felt(changed).value(), 0)) << change;
  }
}

TEST_F(Queries, ASampleTakesFewBytes) {
  Drawing drawing;
  drawing.document = recorded_.document;
  const auto all = static_cast<double>(bytes_.size() - felt_bytes(drawing).value().size());
  EXPECT_LT(all / 903.0, 80.0);  // 112 as plain doubles; includes four tables and views
}

TEST(FeltRecording, WhatIsOutOfOrderOrDamagedIsAnError) {
  Drawing drawing;
  FeltRecording bad;
  bad.samples = {{5, {}, std::nullopt}, {4, {}, std::nullopt}};
  EXPECT_THAT(add_recording(drawing, bad).error().message, HasSubstr("sample 1"));
  bad.samples = {{5, {{std::nan(""), 0, 0}, {}, 0}, std::nullopt}};
  EXPECT_THAT(add_recording(drawing, bad).error().message, HasSubstr("sample 0"));
  for (const double tilt : {-0.1, 90.1, std::nan("")}) {
    bad.samples = {{5, {{0, 0, 0}, {}, 0, tilt}, std::nullopt}};
    EXPECT_THAT(add_recording(drawing, bad).error().message, HasSubstr("sample 0"));
  }
  bad.samples.clear();
  bad.events = {{1, {0, UndoEvent{}}}};
  EXPECT_THAT(add_recording(drawing, bad).error().message, HasSubstr("event 0"));
  EXPECT_EQ(drawing.extras, nullptr);

  ASSERT_TRUE(add_recording(drawing, leaning()));
  const std::string bytes = felt_bytes(drawing).value();
  std::mt19937 random(3);
  for (int run = 0; run < 100; ++run) {
    std::string changed = bytes;
    changed[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
    const Result<Drawing> read = parse_felt(changed);
    if (!read) continue;
    EXPECT_TRUE(felt_bytes(*read)) << "run " << run;
    if (const Result<FeltRecording> recording = read_recording(*read, 0)) {
      EXPECT_TRUE(check_recording(*recording));
    }
  }
}

}  // namespace
}  // namespace felt::felt_recording_test
