#include "desktop/files/studio_autosave.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <cmath>

#include "desktop/files/recovery_dialog.h"
#include "desktop/files/recovery_offer.h"
#include "desktop/files/testing/test_desk.h"

namespace felt::desktop::studio_autosave_test {
namespace {

constexpr std::int64_t kStepNs = 10'000'000;

/// Performs step k of a fixed script that draws loops, lifts, undoes and changes layers.
void step(TestDesk& desk, int k) {
  const int in_line = k % 60;
  const double t = 0.05 * k;
  const Point at{60.0 + 30.0 * std::cos(t) + 0.1 * k, 60.0 + 30.0 * std::sin(1.7 * t)};
  const bool down = in_line >= 5 && in_line < 50;
  desk.studio.point({desk.studio.now_ns(), at, down, 0.3 + 0.2 * std::sin(t)});
  desk.studio.advance(kStepNs);
  if (in_line == 57 && k % 240 > 180) desk.studio.apply(UndoEvent{});
  if (in_line == 58 && k % 300 > 240) desk.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}, "L"});
}

/// Returns the drawing after `steps` steps, with the line in progress ended there.
Document reference(int steps) {
  TestDesk desk;
  for (int k = 0; k < steps; ++k) step(desk, k);
  Document document = desk.document();
  if (desk.studio.session().gesture_in_work()) {
    // Choosing a tool ends the gesture as if the pen had been lifted.
    desk.studio.apply(SelectTool{"pull"});
    document = desk.document();
  }
  return document;
}

/// Returns what would be recovered after a crash now.
Recovered crashed(const TestDesk& desk) {
  desk.files->autosave()->flush();
  const Result<Recovered> recovered =
      recover_autosave(desk.files->autosave()->folder().toStdString());
  EXPECT_TRUE(recovered) << (recovered ? "" : recovered.error().message);
  return recovered.value_or(Recovered{});
}

std::vector<AbandonedAutosave> abandoned_in(const QString& root) {
  return find_abandoned_autosaves({root.toStdString()});
}

TEST(StudioAutosave, WhateverWasDrawnIsRecoveredAtAnyStep) {
  for (const int steps : {1, 20, 49, 55, 130, 239, 240, 270, 299, 333}) {
    TestDesk desk;
    desk.files->start_autosave({desk.at("state")});
    for (int k = 0; k < steps; ++k) step(desk, k);
    const Recovered recovered = crashed(desk);
    const Document expected = reference(steps);
    EXPECT_EQ(recovered.drawing.document.stroke_count(), expected.stroke_count());
    EXPECT_TRUE(recovered.drawing.document == expected) << steps << " steps";
    desk.studio.set_modified(false);
  }
}

TEST(StudioAutosave, TheDrawingThatWasOpenedIsItsBase) {
  TestDesk desk;
  desk.files->start_autosave({desk.at("state")});
  desk.draw(1);
  desk.person->next = desk.at("a.felt");
  desk.files->save();
  desk.files->finish_writing();
  EXPECT_FALSE(crashed(desk).has_changes);
  ASSERT_TRUE(desk.files->open(desk.at("a.felt")));
  desk.draw(2);
  desk.studio.set_page({100.0, 50.0, {9, 8, 7, 255}});
  const Recovered recovered = crashed(desk);
  EXPECT_TRUE(recovered.has_changes);
  EXPECT_EQ(recovered.name, "a.felt");
  EXPECT_EQ(recovered.path, desk.at("a.felt").toStdString());
  EXPECT_TRUE(recovered.drawing.document == desk.document());
  EXPECT_EQ(recovered.drawing.page, desk.files->drawing().page);
  EXPECT_EQ(recovered.drawing, desk.files->drawing());
}

/// Returns true if the autosave gets the medium without a user action, usually after half a
/// second.
bool keeps(const TestDesk& desk, const Medium& medium) {
  const std::string folder = desk.files->autosave()->folder().toStdString();
  return QTest::qWaitFor(
      [&] {
        // If the database is being written, its copy may be readable only in part.
        const Result<Recovered> recovered = recover_autosave(folder);
        return recovered &&
               recovered->drawing.materials == std::vector<std::string>{write_material(medium)};
      },
      10'000);
}

TEST(StudioAutosave, TheFiguresOfWhatIsDrawnWithAreKept) {
  Materials known = Materials::built_in();
  known.put(soft_chalk(0.4));
  TestDesk desk;
  desk.studio.set_user_materials(known);
  desk.files->start_autosave({desk.at("state")});
  EXPECT_TRUE(crashed(desk).drawing.materials.empty());
  desk.draw_with("soft-chalk");  // as a paste of a known medium does
  EXPECT_TRUE(keeps(desk, soft_chalk(0.4)));
  known.put(soft_chalk(0.6));
  desk.studio.set_user_materials(known);
  EXPECT_TRUE(keeps(desk, soft_chalk(0.6)));
  known.put(soft_chalk(0.8));
  desk.studio.set_user_materials(known);
  // The program must quit and does not wait half a second.
  EXPECT_EQ(crashed(desk).drawing.materials,
            std::vector<std::string>{write_material(soft_chalk(0.8))});
}

TEST(StudioAutosave, AMediumThatComesWithStrokesAndComesBackByUndoIsKept) {
  const std::vector<std::string> chalk{write_material(soft_chalk(0.4))};
  TestDesk desk;
  desk.studio.apply(UseMaterial{chalk[0]});
  desk.draw_with("soft-chalk");
  ASSERT_TRUE(write_drawing(desk.at("a.felt"), desk.files->drawing()));
  TestDesk other;
  other.files->start_autosave({other.at("state")});
  ASSERT_TRUE(other.files->import(desk.at("a.felt")));
  EXPECT_EQ(crashed(other).drawing.materials, chalk);
  other.studio.apply(UndoEvent{});
  other.studio.set_page({100.0, 50.0, {9, 8, 7, 255}});  // the materials are collected again
  EXPECT_TRUE(crashed(other).drawing.materials.empty());
  other.studio.apply(RedoEvent{});
  EXPECT_EQ(crashed(other).drawing.materials, chalk);
}

TEST(StudioAutosave, ADrawingThatOthersOpenIsABaseToo) {
  TestDesk desk;
  desk.files->start_autosave({desk.at("state")});
  desk.draw(1);
  Document example = desk.document();
  desk.draw(2);
  desk.studio.open(example, {120.0, 90.0, {255, 255, 255, 255}});
  desk.draw(3);
  const Recovered recovered = crashed(desk);
  EXPECT_TRUE(recovered.drawing.document == desk.document());
  EXPECT_EQ(recovered.drawing.page, desk.files->drawing().page);
}

TEST(StudioAutosave, ACleanCloseLeavesNothingAndACrashLeavesAStore) {
  QTemporaryDir root;
  {
    TestDesk desk;
    desk.files->start_autosave({root.path()});
    desk.draw(1);
    EXPECT_TRUE(abandoned_in(root.path()).empty()) << "its owner lives";
    desk.person->unsaved = FileDialogs::Unsaved::kDiscard;
    EXPECT_TRUE(desk.files->may_close());
  }
  EXPECT_EQ(QDir(root.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 0);
  {
    TestDesk desk;
    desk.files->start_autosave({root.path()});
    desk.draw(1);  // the window is closed without asking the user
  }
  std::vector<AbandonedAutosave> left = abandoned_in(root.path());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(recover_autosave(left[0].folder).value().drawing.document.stroke_count(), 3u);
  EXPECT_TRUE(std::move(left[0]).remove());
  EXPECT_TRUE(abandoned_in(root.path()).empty());
}

/// The warning stays as long as the autosave fails, and disappears when it works again.
TEST(StudioAutosave, AFailureIsShownAndNothingElseHappens) {
  TestDesk desk;
  QFile file(desk.at("state"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));  // a file at the path of the folder
  auto* bar = new QStatusBar(&desk.window);
  desk.files->start_autosave({desk.at("state")});
  const auto warnings = [bar] {
    QStringList names;
    for (const QLabel* label : bar->findChildren<QLabel*>()) names << label->accessibleName();
    return names;
  };
  QSignalSpy changed(desk.files->autosave(), &StudioAutosave::status_changed);
  desk.draw(1);
  EXPECT_TRUE(changed.count() > 0 || changed.wait(5000));
  EXPECT_EQ(warnings(), QStringList(QStringLiteral("No crash protection: save often")));
  EXPECT_EQ(desk.document().stroke_count(), 3u);
  const auto tell = [&desk](AutosaveStatus::State state) {
    Q_EMIT desk.files->autosave()->status_changed({state, "disk full", "/elsewhere"});
  };
  tell(AutosaveStatus::State::kElsewhere);
  EXPECT_EQ(warnings(), QStringList(QStringLiteral("Autosave in another place")));
  tell(AutosaveStatus::State::kWorking);
  EXPECT_EQ(warnings(), QStringList());
}

/// Offers only drawings that differ from their files; removes all other autosaves.
TEST(StudioAutosave, OffersWhatNoFileHas) {
  QTemporaryDir root;
  const auto crash = [&root](const char* file, bool saves, int more) {
    TestDesk desk;
    desk.files->start_autosave({root.path()});
    desk.draw(1);
    if (saves) {
      desk.person->next = root.filePath(QString::fromUtf8(file));
      desk.files->save();
      desk.files->finish_writing();
    }
    if (more > 0) desk.draw(2, more);
    desk.studio.set_modified(true);  // otherwise closing the window would delete the autosave
  };
  crash("a.felt", true, 2);
  crash("", false, 0);
  std::vector<RecoveryOffer> offers = read_offers(abandoned_in(root.path()));
  ASSERT_EQ(offers.size(), 2u);
  const bool first_is_saved = offers[0].saved.has_value();
  const RecoveryOffer& saved = offers[first_is_saved ? 0 : 1];
  const RecoveryOffer& untitled = offers[first_is_saved ? 1 : 0];
  ASSERT_TRUE(saved.saved);
  EXPECT_EQ(saved.saved->drawing.document.stroke_count(), 3u);
  EXPECT_EQ(saved.recovered.drawing.document.stroke_count(), 5u);
  EXPECT_FALSE(untitled.saved);
  EXPECT_EQ(untitled.recovered.drawing.document.stroke_count(), 3u);
}

TEST(StudioAutosave, RecoveringKeepsTheStoreUntilItIsSaved) {
  QTemporaryDir root;
  {
    TestDesk desk;
    desk.files->start_autosave({root.path()});
    desk.draw(1);
  }
  TestDesk desk;
  desk.window.show();
  desk.files->offer_recovery({root.path()});
  desk.files->finish_writing();
  QCoreApplication::processEvents();
  auto* dialog = desk.window.findChild<RecoveryDialog*>();
  ASSERT_TRUE(dialog);
  for (QPushButton* key : dialog->findChildren<QPushButton*>()) {
    if (key->accessibleDescription().startsWith(QStringLiteral("Recover"))) key->click();
  }
  EXPECT_EQ(desk.document().stroke_count(), 3u);
  EXPECT_TRUE(desk.studio.is_modified());
  EXPECT_EQ(desk.files->display_name(), QStringLiteral("Recovered Untitled"));
  const auto folders = [&root] {
    return QDir(root.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size();
  };
  EXPECT_EQ(folders(), 1);
  desk.person->next = desk.at("b.felt");
  desk.files->save();
  desk.files->finish_writing();
  EXPECT_EQ(folders(), 0);
}

}  // namespace
}  // namespace felt::desktop::studio_autosave_test
