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
#include "desktop/files/testing/studio_fixture.h"

namespace felt::desktop::studio_autosave_test {
namespace {

constexpr std::int64_t kStepNs = 10'000'000;

/// Performs step k of a fixed script that draws loops, lifts, undoes and changes layers.
void step(StudioFixture& fixture, int k) {
  const int in_line = k % 60;
  const double t = 0.05 * k;
  const Point at{60.0 + 30.0 * std::cos(t) + 0.1 * k, 60.0 + 30.0 * std::sin(1.7 * t)};
  const bool down = in_line >= 5 && in_line < 50;
  fixture.studio.point({fixture.studio.now_ns(), at, down, 0.3 + 0.2 * std::sin(t)});
  fixture.studio.advance(kStepNs);
  if (in_line == 57 && k % 240 > 180) fixture.studio.apply(UndoEvent{});
  if (in_line == 58 && k % 300 > 240)
    fixture.studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}, "L"});
}

/// Returns the drawing after `steps` steps, with the line in progress ended there.
Document reference(int steps) {
  StudioFixture fixture;
  for (int k = 0; k < steps; ++k) step(fixture, k);
  Document document = fixture.document();
  if (fixture.studio.session().gesture_in_progress()) {
    // Choosing a tool ends the gesture as if the pen had been lifted.
    fixture.studio.apply(SelectTool{"pull"});
    document = fixture.document();
  }
  return document;
}

/// Returns what would be recovered after a crash now.
Recovered crashed(const StudioFixture& fixture) {
  fixture.files->autosave()->flush();
  const Result<Recovered> recovered =
      recover_autosave(fixture.files->autosave()->folder().toStdString());
  EXPECT_TRUE(recovered) << (recovered ? "" : recovered.error().message);
  return recovered.value_or(Recovered{});
}

std::vector<AbandonedAutosave> abandoned_in(const QString& root) {
  return find_abandoned_autosaves({root.toStdString()});
}

TEST(StudioAutosave, WhateverWasDrawnIsRecoveredAtAnyStep) {
  for (const int steps : {1, 20, 49, 55, 130, 239, 240, 270, 299, 333}) {
    StudioFixture fixture;
    fixture.files->start_autosave({fixture.at("state")});
    for (int k = 0; k < steps; ++k) step(fixture, k);
    const Recovered recovered = crashed(fixture);
    const Document expected = reference(steps);
    EXPECT_EQ(recovered.drawing.document.stroke_count(), expected.stroke_count());
    EXPECT_TRUE(recovered.drawing.document == expected) << steps << " steps";
    fixture.studio.set_modified(false);
  }
}

/// Moves the hand to the right; the pen is down if `down`.
void move_right(Studio& studio, double from_x, double to_x, bool down) {
  for (double x = from_x; x <= to_x; x += 1.0) {
    studio.point({studio.now_ns(), {x, 80.0}, down, 0.5});
    studio.advance(kStepNs);
  }
}

// The loop's own samples are those of a pen below the page.
void expect_nothing_recovered(const std::function<void(Studio&, bool)>& set_elsewhere) {
  StudioOptions options{.live = false};
  options.device = QStringLiteral("simulated:touch");
  StudioFixture fixture(options);
  fixture.files->start_autosave({fixture.at("state")});
  Studio& studio = fixture.studio;
  move_right(studio, 20, 30, false);
  set_elsewhere(studio, true);
  move_right(studio, 30, 60, true);
  ASSERT_LT(studio.pen().sample.position.z, 0.0);
  EXPECT_EQ(crashed(fixture).drawing.document.stroke_count(), 0U);
  set_elsewhere(studio, false);
  move_right(studio, 60, 80, true);
  EXPECT_EQ(crashed(fixture).drawing.document.stroke_count(), 0U) << "until it is up";
  move_right(studio, 80, 90, false);
  move_right(studio, 90, 120, true);
  EXPECT_EQ(crashed(fixture).drawing.document.stroke_count(), 1U) << "the line in progress";
  EXPECT_EQ(fixture.document().stroke_count(), 0U);
  fixture.studio.set_modified(false);
}

TEST(StudioAutosave, NothingThatAPenDidOnBodiesIsRecovered) {
  const std::vector<Triangle3> far{{{200, 200, 5}, {210, 200, 5}, {200, 210, 5}}};
  expect_nothing_recovered([&far](Studio& studio, bool on) {
    studio.touch(on ? std::make_shared<const TriangleTree>(far) : nullptr);
  });
}

TEST(StudioAutosave, NothingThatALentPenDidIsRecovered) {
  expect_nothing_recovered([](Studio& studio, bool on) { studio.lend_pen(on); });
}

TEST(StudioAutosave, TheDrawingThatWasOpenedIsItsBase) {
  StudioFixture fixture;
  fixture.files->start_autosave({fixture.at("state")});
  fixture.draw(1);
  fixture.person->next = fixture.at("a.felt");
  fixture.files->save();
  fixture.files->finish_writing();
  EXPECT_FALSE(crashed(fixture).has_changes);
  ASSERT_TRUE(fixture.files->open(fixture.at("a.felt")));
  fixture.draw(2);
  fixture.studio.set_page({100.0, 50.0, {9, 8, 7, 255}});
  const Recovered recovered = crashed(fixture);
  EXPECT_TRUE(recovered.has_changes);
  EXPECT_EQ(recovered.name, "a.felt");
  EXPECT_EQ(recovered.path, fixture.at("a.felt").toStdString());
  EXPECT_TRUE(recovered.drawing.document == fixture.document());
  EXPECT_EQ(recovered.drawing.page, fixture.files->drawing().page);
  EXPECT_EQ(recovered.drawing, fixture.files->drawing());
}

/// Returns true if the autosave gets the medium without a user action, usually after half a
/// second.
bool keeps(const StudioFixture& fixture, const Medium& medium) {
  const std::string folder = fixture.files->autosave()->folder().toStdString();
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
  StudioFixture fixture;
  fixture.studio.set_user_materials(known);
  fixture.files->start_autosave({fixture.at("state")});
  EXPECT_TRUE(crashed(fixture).drawing.materials.empty());
  fixture.draw_with("soft-chalk");  // as a paste of a known medium does
  EXPECT_TRUE(keeps(fixture, soft_chalk(0.4)));
  known.put(soft_chalk(0.6));
  fixture.studio.set_user_materials(known);
  EXPECT_TRUE(keeps(fixture, soft_chalk(0.6)));
  known.put(soft_chalk(0.8));
  fixture.studio.set_user_materials(known);
  // The program must quit and does not wait half a second.
  EXPECT_EQ(crashed(fixture).drawing.materials,
            std::vector<std::string>{write_material(soft_chalk(0.8))});
}

TEST(StudioAutosave, AMediumThatComesWithStrokesAndComesBackByUndoIsKept) {
  const std::vector<std::string> chalk{write_material(soft_chalk(0.4))};
  StudioFixture fixture;
  fixture.studio.apply(UseMaterial{chalk[0]});
  fixture.draw_with("soft-chalk");
  ASSERT_TRUE(write_drawing(fixture.at("a.felt"), fixture.files->drawing()));
  StudioFixture other;
  other.files->start_autosave({other.at("state")});
  ASSERT_TRUE(other.files->import(fixture.at("a.felt")));
  EXPECT_EQ(crashed(other).drawing.materials, chalk);
  other.studio.apply(UndoEvent{});
  other.studio.set_page({100.0, 50.0, {9, 8, 7, 255}});  // the materials are collected again
  EXPECT_TRUE(crashed(other).drawing.materials.empty());
  other.studio.apply(RedoEvent{});
  EXPECT_EQ(crashed(other).drawing.materials, chalk);
}

TEST(StudioAutosave, ADrawingThatOthersOpenIsABaseToo) {
  StudioFixture fixture;
  fixture.files->start_autosave({fixture.at("state")});
  fixture.draw(1);
  Document example = fixture.document();
  fixture.draw(2);
  fixture.studio.open(example, {120.0, 90.0, {255, 255, 255, 255}});
  fixture.draw(3);
  const Recovered recovered = crashed(fixture);
  EXPECT_TRUE(recovered.drawing.document == fixture.document());
  EXPECT_EQ(recovered.drawing.page, fixture.files->drawing().page);
}

TEST(StudioAutosave, ACleanCloseLeavesNothingAndACrashLeavesAStore) {
  QTemporaryDir root;
  {
    StudioFixture fixture;
    fixture.files->start_autosave({root.path()});
    fixture.draw(1);
    EXPECT_TRUE(abandoned_in(root.path()).empty()) << "its owner lives";
    fixture.person->unsaved = FileDialogs::Unsaved::kDiscard;
    EXPECT_TRUE(fixture.files->may_close());
  }
  EXPECT_EQ(QDir(root.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 0);
  {
    StudioFixture fixture;
    fixture.files->start_autosave({root.path()});
    fixture.draw(1);  // the window is closed without asking the user
  }
  std::vector<AbandonedAutosave> left = abandoned_in(root.path());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(recover_autosave(left[0].folder).value().drawing.document.stroke_count(), 3u);
  EXPECT_TRUE(std::move(left[0]).remove());
  EXPECT_TRUE(abandoned_in(root.path()).empty());
}

/// The warning stays as long as the autosave fails, and disappears when it works again.
TEST(StudioAutosave, AFailureIsShownAndNothingElseHappens) {
  StudioFixture fixture;
  QFile file(fixture.at("state"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));  // a file at the path of the folder
  auto* bar = new QStatusBar(&fixture.window);
  fixture.files->start_autosave({fixture.at("state")});
  const auto warnings = [bar] {
    QStringList names;
    for (const QLabel* label : bar->findChildren<QLabel*>()) names << label->accessibleName();
    return names;
  };
  QSignalSpy changed(fixture.files->autosave(), &StudioAutosave::status_changed);
  fixture.draw(1);
  EXPECT_TRUE(changed.count() > 0 || changed.wait(5000));
  EXPECT_EQ(warnings(), QStringList(QStringLiteral("No crash protection: save often")));
  EXPECT_EQ(fixture.document().stroke_count(), 3u);
  const auto report = [&fixture](AutosaveStatus::State state) {
    Q_EMIT fixture.files->autosave()->status_changed({state, "disk full", "/elsewhere"});
  };
  report(AutosaveStatus::State::kElsewhere);
  EXPECT_EQ(warnings(), QStringList(QStringLiteral("Autosave in another place")));
  report(AutosaveStatus::State::kWorking);
  EXPECT_EQ(warnings(), QStringList());
}

/// Offers only drawings that differ from their files; removes all other autosaves.
TEST(StudioAutosave, OffersWhatNoFileHas) {
  QTemporaryDir root;
  const auto crash = [&root](const char* file, bool saves, int more) {
    StudioFixture fixture;
    fixture.files->start_autosave({root.path()});
    fixture.draw(1);
    if (saves) {
      fixture.person->next = root.filePath(QString::fromUtf8(file));
      fixture.files->save();
      fixture.files->finish_writing();
    }
    if (more > 0) fixture.draw(2, more);
    fixture.studio.set_modified(true);  // otherwise closing the window would delete the autosave
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
    StudioFixture fixture;
    fixture.files->start_autosave({root.path()});
    fixture.draw(1);
  }
  StudioFixture fixture;
  fixture.window.show();
  fixture.files->offer_recovery({root.path()});
  fixture.files->finish_writing();
  QCoreApplication::processEvents();
  auto* dialog = fixture.window.findChild<RecoveryDialog*>();
  ASSERT_TRUE(dialog);
  for (QPushButton* key : dialog->findChildren<QPushButton*>()) {
    if (key->accessibleDescription().startsWith(QStringLiteral("Recover"))) key->click();
  }
  EXPECT_EQ(fixture.document().stroke_count(), 3u);
  EXPECT_TRUE(fixture.studio.is_modified());
  EXPECT_EQ(fixture.files->display_name(), QStringLiteral("Recovered Untitled"));
  const auto folders = [&root] {
    return QDir(root.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size();
  };
  EXPECT_EQ(folders(), 1);
  fixture.person->next = fixture.at("b.felt");
  fixture.files->save();
  fixture.files->finish_writing();
  EXPECT_EQ(folders(), 0);
}

}  // namespace
}  // namespace felt::desktop::studio_autosave_test
