#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QProgressDialog>
#include <QPushButton>
#include <QTest>
#include <cmath>
#include <string>

#include "desktop/engine/recording_file.h"
#include "desktop/files/testing/studio_fixture.h"
#include "desktop/files/timelapse_actions.h"
#include "desktop/files/timelapse_dialog.h"
#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/io/events/event_writer.h"
#include "felt/timelapse/testing/drawn_recording.h"

namespace felt::desktop::timelapse_test {
namespace {

constexpr int kWaitMs = 60'000;

FeltRecording three_lines() {
  felt::testing::DrawnRecording made;
  for (const double y : {20.0, 40.0, 60.0}) made.line({10, y}, {80, y}, 40);
  return made.take();
}

std::string script_of(const FeltRecording& recording) {
  std::string text;
  (void)play_recording(recording, [&text](const Event& event) -> Result<void> {
    append_event_line(text, event);
    return {};
  });
  return text;
}

std::string bytes_of(const QString& path) {
  return read_file(path.toStdString(), std::size_t{1} << 28).value_or("");
}

struct FilmFixture : StudioFixture {
  FilmFixture() : FilmFixture(StudioOptions{.live = false}) {}
  explicit FilmFixture(StudioOptions options) : StudioFixture(std::move(options)) {
    // An encoder that keeps the raw frames.
    const QString program = at("encoder");
    EXPECT_TRUE(write_file(program.toStdString(), "#!/bin/sh\ncat >&3\n"));
    QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    request.program = program.toStdString();
    request.recording = at("lines.ndjson");
    request.longer_px = 160;
    request.seconds = 1.0;
    EXPECT_TRUE(write_file(request.recording.toStdString(), script_of(three_lines())));
  }
  /// Makes the film as the menu does, and returns whether it was made.
  bool make(const QString& path) {
    QSignalSpy made(films(), &TimelapseActions::made);
    films()->make(path, request);
    EXPECT_TRUE(made.wait(kWaitMs));
    return made.front().at(1).toBool();
  }
  [[nodiscard]] TimelapseActions* films() { return window.findChild<TimelapseActions*>(); }

  TimelapseRequest request;
};

TEST(Timelapse, TheFilmOfARecordingHasAllFrames) {
  FilmFixture fixture;
  TimelapseProgress progress;
  ASSERT_TRUE(make_timelapse(fixture.at("a.webm"), fixture.request, progress));
  EXPECT_EQ(progress.all, 24);
  EXPECT_EQ(progress.done, 24);
  const std::string frames = bytes_of(fixture.at("a.webm"));
  ASSERT_EQ(frames.size() % 24, 0u);
  const std::size_t size = frames.size() / 24;
  EXPECT_NE(frames.substr(0, size), frames.substr(23 * size)) << "nothing moves";
  // The same recording in a drawing gives the same film.
  Drawing drawing;
  drawing.has_page = false;
  ASSERT_TRUE(add_recording(drawing, three_lines()));
  fixture.request.drawing = drawing;
  fixture.request.drawing->page = Page{};
  ASSERT_TRUE(make_timelapse(fixture.at("b.webm"), fixture.request, progress));
  EXPECT_EQ(bytes_of(fixture.at("b.webm")), frames);
}

TEST(Timelapse, SaysWhatItChangesInRawStrokes) {
  FilmFixture fixture;
  fixture.request.format = TimelapseFormat::kSvg;
  QString changed = QStringLiteral("nothing was exported");
  QObject::connect(
      fixture.files, &FileActions::exported, fixture.films(),
      [&changed](const QString&, const LostObjects&, const QString& what) { changed = what; });
  ASSERT_TRUE(fixture.make(fixture.at("lines.svg")));
  EXPECT_EQ(changed, QString()) << "a recording is drawn as it is";
  fixture.request.recording = fixture.at("raw.ndjson");
  ASSERT_TRUE(
      write_file(fixture.request.recording.toStdString(),
                 R"({"points":[[10,10,512,0],[20,10,700,100],[30,10,900,200],[40,10,900,300]]})"));
  ASSERT_TRUE(fixture.make(fixture.at("raw.svg")));
  EXPECT_TRUE(changed.contains(QStringLiteral("has pressures outside 0 to 1")))
      << changed.toStdString();
  EXPECT_EQ(changed.count(QStringLiteral("pressures outside")), 1) << "once";
}

TEST(Timelapse, TheSessionOfTheWindowIsFilmedWhileItIsRecorded) {
  StudioOptions options{.live = false};
  const QTemporaryDir folder;
  const auto recording = record_into(folder.filePath(QStringLiteral("rec.ndjson")), options);
  FilmFixture fixture(options);
  EXPECT_EQ(recording_of(fixture.studio), recording.get());
  // The session begins with a drawing.
  Document start;
  const auto stroke =
      std::make_shared<const Stroke>(felt::testing::straight_stroke({10, 10}, {90, 10}, 1.0, 1.0));
  fixture.draw(1, 1);
  start = fixture.document();
  fixture.studio.open(start, Page{});
  for (int i = 0; i <= 40; ++i) {
    fixture.studio.point({fixture.studio.now_ns(), {20.0 + i, 100.0}, true, 0.5, 0});
    fixture.studio.advance(5'000'000);
  }
  fixture.request = fixture.films()->with_session(fixture.request);
  fixture.request.format = TimelapseFormat::kSvg;
  ASSERT_TRUE(fixture.make(fixture.at("session.svg")))
      << fixture.person->errors.join("\n").toStdString();
  const std::string svg = bytes_of(fixture.at("session.svg"));
  std::size_t paths = 0;
  for (auto at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) {
    ++paths;
  }
  EXPECT_GE(paths, 2u) << "the line from before the session, and the one that the pen is drawing";
  EXPECT_TRUE(fixture.films()->with_session({}).start.has_page);
}

TEST(Timelapse, TheRecordingIsNotOverwritten) {
  FilmFixture fixture;
  const std::string before = bytes_of(fixture.request.recording);
  ASSERT_TRUE(QFile::link(fixture.request.recording, fixture.at("link.svg")));
  fixture.request.format = TimelapseFormat::kSvg;
  EXPECT_FALSE(fixture.make(fixture.at("link.svg")));
  ASSERT_EQ(fixture.person->errors.size(), 1);
  EXPECT_TRUE(fixture.person->errors.front().contains(QStringLiteral("nothing was written")));
  EXPECT_EQ(bytes_of(fixture.request.recording), before);
  // The same holds for a file that the recording imports.
  ASSERT_TRUE(write_file(fixture.at("in.svg").toStdString(), "<svg/>"));
  fixture.request.recording = fixture.at("import.ndjson");
  ASSERT_TRUE(
      write_file(fixture.request.recording.toStdString(),
                 script_of(three_lines()) + R"({"event":"import","t_ms":0,"path":"in.svg"})"));
  EXPECT_FALSE(fixture.make(fixture.at("in.svg")));
  EXPECT_EQ(bytes_of(fixture.at("in.svg")), "<svg/>");
  EXPECT_TRUE(fixture.person->errors.back().contains(QStringLiteral("in.svg")));
}

TEST(Timelapse, SaysThatTheEncoderIsMissing) {
  FilmFixture fixture;
  fixture.request.program = "no-such-encoder";
  EXPECT_FALSE(fixture.make(fixture.at("a.webm")));
  ASSERT_EQ(fixture.person->errors.size(), 1);
  EXPECT_TRUE(fixture.person->errors.front().contains(QStringLiteral("is not installed")));
  EXPECT_FALSE(QFile::exists(fixture.at("a.webm")));
  TimelapseDialog dialog(
      {RecordingSource::kDrawing}, [] { return QString(); }, QStringLiteral("no-such-encoder"),
      nullptr);
  auto* format = dialog.findChildren<QComboBox*>()[1];
  const auto can_export = [&dialog] {
    for (const auto* button : dialog.findChildren<QPushButton*>()) {
      if (button->isDefault()) return button->isEnabled();
    }
    return false;
  };
  EXPECT_FALSE(can_export());
  format->setCurrentIndex(2);
  EXPECT_EQ(dialog.request().format, TimelapseFormat::kSvg);
  EXPECT_TRUE(can_export());
}

TEST(Timelapse, ACancelledFilmLeavesNothingBehind) {
  FilmFixture fixture;
  fixture.request.seconds = 3600.0;
  ASSERT_TRUE(write_file(fixture.at("a.webm").toStdString(), "old"));
  QSignalSpy made(fixture.films(), &TimelapseActions::made);
  QAction* action = fixture.actions.find(QStringLiteral("file.timelapse"));
  fixture.films()->make(fixture.at("a.webm"), fixture.request);
  EXPECT_FALSE(action->isEnabled());
  auto* shown = fixture.window.findChild<QProgressDialog*>();
  ASSERT_NE(shown, nullptr);
  EXPECT_FALSE(shown->isModal());
  shown->findChild<QPushButton*>()->click();
  ASSERT_TRUE(made.wait(kWaitMs));
  EXPECT_FALSE(made.front().at(1).toBool());
  EXPECT_EQ(bytes_of(fixture.at("a.webm")), "old");
  EXPECT_TRUE(fixture.person->errors.empty());
  EXPECT_TRUE(action->isEnabled());
}

TEST(Timelapse, TheDialogNeedsAFile) {
  const FilmFixture fixture;
  QString chosen;
  TimelapseDialog dialog(
      {}, [&chosen] { return chosen; }, QStringLiteral("sh"), nullptr);
  EXPECT_EQ(dialog.source(), RecordingSource::kFile);
  QPushButton *go = nullptr, *choose = nullptr;
  for (auto* button : dialog.findChildren<QPushButton*>()) {
    if (button->isDefault()) go = button;
    if (button->text().contains(QStringLiteral("hoose"))) choose = button;
  }
  ASSERT_TRUE(go && choose);
  EXPECT_FALSE(go->isEnabled());
  chosen = fixture.at("lines.ndjson");
  choose->click();
  EXPECT_TRUE(go->isEnabled());
  EXPECT_EQ(dialog.request().recording, chosen);
  EXPECT_EQ(dialog.request().seconds, std::nullopt);
  dialog.findChild<QDoubleSpinBox*>()->setValue(12.5);
  EXPECT_EQ(dialog.request().seconds, 12.5);
}

}  // namespace
}  // namespace felt::desktop::timelapse_test
