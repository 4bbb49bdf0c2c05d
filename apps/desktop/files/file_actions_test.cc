#include "desktop/files/file_actions.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDateTime>
#include <QDropEvent>
#include <QFile>
#include <QMenu>
#include <QMimeData>
#include <QTest>
#include <QUrl>
#include <set>

#include "desktop/engine/kept_options.h"
#include "desktop/engine/settings.h"
#include "desktop/files/files_setting_keys.h"
#include "desktop/files/testing/studio_fixture.h"
#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_recording.h"

namespace felt::desktop::file_actions_test {
namespace {

TEST(FileActions, WhatIsSavedOpensAsItWas) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}, "Ideas"});
  fixture.draw(2);
  fixture.studio.set_page({148.0, 210.0, {255, 250, 240, 255}});
  fixture.studio.apply(SetOption{"ink.color", std::string("#204060")});
  fixture.person->next = fixture.at("one");  // the suffix is appended
  EXPECT_TRUE(fixture.studio.is_modified());
  ASSERT_TRUE(fixture.files->save());
  fixture.files->finish_writing();
  EXPECT_FALSE(fixture.studio.is_modified());
  EXPECT_EQ(fixture.files->path(), fixture.at("one.felt"));
  const Drawing before = fixture.files->drawing();

  StudioFixture other;
  QSignalSpy opened(&other.studio, &Studio::opened);
  ASSERT_TRUE(other.files->open(fixture.at("one.felt")));
  EXPECT_EQ(opened.count(), 1);
  EXPECT_TRUE(other.files->drawing() == before);
  EXPECT_FALSE(other.studio.is_modified());
  EXPECT_FALSE(other.files->is_pristine());
}

TEST(FileActions, PaletteViewAndRecordingsTravelWithTheFile) {
  StudioFixture fixture;
  fixture.draw(1);
  Drawing made = fixture.files->drawing();
  FeltRecording recording;
  recording.device = "a pen";
  ASSERT_TRUE(add_recording(made, recording));
  made.palette = {"Leaves", 2, {{{10, 90, 20, 255}, "leaf"}}};
  made.view = Viewport{{12.0, 34.0}, 7.5, -30.0, true};
  ASSERT_TRUE(write_felt(fixture.at("made.felt").toStdString(), made));

  StudioFixture other;
  Drawing looks;  // palette and view of the window
  other.files->set_looks({.report =
                              [&](Drawing& d) {
                                d.palette = looks.palette;
                                d.view = looks.view;
                              },
                          .show =
                              [&](const Drawing& d) {
                                looks.palette = d.palette;
                                looks.view = d.view;
                              }});
  ASSERT_TRUE(other.files->open(fixture.at("made.felt")));
  EXPECT_EQ(looks.view, made.view);
  looks.view->px_per_mm = 2.0;
  other.draw(2);
  ASSERT_TRUE(other.files->save());
  other.files->finish_writing();
  const Drawing saved = read_felt(fixture.at("made.felt").toStdString()).value();
  EXPECT_EQ(saved.palette, made.palette);
  EXPECT_EQ(saved.view->px_per_mm, 2.0);
  EXPECT_EQ(recordings_of(saved).value().size(), 1u);
  // Another drawing does not keep palette and view.
  other.files->show_unsaved(Document(), Page(), QStringLiteral("Example"));
  EXPECT_EQ(other.files->drawing().extras, nullptr);
}

/// Other code, such as an example, can open a drawing without a file in the same studio.
TEST(FileActions, ADrawingWithoutAFileHasNoneOfTheNamesOfTheLastOne) {
  StudioFixture fixture;
  fixture.draw(1);
  Drawing made = fixture.files->drawing();
  const Document other = made.document;
  made.names = std::make_shared<const StrokeNames>(StrokeNames{{StrokeId{1}, "cat-1"}});
  ASSERT_TRUE(write_drawing(fixture.at("named.felt"), made));
  fixture.person->unsaved = FileDialogs::Unsaved::kDiscard;
  ASSERT_TRUE(fixture.files->open(fixture.at("named.felt")));
  EXPECT_EQ(used_names(fixture.files->drawing()).size(), 1u);
  fixture.studio.open(other, Page{});
  EXPECT_TRUE(used_names(fixture.files->drawing()).empty());
  ASSERT_TRUE(fixture.files->open(fixture.at("named.felt")));
  fixture.actions.find(QStringLiteral("file.new"))->trigger();
  fixture.draw(2);
  EXPECT_TRUE(used_names(fixture.files->drawing()).empty());
}

/// Writes a drawing whose strokes 1 and 2 are named, on two layers, one of which has an opacity.
void write_named(StudioFixture& fixture, const char* file) {
  fixture.draw(1, 3);
  fixture.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}, "Back"});
  fixture.draw(2, 1);
  Drawing made = fixture.files->drawing();
  made.names = std::make_shared<const StrokeNames>(
      StrokeNames{{StrokeId{1}, "cat-1"}, {StrokeId{2}, "dog"}});
  ASSERT_TRUE(write_drawing(fixture.at(file), made));
}

std::multiset<std::string> names_in(const Drawing& drawing) {
  std::multiset<std::string> names;
  for (const auto& [id, name] : used_names(drawing)) names.insert(name);
  return names;
}

TEST(FileActions, AnImportKeepsNamesAndSaysWhatItLeavesOut) {
  StudioFixture fixture;
  write_named(fixture, "named.felt");
  StudioFixture other;
  other.draw(7, 2);
  QStringList said;
  QObject::connect(other.files, &FileActions::taken, &other.window,
                   [&said](const QString&, const ImportReport& report) {
                     said.clear();
                     for (const ImportNotice& notice : report.notices()) {
                       said += QString::fromStdString(notice.what);
                     }
                   });
  ASSERT_TRUE(other.files->import(fixture.at("named.felt")));
  EXPECT_EQ(names_in(other.files->drawing()), (std::multiset<std::string>{"cat-1", "dog"}));
  ASSERT_EQ(said.size(), 1);
  EXPECT_TRUE(said.front().startsWith(QStringLiteral("Layers whose lines were added")));
  EXPECT_TRUE(said.front().endsWith(QStringLiteral(": 2")));
  // A name is that of one line.
  ASSERT_TRUE(other.files->import(fixture.at("named.felt")));
  EXPECT_EQ(names_in(other.files->drawing()), (std::multiset<std::string>{"cat-1", "dog"}));
  ASSERT_EQ(said.size(), 2);
  EXPECT_TRUE(said.back().startsWith(QStringLiteral("Names of lines that were left out")));
  EXPECT_TRUE(said.back().endsWith(QStringLiteral(": 2"))) << said.back().toStdString();
  other.save_as("both.felt");
  EXPECT_EQ(names_in(read_felt(other.at("both.felt").toStdString()).value()).size(), 2u);
}

TEST(FileActions, NothingIsLostUnasked) {
  StudioFixture fixture;
  fixture.draw(1);
  const Document before = fixture.document();
  EXPECT_FALSE(fixture.files->may_close());
  fixture.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_FALSE(fixture.files->open(fixture.at("none.felt")));
  EXPECT_EQ(fixture.person->asked.size(), 2) << "a file that cannot be read takes no place";
  EXPECT_EQ(fixture.person->errors.size(), 1);
  ASSERT_TRUE(write_drawing(fixture.at("other.felt"), Drawing{}));
  EXPECT_FALSE(fixture.files->open(fixture.at("other.felt")));
  EXPECT_EQ(fixture.person->asked.size(), 3);
  EXPECT_TRUE(fixture.document() == before);

  fixture.person->unsaved = FileDialogs::Unsaved::kSave;
  EXPECT_FALSE(fixture.files->may_close()) << "no name was chosen, so it is not saved";
  fixture.person->next = fixture.at("kept.felt");
  EXPECT_TRUE(fixture.files->may_close());
  EXPECT_TRUE(read_drawing(fixture.at("kept.felt")).value().document == before);

  fixture.draw(2);
  fixture.person->unsaved = FileDialogs::Unsaved::kDiscard;
  fixture.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(fixture.document().stroke_count(), 0u);
  EXPECT_TRUE(fixture.files->is_pristine());
}

TEST(FileActions, AFailedSaveKeepsTheDrawingModifiedAndSaysWhy) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.person->next = fixture.at("no/folder.felt");
  QSignalSpy saved(fixture.files, &FileActions::saved);
  fixture.files->save();
  fixture.files->finish_writing();
  ASSERT_EQ(saved.count(), 1);
  EXPECT_FALSE(saved[0][0].toBool());
  ASSERT_EQ(fixture.person->errors.size(), 1);
  EXPECT_TRUE(fixture.person->errors[0].contains(QStringLiteral("No such file")));
  EXPECT_TRUE(fixture.studio.is_modified());
  fixture.person->unsaved = FileDialogs::Unsaved::kSave;
  EXPECT_FALSE(fixture.files->may_close());
  ASSERT_TRUE(fixture.person->save_elsewhere);
  fixture.person->next = fixture.at("elsewhere.felt");
  fixture.person->save_elsewhere();
  fixture.files->finish_writing();
  EXPECT_FALSE(fixture.studio.is_modified());
  EXPECT_EQ(fixture.files->path(), fixture.at("elsewhere.felt"));
}

TEST(FileActions, AFileThatOthersChangedMayBeSavedElsewhere) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.save_as("a.felt");
  fixture.draw(2);
  QFile file(fixture.at("a.felt"));
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime);
  file.close();
  fixture.person->overwrite = FileDialogs::Overwrite::kSaveAs;
  fixture.save_as("b.felt");
  EXPECT_EQ(fixture.files->path(), fixture.at("b.felt"));
  EXPECT_EQ(read_drawing(fixture.at("a.felt")).value().document.stroke_count(), 3u);
}

TEST(FileActions, SaysThatAFileMayNotBeWritten) {
  StudioFixture fixture;
  ASSERT_TRUE(write_drawing(fixture.at("a.felt"), Drawing{}));
  ASSERT_TRUE(fixture.files->open(fixture.at("a.felt")));
  EXPECT_FALSE(fixture.files->is_read_only());
  ASSERT_TRUE(QFile::setPermissions(fixture.at("a.felt"), QFile::ReadOwner));
  ASSERT_TRUE(fixture.files->open(fixture.at("a.felt")));
  EXPECT_TRUE(fixture.files->is_read_only());
}

TEST(FileActions, ANewDrawingHasNotThePageOfTheFileBefore) {
  StudioFixture fixture;
  Drawing wide;
  wide.page.width_mm = 900.0;
  wide.page.paper = {200, 220, 255, 255};
  ASSERT_TRUE(write_drawing(fixture.at("wide.felt"), wide));
  ASSERT_TRUE(fixture.files->open(fixture.at("wide.felt")));
  EXPECT_EQ(fixture.studio.page().width_mm, 900.0);
  fixture.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(fixture.studio.page().width_mm, Page{}.width_mm);
  EXPECT_EQ(fixture.studio.page().paper, Page{}.paper);
  // A page that the user set up here stays.
  Page mine = fixture.studio.page();
  mine.width_mm = 333.0;
  fixture.studio.set_page(mine);
  fixture.person->unsaved = FileDialogs::Unsaved::kDiscard;
  fixture.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(fixture.studio.page().width_mm, 333.0);
}

TEST(FileActions, WhatIsDrawnDuringASaveStaysUnsaved) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.person->next = fixture.at("a.felt");
  fixture.files->save();
  fixture.draw(2);
  fixture.files->finish_writing();
  EXPECT_TRUE(fixture.studio.is_modified());
  EXPECT_EQ(read_drawing(fixture.at("a.felt")).value().document.stroke_count(), 3u);
}

// If the user undoes and redoes while the file is being written, the file contains the state at the
// start of the save.
TEST(FileActions, UndoDuringASaveIsAnUnsavedChange) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.save_as("a.felt");
  ASSERT_FALSE(fixture.studio.is_modified());
  fixture.draw(2);
  ASSERT_TRUE(fixture.files->save());
  fixture.studio.apply(UndoEvent{});
  ASSERT_FALSE(fixture.studio.is_modified()) << "until the file is written it is as it was";
  fixture.files->finish_writing();
  EXPECT_EQ(read_drawing(fixture.at("a.felt")).value().document.stroke_count(), 6u);
  EXPECT_TRUE(fixture.studio.is_modified()) << "the file has the lines that were undone";
  EXPECT_FALSE(fixture.files->may_close());
  EXPECT_EQ(fixture.person->asked.size(), 1) << "the person is asked, and stops it";
  fixture.studio.apply(RedoEvent{});
  EXPECT_FALSE(fixture.studio.is_modified());
  fixture.draw(3);
  ASSERT_TRUE(fixture.files->save());
  fixture.studio.apply(UndoEvent{});
  fixture.studio.apply(RedoEvent{});
  fixture.files->finish_writing();
  EXPECT_FALSE(fixture.studio.is_modified()) << "it is what the file has";
}

TEST(FileActions, TheColourOfAnOpenedDrawingIsNotKeptForTheNextStart) {
  const QString key = QStringLiteral("options/ink.color");
  Settings::the().reset(key);
  StudioFixture fixture;
  const KeptOptions kept(fixture.studio);
  const auto ink = [](const Studio& studio) {
    return std::get<std::string>(studio.session().option("ink.color").value());
  };
  const std::string first = ink(fixture.studio);
  Drawing board = fixture.files->drawing();
  board.color = {0xF0, 0xF0, 0xEC};
  ASSERT_TRUE(write_drawing(fixture.at("board.felt"), board).has_value());
  ASSERT_TRUE(fixture.files->open(fixture.at("board.felt")));
  EXPECT_EQ(ink(fixture.studio), "#f0f0ec") << "the drawing has its colour";
  EXPECT_FALSE(fixture.studio.is_modified());
  EXPECT_FALSE(Settings::the().value(key).isValid());
  {
    Studio next({.live = false});
    const KeptOptions at_start(next);
    EXPECT_EQ(ink(next), first);
  }
  fixture.studio.apply(SetOption{"ink.color", std::string("#b02020")});
  ASSERT_TRUE(fixture.files->open(fixture.at("board.felt")));
  Studio next({.live = false});
  const KeptOptions at_start(next);
  EXPECT_EQ(ink(next), "#b02020") << "what the user chose last";
  Settings::the().reset(key);
}

/// Moves the pen along a line, on the surface or above it.
void move_pen(StudioFixture& fixture, bool down, double y_mm) {
  for (int i = 0; i < 50; ++i) {
    fixture.studio.point({fixture.studio.now_ns(), {20.0 + i, y_mm}, down, 0.5});
    fixture.studio.advance(2'000'000);
  }
}

TEST(FileActions, ALineThatIsBeingDrawnIsAskedAboutAndSaved) {
  StudioFixture fixture;
  move_pen(fixture, false, 30.0);
  move_pen(fixture, true, 30.0);
  ASSERT_TRUE(fixture.studio.session().gesture_in_progress());
  EXPECT_EQ(fixture.document().stroke_count(), 0u);
  EXPECT_FALSE(fixture.files->may_close()) << "the person is asked, and stops it";
  EXPECT_EQ(fixture.person->asked.size(), 1);
  EXPECT_EQ(fixture.document().stroke_count(), 1u);
  move_pen(fixture, false, 60.0);
  move_pen(fixture, true, 60.0);
  ASSERT_TRUE(fixture.studio.session().gesture_in_progress());
  fixture.person->unsaved = FileDialogs::Unsaved::kSave;
  fixture.person->next = fixture.at("line.felt");
  EXPECT_TRUE(fixture.files->may_close());
  EXPECT_EQ(read_drawing(fixture.at("line.felt")).value().document.stroke_count(), 2u);
}

TEST(FileActions, WhatEndsDuringTheLastSaveIsSavedBeforeTheWindowGoes) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.person->unsaved = FileDialogs::Unsaved::kSave;
  fixture.person->next = fixture.at("late.felt");
  // Runs in the event loop while the file is being written.
  QMetaObject::invokeMethod(
      &fixture.studio, [&fixture] { fixture.draw(2); }, Qt::QueuedConnection);
  EXPECT_TRUE(fixture.files->may_close());
  EXPECT_EQ(fixture.document().stroke_count(), 6u);
  EXPECT_EQ(read_drawing(fixture.at("late.felt")).value().document.stroke_count(), 6u);
}

TEST(FileActions, AFileChangedByOthersIsNotOverwrittenUnasked) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.person->next = fixture.at("a.felt");
  fixture.files->save();
  fixture.files->finish_writing();
  QFile file(fixture.at("a.felt"));
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addSecs(60),
                               QFileDevice::FileModificationTime));
  file.close();
  fixture.draw(2);
  EXPECT_FALSE(fixture.files->save());
  EXPECT_EQ(fixture.person->asked, QStringList{QStringLiteral("a.felt")});
  fixture.person->overwrite = FileDialogs::Overwrite::kReplace;
  EXPECT_TRUE(fixture.files->save());
  fixture.files->finish_writing();
  EXPECT_EQ(read_drawing(fixture.at("a.felt")).value().document.stroke_count(), 6u);
}

TEST(FileActions, ANameThatGetsItsEndingDoesNotReplaceAFileUnasked) {
  StudioFixture fixture;
  fixture.draw(1);
  fixture.person->next = fixture.at("a 1.2.felt");
  fixture.files->save_as();
  fixture.files->finish_writing();
  fixture.draw(2);
  // The dialog asked about "a 1.2", which does not exist. Because "a 1.2.felt" exists, the program
  // then asks about that file.
  fixture.person->next = fixture.at("a 1.2");
  fixture.person->then = fixture.at("b.felt");
  EXPECT_TRUE(fixture.files->save_as());
  fixture.files->finish_writing();
  EXPECT_EQ(fixture.person->suggested, fixture.at("a 1.2.felt"));
  EXPECT_EQ(fixture.files->path(), fixture.at("b.felt"));
  EXPECT_EQ(read_drawing(fixture.at("a 1.2.felt")).value().document.stroke_count(), 3u);
}

TEST(FileActions, OtherFormatsOpenWithoutAFileOfTheirOwn) {
  StudioFixture fixture;
  fixture.draw(1);
  ASSERT_TRUE(write_drawing(fixture.at("a.svg"), fixture.files->drawing()));
  StudioFixture other;
  ASSERT_TRUE(other.files->open(fixture.at("a.svg")));
  EXPECT_EQ(other.files->path(), QString());
  EXPECT_EQ(other.files->display_name(), QStringLiteral("a"));
  other.files->save();
  EXPECT_EQ(other.person->suggested, fixture.at("a.felt"));
}

TEST(FileActions, DroppedFilesOpenOrAreAdded) {
  StudioFixture fixture;
  fixture.draw(1);
  ASSERT_TRUE(write_drawing(fixture.at("a.felt"), fixture.files->drawing()));
  StudioFixture other;
  other.files->take_dropped({fixture.at("a.felt"), fixture.at("a.felt")});
  EXPECT_EQ(other.document().stroke_count(), 6u);
  EXPECT_EQ(other.files->path(), fixture.at("a.felt"));
  EXPECT_TRUE(other.studio.apply(UndoEvent{}));
  EXPECT_EQ(other.document().stroke_count(), 3u);
}

/// Notes as Xournal++ writes them, without compression.
const char* const kNotes =
    "<?xml version=\"1.0\" standalone=\"no\"?>\n<xournal creator=\"t\" fileversion=\"4\">\n"
    "<page width=\"595\" height=\"842\">\n<background type=\"solid\" color=\"#ffffffff\" "
    "style=\"plain\"/>\n<layer>\n<stroke tool=\"pen\" color=\"#0000ffff\" width=\"2 1.5 2.5\">"
    "10 10 60 20 90 70</stroke>\n<text font=\"Sans\" size=\"12\" x=\"5\" y=\"5\" "
    "color=\"#000000ff\">no ink</text>\n</layer>\n</page>\n</xournal>\n";

TEST(FileActions, NotesOfAnotherProgramAreDroppedDrawnOnSavedAndOpenedAgain) {
  StudioFixture fixture;
  QSignalSpy taken(fixture.files, &FileActions::taken);
  ASSERT_TRUE(write_file(fixture.at("notes.xopp").toStdString(), kNotes));
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(fixture.at("notes.xopp"))});
  QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&fixture.window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&fixture.window, &drop);
  QApplication::processEvents();
  ASSERT_EQ(taken.count(), 1);
  EXPECT_EQ(fixture.person->errors, QStringList());
  EXPECT_EQ(fixture.document().stroke_count(), 1u);
  EXPECT_EQ(fixture.files->path(), QString());
  EXPECT_EQ(fixture.files->display_name(), QStringLiteral("notes"));
  const auto report = qvariant_cast<felt::ImportReport>(taken.at(0).at(1));
  ASSERT_EQ(report.notices().size(), 1u);
  EXPECT_EQ(report.notices()[0].line, 7);
  fixture.draw(3, 1);
  // Save asks for a name, because a notes file cannot contain the whole drawing. The file does not
  // change.
  fixture.save_as("notes");
  EXPECT_EQ(fixture.person->suggested, fixture.at("notes.felt"));
  EXPECT_EQ(fixture.files->path(), fixture.at("notes.felt"));
  EXPECT_EQ(read_file(fixture.at("notes.xopp").toStdString(), 1 << 20).value(), kNotes);
  const Document before = fixture.document();
  StudioFixture again;
  ASSERT_TRUE(again.files->open(fixture.at("notes.felt")));
  EXPECT_EQ(again.document(), before);
  EXPECT_EQ(again.files->path(), fixture.at("notes.felt"));
}

TEST(FileActions, WhatADamagedDrawingStillHoldsIsOfferedAndTheFileLeftAlone) {
  StudioFixture fixture;
  fixture.draw(1, 300);
  const QString path = fixture.at("a.felt");
  ASSERT_TRUE(write_drawing(path, fixture.files->drawing()));
  std::string bytes = read_file(path.toStdString(), 1 << 24).value();
  bytes.resize(bytes.size() - bytes.size() / 4);
  ASSERT_TRUE(write_file(path.toStdString(), bytes));
  StudioFixture other;
  EXPECT_FALSE(other.files->open(path));  // the user cancels
  EXPECT_EQ(other.person->errors.size(), 1);
  other.person->salvage = true;
  ASSERT_TRUE(other.files->open(path));
  EXPECT_GT(other.document().stroke_count(), 0u);
  EXPECT_EQ(int(other.document().stroke_count()), other.person->salvageable);
  EXPECT_EQ(other.files->path(), QString());
  EXPECT_EQ(read_file(path.toStdString(), 1 << 24).value(), bytes);
}

using Texts = std::vector<std::string>;

felt::ImportReport report_of(const QSignalSpy& taken) {
  return qvariant_cast<felt::ImportReport>(taken.back().at(1));
}

TEST(FileActions, ImportedStrokesBringTheirMediaAlong) {
  const Texts chalk{write_material(soft_chalk(0.4))};
  StudioFixture fixture;
  fixture.studio.apply(UseMaterial{chalk[0]});
  fixture.draw_with("soft-chalk");
  for (const char* name : {"a.felt", "a.svg"}) {
    ASSERT_TRUE(write_drawing(fixture.at(name), fixture.files->drawing()));
    StudioFixture other;
    other.draw(1);
    QSignalSpy taken(other.files, &FileActions::taken);
    ASSERT_TRUE(other.files->import(fixture.at(name)));
    ASSERT_EQ(taken.count(), 1);
    EXPECT_TRUE(report_of(taken).empty());
    EXPECT_NE(other.studio.materials().find_medium("soft-chalk"), nullptr);
    other.person->next = other.at("b.felt");
    ASSERT_TRUE(other.files->save());
    other.files->finish_writing();
    EXPECT_EQ(read_drawing(other.at("b.felt")).value().materials, chalk) << name;
  }
}

TEST(FileActions, AMediumThatIsAnotherOneHereIsNamedInTheReportOfAnImport) {
  StudioFixture fixture;
  fixture.studio.apply(UseMaterial{write_material(soft_chalk(0.4))});
  fixture.draw_with("soft-chalk");
  ASSERT_TRUE(write_drawing(fixture.at("a.felt"), fixture.files->drawing()));
  StudioFixture other;
  other.studio.apply(UseMaterial{write_material(soft_chalk(0.6))});
  QSignalSpy taken(other.files, &FileActions::taken);
  ASSERT_TRUE(other.files->import(fixture.at("a.felt")));
  EXPECT_EQ(other.document().stroke_count(), 1u);
  EXPECT_EQ(other.texts(), Texts{write_material(soft_chalk(0.6))});
  ASSERT_EQ(taken.count(), 1);
  ASSERT_EQ(report_of(taken).notices().size(), 1u);
  EXPECT_NE(report_of(taken).notices()[0].what.find("Soft chalk"), std::string::npos);
}

TEST(FileActions, ANewDrawingKeepsSurfaceAndPencilThatCameWithTheLast) {
  SurfaceMaterial slate = *find_surface("blackboard");
  slate.id = "slate";
  slate.friction = 0.5;
  const Texts texts{write_material(slate), write_material(soft_chalk(0.4))};
  StudioFixture fixture;
  Page page;
  page.surface = "slate";
  fixture.studio.open(Document{}, page, texts);
  ASSERT_TRUE(fixture.studio.apply(SetOption{"pencil.medium", std::string("soft-chalk")}));
  QSignalSpy refused(&fixture.studio, &Studio::refused);
  fixture.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(refused.count(), 0);
  EXPECT_TRUE(fixture.files->is_pristine());
  EXPECT_EQ(fixture.studio.session().surface(), slate);
  EXPECT_EQ(fixture.studio.session().option("pencil.medium").value(),
            OptionValue(std::string("soft-chalk")));
  EXPECT_EQ(fixture.texts(), texts);
  fixture.draw(1);
  fixture.save_as("new.felt");
  StudioFixture other;
  QSignalSpy other_refused(&other.studio, &Studio::refused);
  ASSERT_TRUE(other.files->open(fixture.at("new.felt")));
  EXPECT_EQ(other_refused.count(), 0);
  EXPECT_EQ(other.studio.session().surface(), slate);
}

TEST(FileActions, FiguresThatChangeDuringASaveStayUnsaved) {
  Materials known = Materials::built_in();
  known.put(soft_chalk(0.4));
  StudioFixture fixture;
  fixture.studio.set_user_materials(known);
  EXPECT_TRUE(fixture.files->is_pristine()) << "to know a medium changes nothing";
  fixture.draw_with("soft-chalk");
  fixture.person->next = fixture.at("a.felt");
  ASSERT_TRUE(fixture.files->save());
  known.put(soft_chalk(0.6));
  fixture.studio.set_user_materials(known);
  fixture.files->finish_writing();
  EXPECT_TRUE(fixture.studio.is_modified());
  EXPECT_EQ(read_drawing(fixture.at("a.felt")).value().materials,
            Texts{write_material(soft_chalk(0.4))});
  ASSERT_TRUE(fixture.files->save());
  fixture.files->finish_writing();
  EXPECT_FALSE(fixture.studio.is_modified());
  EXPECT_EQ(read_drawing(fixture.at("a.felt")).value().materials,
            Texts{write_material(soft_chalk(0.6))});
  ASSERT_TRUE(fixture.files->open(fixture.at("a.felt")));
  EXPECT_FALSE(fixture.studio.is_modified());
}

TEST(FileActions, RecentFilesAreRememberedWhileTheyAreThere) {
  Settings::the().set(files_keys::kRecent, QStringList());
  StudioFixture fixture;
  fixture.draw(1);
  for (const char* name : {"a&b.felt", "b.felt"}) {
    ASSERT_TRUE(write_drawing(fixture.at(name), fixture.files->drawing()));
    fixture.person->unsaved = FileDialogs::Unsaved::kDiscard;
    ASSERT_TRUE(fixture.files->open(fixture.at(name)));
  }
  const QMenu* menu = fixture.files->recent_menu();
  ASSERT_EQ(menu->actions().size(), 4);
  EXPECT_EQ(menu->actions()[0]->text(), QStringLiteral("&1  b.felt"));
  EXPECT_EQ(menu->actions()[1]->text(), QStringLiteral("&2  a&&b.felt"));
  menu->actions()[1]->trigger();
  QTRY_COMPARE(fixture.files->path(), fixture.at("a&b.felt"));
  QFile::remove(fixture.at("b.felt"));
  Q_EMIT fixture.files->recent_menu()->aboutToShow();
  EXPECT_EQ(menu->actions().size(), 3);
  menu->actions().back()->trigger();
  QTest::qWait(1);
  EXPECT_FALSE(menu->actions()[0]->isEnabled());
}

}  // namespace
}  // namespace felt::desktop::file_actions_test
