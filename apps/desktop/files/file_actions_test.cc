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

#include "desktop/engine/kept_options.h"
#include "desktop/engine/settings.h"
#include "desktop/files/files_setting_keys.h"
#include "desktop/files/testing/test_desk.h"
#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_recording.h"

namespace felt::desktop::file_actions_test {
namespace {

TEST(FileActions, WhatIsSavedOpensAsItWas) {
  TestDesk desk;
  desk.draw(1);
  desk.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}, "Ideas"});
  desk.draw(2);
  desk.studio.set_page({148.0, 210.0, {255, 250, 240, 255}});
  desk.studio.apply(SetOption{"ink.color", std::string("#204060")});
  desk.person->next = desk.at("one");  // the suffix is appended
  EXPECT_TRUE(desk.studio.is_modified());
  ASSERT_TRUE(desk.files->save());
  desk.files->finish_writing();
  EXPECT_FALSE(desk.studio.is_modified());
  EXPECT_EQ(desk.files->path(), desk.at("one.felt"));
  const Drawing before = desk.files->drawing();

  TestDesk other;
  QSignalSpy opened(&other.studio, &Studio::opened);
  ASSERT_TRUE(other.files->open(desk.at("one.felt")));
  EXPECT_EQ(opened.count(), 1);
  EXPECT_TRUE(other.files->drawing() == before);
  EXPECT_FALSE(other.studio.is_modified());
  EXPECT_FALSE(other.files->is_pristine());
}

TEST(FileActions, PaletteViewAndRecordingsTravelWithTheFile) {
  TestDesk desk;
  desk.draw(1);
  Drawing made = desk.files->drawing();
  FeltRecording recording;
  recording.device = "a pen";
  ASSERT_TRUE(add_recording(made, recording));
  made.palette = {"Leaves", 2, {{{10, 90, 20, 255}, "leaf"}}};
  made.view = Viewport{{12.0, 34.0}, 7.5, -30.0, true};
  ASSERT_TRUE(write_felt(desk.at("made.felt").toStdString(), made));

  TestDesk other;
  Drawing looks;  // palette and view of the window
  other.files->set_looks({.tell =
                              [&](Drawing& d) {
                                d.palette = looks.palette;
                                d.view = looks.view;
                              },
                          .show =
                              [&](const Drawing& d) {
                                looks.palette = d.palette;
                                looks.view = d.view;
                              }});
  ASSERT_TRUE(other.files->open(desk.at("made.felt")));
  EXPECT_EQ(looks.view, made.view);
  looks.view->px_per_mm = 2.0;
  other.draw(2);
  ASSERT_TRUE(other.files->save());
  other.files->finish_writing();
  const Drawing saved = read_felt(desk.at("made.felt").toStdString()).value();
  EXPECT_EQ(saved.palette, made.palette);
  EXPECT_EQ(saved.view->px_per_mm, 2.0);
  EXPECT_EQ(recordings_of(saved).value().size(), 1u);
  // Another drawing does not keep palette and view.
  other.files->show_unsaved(Document(), Page(), QStringLiteral("Example"));
  EXPECT_EQ(other.files->drawing().extras, nullptr);
}

TEST(FileActions, NothingIsLostUnasked) {
  TestDesk desk;
  desk.draw(1);
  const Document before = desk.document();
  EXPECT_FALSE(desk.files->may_close());
  desk.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_FALSE(desk.files->open(desk.at("none.felt")));
  EXPECT_EQ(desk.person->asked.size(), 2) << "a file that cannot be read takes no place";
  EXPECT_EQ(desk.person->errors.size(), 1);
  ASSERT_TRUE(write_drawing(desk.at("other.felt"), Drawing{}));
  EXPECT_FALSE(desk.files->open(desk.at("other.felt")));
  EXPECT_EQ(desk.person->asked.size(), 3);
  EXPECT_TRUE(desk.document() == before);

  desk.person->unsaved = FileDialogs::Unsaved::kSave;
  EXPECT_FALSE(desk.files->may_close()) << "no name was chosen, so it is not saved";
  desk.person->next = desk.at("kept.felt");
  EXPECT_TRUE(desk.files->may_close());
  EXPECT_TRUE(read_drawing(desk.at("kept.felt")).value().document == before);

  desk.draw(2);
  desk.person->unsaved = FileDialogs::Unsaved::kDiscard;
  desk.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(desk.document().stroke_count(), 0u);
  EXPECT_TRUE(desk.files->is_pristine());
}

TEST(FileActions, AFailedSaveKeepsTheDrawingModifiedAndSaysWhy) {
  TestDesk desk;
  desk.draw(1);
  desk.person->next = desk.at("no/folder.felt");
  QSignalSpy saved(desk.files, &FileActions::saved);
  desk.files->save();
  desk.files->finish_writing();
  ASSERT_EQ(saved.count(), 1);
  EXPECT_FALSE(saved[0][0].toBool());
  ASSERT_EQ(desk.person->errors.size(), 1);
  EXPECT_TRUE(desk.person->errors[0].contains(QStringLiteral("No such file")));
  EXPECT_TRUE(desk.studio.is_modified());
  desk.person->unsaved = FileDialogs::Unsaved::kSave;
  EXPECT_FALSE(desk.files->may_close());
  ASSERT_TRUE(desk.person->save_elsewhere);
  desk.person->next = desk.at("elsewhere.felt");
  desk.person->save_elsewhere();
  desk.files->finish_writing();
  EXPECT_FALSE(desk.studio.is_modified());
  EXPECT_EQ(desk.files->path(), desk.at("elsewhere.felt"));
}

TEST(FileActions, AFileThatOthersChangedMayBeSavedElsewhere) {
  TestDesk desk;
  desk.draw(1);
  desk.save_as("a.felt");
  desk.draw(2);
  QFile file(desk.at("a.felt"));
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime);
  file.close();
  desk.person->overwrite = FileDialogs::Overwrite::kSaveAs;
  desk.save_as("b.felt");
  EXPECT_EQ(desk.files->path(), desk.at("b.felt"));
  EXPECT_EQ(read_drawing(desk.at("a.felt")).value().document.stroke_count(), 3u);
}

TEST(FileActions, SaysThatAFileMayNotBeWritten) {
  TestDesk desk;
  ASSERT_TRUE(write_drawing(desk.at("a.felt"), Drawing{}));
  ASSERT_TRUE(desk.files->open(desk.at("a.felt")));
  EXPECT_FALSE(desk.files->is_read_only());
  ASSERT_TRUE(QFile::setPermissions(desk.at("a.felt"), QFile::ReadOwner));
  ASSERT_TRUE(desk.files->open(desk.at("a.felt")));
  EXPECT_TRUE(desk.files->is_read_only());
}

TEST(FileActions, ANewDrawingHasNotThePageOfTheFileBefore) {
  TestDesk desk;
  Drawing wide;
  wide.page.width_mm = 900.0;
  wide.page.paper = {200, 220, 255, 255};
  ASSERT_TRUE(write_drawing(desk.at("wide.felt"), wide));
  ASSERT_TRUE(desk.files->open(desk.at("wide.felt")));
  EXPECT_EQ(desk.studio.page().width_mm, 900.0);
  desk.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(desk.studio.page().width_mm, Page{}.width_mm);
  EXPECT_EQ(desk.studio.page().paper, Page{}.paper);
  // A page that the user set up here stays.
  Page mine = desk.studio.page();
  mine.width_mm = 333.0;
  desk.studio.set_page(mine);
  desk.person->unsaved = FileDialogs::Unsaved::kDiscard;
  desk.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(desk.studio.page().width_mm, 333.0);
}

TEST(FileActions, WhatIsDrawnDuringASaveStaysUnsaved) {
  TestDesk desk;
  desk.draw(1);
  desk.person->next = desk.at("a.felt");
  desk.files->save();
  desk.draw(2);
  desk.files->finish_writing();
  EXPECT_TRUE(desk.studio.is_modified());
  EXPECT_EQ(read_drawing(desk.at("a.felt")).value().document.stroke_count(), 3u);
}

// If the user undoes and redoes while the file is being written, the file contains the state at the
// start of the save.
TEST(FileActions, UndoDuringASaveIsAnUnsavedChange) {
  TestDesk desk;
  desk.draw(1);
  desk.save_as("a.felt");
  ASSERT_FALSE(desk.studio.is_modified());
  desk.draw(2);
  ASSERT_TRUE(desk.files->save());
  desk.studio.apply(UndoEvent{});
  ASSERT_FALSE(desk.studio.is_modified()) << "until the file is written it is as it was";
  desk.files->finish_writing();
  EXPECT_EQ(read_drawing(desk.at("a.felt")).value().document.stroke_count(), 6u);
  EXPECT_TRUE(desk.studio.is_modified()) << "the file has the lines that were undone";
  EXPECT_FALSE(desk.files->may_close());
  EXPECT_EQ(desk.person->asked.size(), 1) << "the person is asked, and stops it";
  desk.studio.apply(RedoEvent{});
  EXPECT_FALSE(desk.studio.is_modified());
  desk.draw(3);
  ASSERT_TRUE(desk.files->save());
  desk.studio.apply(UndoEvent{});
  desk.studio.apply(RedoEvent{});
  desk.files->finish_writing();
  EXPECT_FALSE(desk.studio.is_modified()) << "it is what the file has";
}

TEST(FileActions, TheColourOfAnOpenedDrawingIsNotKeptForTheNextStart) {
  const QString key = QStringLiteral("options/ink.color");
  Settings::the().reset(key);
  TestDesk desk;
  const KeptOptions kept(desk.studio);
  const auto ink = [](const Studio& studio) {
    return std::get<std::string>(studio.session().option("ink.color").value());
  };
  const std::string first = ink(desk.studio);
  Drawing board = desk.files->drawing();
  board.color = {0xF0, 0xF0, 0xEC};
  ASSERT_TRUE(write_drawing(desk.at("board.felt"), board).has_value());
  ASSERT_TRUE(desk.files->open(desk.at("board.felt")));
  EXPECT_EQ(ink(desk.studio), "#f0f0ec") << "the drawing has its colour";
  EXPECT_FALSE(desk.studio.is_modified());
  EXPECT_FALSE(Settings::the().value(key).isValid());
  {
    Studio next({.live = false});
    const KeptOptions at_start(next);
    EXPECT_EQ(ink(next), first);
  }
  desk.studio.apply(SetOption{"ink.color", std::string("#b02020")});
  ASSERT_TRUE(desk.files->open(desk.at("board.felt")));
  Studio next({.live = false});
  const KeptOptions at_start(next);
  EXPECT_EQ(ink(next), "#b02020") << "what the user chose last";
  Settings::the().reset(key);
}

/// Moves the pen along a line, on the surface or above it.
void move_pen(TestDesk& desk, bool down, double y_mm) {
  for (int i = 0; i < 50; ++i) {
    desk.studio.point({desk.studio.now_ns(), {20.0 + i, y_mm}, down, 0.5});
    desk.studio.advance(2'000'000);
  }
}

TEST(FileActions, ALineThatIsBeingDrawnIsAskedAboutAndSaved) {
  TestDesk desk;
  move_pen(desk, false, 30.0);
  move_pen(desk, true, 30.0);
  ASSERT_TRUE(desk.studio.session().gesture_in_work());
  EXPECT_EQ(desk.document().stroke_count(), 0u);
  EXPECT_FALSE(desk.files->may_close()) << "the person is asked, and stops it";
  EXPECT_EQ(desk.person->asked.size(), 1);
  EXPECT_EQ(desk.document().stroke_count(), 1u);
  move_pen(desk, false, 60.0);
  move_pen(desk, true, 60.0);
  ASSERT_TRUE(desk.studio.session().gesture_in_work());
  desk.person->unsaved = FileDialogs::Unsaved::kSave;
  desk.person->next = desk.at("line.felt");
  EXPECT_TRUE(desk.files->may_close());
  EXPECT_EQ(read_drawing(desk.at("line.felt")).value().document.stroke_count(), 2u);
}

TEST(FileActions, WhatEndsDuringTheLastSaveIsSavedBeforeTheWindowGoes) {
  TestDesk desk;
  desk.draw(1);
  desk.person->unsaved = FileDialogs::Unsaved::kSave;
  desk.person->next = desk.at("late.felt");
  // Runs in the event loop while the file is being written.
  QMetaObject::invokeMethod(
      &desk.studio, [&desk] { desk.draw(2); }, Qt::QueuedConnection);
  EXPECT_TRUE(desk.files->may_close());
  EXPECT_EQ(desk.document().stroke_count(), 6u);
  EXPECT_EQ(read_drawing(desk.at("late.felt")).value().document.stroke_count(), 6u);
}

TEST(FileActions, AFileChangedByOthersIsNotOverwrittenUnasked) {
  TestDesk desk;
  desk.draw(1);
  desk.person->next = desk.at("a.felt");
  desk.files->save();
  desk.files->finish_writing();
  QFile file(desk.at("a.felt"));
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addSecs(60),
                               QFileDevice::FileModificationTime));
  file.close();
  desk.draw(2);
  EXPECT_FALSE(desk.files->save());
  EXPECT_EQ(desk.person->asked, QStringList{QStringLiteral("a.felt")});
  desk.person->overwrite = FileDialogs::Overwrite::kReplace;
  EXPECT_TRUE(desk.files->save());
  desk.files->finish_writing();
  EXPECT_EQ(read_drawing(desk.at("a.felt")).value().document.stroke_count(), 6u);
}

TEST(FileActions, ANameThatGetsItsEndingDoesNotReplaceAFileUnasked) {
  TestDesk desk;
  desk.draw(1);
  desk.person->next = desk.at("a 1.2.felt");
  desk.files->save_as();
  desk.files->finish_writing();
  desk.draw(2);
  // The dialog asked about "a 1.2", which does not exist. Because "a 1.2.felt" exists, the program
  // then asks about that file.
  desk.person->next = desk.at("a 1.2");
  desk.person->then = desk.at("b.felt");
  EXPECT_TRUE(desk.files->save_as());
  desk.files->finish_writing();
  EXPECT_EQ(desk.person->suggested, desk.at("a 1.2.felt"));
  EXPECT_EQ(desk.files->path(), desk.at("b.felt"));
  EXPECT_EQ(read_drawing(desk.at("a 1.2.felt")).value().document.stroke_count(), 3u);
}

TEST(FileActions, OtherFormatsOpenWithoutAFileOfTheirOwn) {
  TestDesk desk;
  desk.draw(1);
  ASSERT_TRUE(write_drawing(desk.at("a.svg"), desk.files->drawing()));
  TestDesk other;
  ASSERT_TRUE(other.files->open(desk.at("a.svg")));
  EXPECT_EQ(other.files->path(), QString());
  EXPECT_EQ(other.files->display_name(), QStringLiteral("a"));
  other.files->save();
  EXPECT_EQ(other.person->suggested, desk.at("a.felt"));
}

TEST(FileActions, DroppedFilesOpenOrAreAdded) {
  TestDesk desk;
  desk.draw(1);
  ASSERT_TRUE(write_drawing(desk.at("a.felt"), desk.files->drawing()));
  TestDesk other;
  other.files->take_dropped({desk.at("a.felt"), desk.at("a.felt")});
  EXPECT_EQ(other.document().stroke_count(), 6u);
  EXPECT_EQ(other.files->path(), desk.at("a.felt"));
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
  TestDesk desk;
  QSignalSpy taken(desk.files, &FileActions::taken);
  ASSERT_TRUE(write_file(desk.at("notes.xopp").toStdString(), kNotes));
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(desk.at("notes.xopp"))});
  QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&desk.window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&desk.window, &drop);
  QApplication::processEvents();
  ASSERT_EQ(taken.count(), 1);
  EXPECT_EQ(desk.person->errors, QStringList());
  EXPECT_EQ(desk.document().stroke_count(), 1u);
  EXPECT_EQ(desk.files->path(), QString());
  EXPECT_EQ(desk.files->display_name(), QStringLiteral("notes"));
  const auto report = qvariant_cast<felt::ImportReport>(taken.at(0).at(1));
  ASSERT_EQ(report.notices().size(), 1u);
  EXPECT_EQ(report.notices()[0].line, 7);
  desk.draw(3, 1);
  // Save asks for a name, because a notes file cannot contain the whole drawing. The file does not
  // change.
  desk.save_as("notes");
  EXPECT_EQ(desk.person->suggested, desk.at("notes.felt"));
  EXPECT_EQ(desk.files->path(), desk.at("notes.felt"));
  EXPECT_EQ(read_file(desk.at("notes.xopp").toStdString(), 1 << 20).value(), kNotes);
  const Document before = desk.document();
  TestDesk again;
  ASSERT_TRUE(again.files->open(desk.at("notes.felt")));
  EXPECT_EQ(again.document(), before);
  EXPECT_EQ(again.files->path(), desk.at("notes.felt"));
}

TEST(FileActions, WhatADamagedDrawingStillHoldsIsOfferedAndTheFileLeftAlone) {
  TestDesk desk;
  desk.draw(1, 300);
  const QString path = desk.at("a.felt");
  ASSERT_TRUE(write_drawing(path, desk.files->drawing()));
  std::string bytes = read_file(path.toStdString(), 1 << 24).value();
  bytes.resize(bytes.size() - bytes.size() / 4);
  ASSERT_TRUE(write_file(path.toStdString(), bytes));
  TestDesk other;
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
  TestDesk desk;
  desk.studio.apply(UseMaterial{chalk[0]});
  desk.draw_with("soft-chalk");
  for (const char* name : {"a.felt", "a.svg"}) {
    ASSERT_TRUE(write_drawing(desk.at(name), desk.files->drawing()));
    TestDesk other;
    other.draw(1);
    QSignalSpy taken(other.files, &FileActions::taken);
    ASSERT_TRUE(other.files->import(desk.at(name)));
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
  TestDesk desk;
  desk.studio.apply(UseMaterial{write_material(soft_chalk(0.4))});
  desk.draw_with("soft-chalk");
  ASSERT_TRUE(write_drawing(desk.at("a.felt"), desk.files->drawing()));
  TestDesk other;
  other.studio.apply(UseMaterial{write_material(soft_chalk(0.6))});
  QSignalSpy taken(other.files, &FileActions::taken);
  ASSERT_TRUE(other.files->import(desk.at("a.felt")));
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
  TestDesk desk;
  Page page;
  page.surface = "slate";
  desk.studio.open(Document{}, page, texts);
  ASSERT_TRUE(desk.studio.apply(SetOption{"pencil.medium", std::string("soft-chalk")}));
  QSignalSpy refused(&desk.studio, &Studio::refused);
  desk.actions.find(QStringLiteral("file.new"))->trigger();
  EXPECT_EQ(refused.count(), 0);
  EXPECT_TRUE(desk.files->is_pristine());
  EXPECT_EQ(desk.studio.session().surface(), slate);
  EXPECT_EQ(desk.studio.session().option("pencil.medium").value(),
            OptionValue(std::string("soft-chalk")));
  EXPECT_EQ(desk.texts(), texts);
  desk.draw(1);
  desk.save_as("new.felt");
  TestDesk other;
  QSignalSpy other_refused(&other.studio, &Studio::refused);
  ASSERT_TRUE(other.files->open(desk.at("new.felt")));
  EXPECT_EQ(other_refused.count(), 0);
  EXPECT_EQ(other.studio.session().surface(), slate);
}

TEST(FileActions, FiguresThatChangeDuringASaveStayUnsaved) {
  Materials known = Materials::built_in();
  known.put(soft_chalk(0.4));
  TestDesk desk;
  desk.studio.set_user_materials(known);
  EXPECT_TRUE(desk.files->is_pristine()) << "to know a medium changes nothing";
  desk.draw_with("soft-chalk");
  desk.person->next = desk.at("a.felt");
  ASSERT_TRUE(desk.files->save());
  known.put(soft_chalk(0.6));
  desk.studio.set_user_materials(known);
  desk.files->finish_writing();
  EXPECT_TRUE(desk.studio.is_modified());
  EXPECT_EQ(read_drawing(desk.at("a.felt")).value().materials,
            Texts{write_material(soft_chalk(0.4))});
  ASSERT_TRUE(desk.files->save());
  desk.files->finish_writing();
  EXPECT_FALSE(desk.studio.is_modified());
  EXPECT_EQ(read_drawing(desk.at("a.felt")).value().materials,
            Texts{write_material(soft_chalk(0.6))});
  ASSERT_TRUE(desk.files->open(desk.at("a.felt")));
  EXPECT_FALSE(desk.studio.is_modified());
}

TEST(FileActions, RecentFilesAreRememberedWhileTheyAreThere) {
  Settings::the().set(files_keys::kRecent, QStringList());
  TestDesk desk;
  desk.draw(1);
  for (const char* name : {"a&b.felt", "b.felt"}) {
    ASSERT_TRUE(write_drawing(desk.at(name), desk.files->drawing()));
    desk.person->unsaved = FileDialogs::Unsaved::kDiscard;
    ASSERT_TRUE(desk.files->open(desk.at(name)));
  }
  const QMenu* menu = desk.files->recent_menu();
  ASSERT_EQ(menu->actions().size(), 4);
  EXPECT_EQ(menu->actions()[0]->text(), QStringLiteral("&1  b.felt"));
  EXPECT_EQ(menu->actions()[1]->text(), QStringLiteral("&2  a&&b.felt"));
  menu->actions()[1]->trigger();
  QTRY_COMPARE(desk.files->path(), desk.at("a&b.felt"));
  QFile::remove(desk.at("b.felt"));
  Q_EMIT desk.files->recent_menu()->aboutToShow();
  EXPECT_EQ(menu->actions().size(), 3);
  menu->actions().back()->trigger();
  QTest::qWait(1);
  EXPECT_FALSE(menu->actions()[0]->isEnabled());
}

}  // namespace
}  // namespace felt::desktop::file_actions_test
