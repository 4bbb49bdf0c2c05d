#include "desktop/window/main_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QMap>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <csignal>
#include <memory>

#include "desktop/engine/settings.h"
#include "desktop/help/about_dialog.h"
#include "desktop/help/examples.h"
#include "desktop/help/guide_dialog.h"
#include "desktop/help/shortcut_sheet.h"
#include "desktop/help/tour_window.h"
#include "desktop/panels/tactile_panel.h"
#ifdef FELT_SOLIDS
#include "desktop/solid/solid_panel.h"
#endif
#include "desktop/testing/accessible_names.h"
#include "desktop/window/preferences.h"
#include "desktop/window/shortcuts_page.h"
#include "desktop/window/signal_watch.h"
#include "desktop/window/tool_keys.h"
#include "desktop/window/window_setting_keys.h"
#include "desktop/window/windows.h"

namespace felt::desktop::main_window_test {
namespace {

using ::testing::IsEmpty;

StudioOptions still() {
  return {.device = QStringLiteral("tablet"), .live = false};
}

std::string tool_of(MainWindow& window) {
  return std::string(window.studio().session().tool().info().id);
}

void collect(const QList<QAction*>& actions, QSet<QAction*>& all) {
  for (QAction* action : actions) {
    all.insert(action);
    if (action->menu()) collect(action->menu()->actions(), all);
  }
}

std::unique_ptr<MainWindow> shown_window() {
  auto window = std::make_unique<MainWindow>(still());
  window->show();
  window->activateWindow();
  static_cast<void>(QTest::qWaitForWindowActive(window.get()));
  window->canvas().setFocus();
  return window;
}

/// Puts the pen on the page if `down`, otherwise lifts it.
void touch(MainWindow& window, bool down) {
  Studio& studio = window.studio();
  studio.point(
      {.time_ns = studio.now_ns(), .position = {50, 50}, .touching = down, .pressure = 0.5});
  studio.advance(40'000'000);
}

TEST(MainWindow, EveryActionIsInAMenuOrABar) {
  MainWindow window(still());
  QSet<QAction*> reachable;
  collect(window.menuBar()->actions(), reachable);
  for (QToolBar* bar : window.findChildren<QToolBar*>()) collect(bar->actions(), reachable);
  ASSERT_FALSE(window.actions().all().isEmpty());
  for (QAction* action : window.actions().all()) {
    EXPECT_TRUE(reachable.contains(action)) << action->objectName().toStdString();
  }
}

TEST(MainWindow, EveryActionHasATextAndATip) {
  MainWindow window(still());
  for (const QAction* action : window.actions().all()) {
    EXPECT_FALSE(action->text().isEmpty()) << action->objectName().toStdString();
    EXPECT_FALSE(action->statusTip().isEmpty()) << action->objectName().toStdString();
  }
}

TEST(MainWindow, NoTwoActionsShareAKey) {
  MainWindow window(still());
  QMap<QString, QString> owners;
  for (const QAction* action : window.actions().all()) {
    for (const QKeySequence& key : action->shortcuts()) {
      QString& owner = owners[key.toString()];
      EXPECT_TRUE(owner.isEmpty()) << key.toString().toStdString() << ": " << owner.toStdString()
                                   << " and " << action->objectName().toStdString();
      owner = action->objectName();
    }
  }
}

TEST(MainWindow, TheKeysOfThePeersDoWhatPeopleExpect) {
  MainWindow window(still());
  const std::pair<const char*, const char*> expected[] = {
      {"P", "tool.pencil"},        {"E", "tool.eraser"},          {"V", "tool.lasso"},
      {"A", "tool.pull"},          {"W", "tool.width"},           {"S", "tool.smooth"},
      {"C", "tool.connect"},       {"T", "tool.transform"},       {"Ctrl+Z", "edit.undo"},
      {"Ctrl+Y", "edit.redo"},     {"Ctrl+Shift+Z", "edit.redo"}, {"Esc", "edit.cancel"},
      {"X", "tool.swap"},          {"?", "help.shortcuts"},       {"Tab", "view.hide_panels"},
      {"F11", "view.full_screen"}, {"R", "tool.recolor"},         {"I", "edit.pick_color"}};
  for (const auto& [key, name] : expected) {
    const QAction* owner = window.actions().owner_of(QKeySequence(QString::fromLatin1(key)));
    ASSERT_TRUE(owner) << key;
    EXPECT_EQ(owner->objectName().toStdString(), name) << key;
  }
}

TEST(MainWindow, EveryControlHasAName) {
  MainWindow window(still());
  Preferences preferences(window);
  for (const QString& page : preferences.page_names()) EXPECT_TRUE(preferences.page(page));
  GuideDialog guide(window.actions());
  ShortcutSheet shortcuts(window.actions());
  AboutDialog about;
  TourWindow tour;
  for (QWidget* widget : std::initializer_list<QWidget*>{
           &window, &preferences, &guide, &shortcuts, &about, &tour, &window.material_editor()}) {
    EXPECT_THAT(nameless_controls(*widget).join(QStringLiteral(", ")).toStdString(), IsEmpty())
        << widget->metaObject()->className();
  }
}

#ifdef FELT_SOLIDS
TEST(MainWindow, TheSolidViewIsClosedAtFirstAndFollowsTheDrawingWhenItIsOpened) {
  MainWindow window(still());
  window.resize(1280, 800);
  window.show();
  QAction* action = window.actions().owner_of(QKeySequence(Qt::Key_F9));
  ASSERT_TRUE(action);
  EXPECT_EQ(action->objectName().toStdString(), "view.panel_solid");
  EXPECT_FALSE(action->isChecked());
  auto* solid = window.findChild<SolidPanel*>();
  ASSERT_TRUE(solid);
  window.studio().open(example_document(QStringLiteral("cat")), Page{});
  QTest::qWait(2 * SolidPanel::kWaitMs);
  EXPECT_FALSE(solid->solid());
  action->trigger();
  ASSERT_TRUE(QTest::qWaitFor(
      [solid] { return solid->is_up_to_date() && solid->solid() != nullptr; }, 20000));
  EXPECT_EQ(solid->solid()->bodies.size(), 1U) << "the cat is one body, although its lines are 79";
  EXPECT_GE(solid->width(), 350);
  EXPECT_TRUE(window.actions().find(QStringLiteral("file.export_solid_stl"))->isEnabled());
}
#endif

TEST(MainWindow, TheTactileCheckStartsAlsoWhileAllPanelsAreHidden) {
  const auto window = shown_window();
  QAction* hide = window->actions().find(QStringLiteral("view.hide_panels"));
  QAction* open = window->actions().find(QStringLiteral("view.panel_tactile"));
  auto* tactile = window->findChild<TactilePanel*>();
  ASSERT_TRUE(tactile);
  window->studio().open(example_document(QStringLiteral("cat")), Page{});
  const auto checks = [tactile] {
    return QTest::qWaitFor(
        [tactile] { return tactile->is_up_to_date() && !tactile->faults().empty(); }, 20000);
  };
  hide->trigger();
  open->trigger();
  EXPECT_TRUE(checks()) << "opened while all panels are hidden";
  QSignalSpy marks(tactile, &TactilePanel::marks_changed);
  hide->trigger();
  hide->trigger();
  EXPECT_EQ(marks.count(), 0) << "the marks stay while all panels are hidden";
  hide->trigger();
  open->trigger();
  EXPECT_EQ(marks.count(), 1) << "it was closed, and the marks are gone";
}

TEST(MainWindow, WhatAPersonMakesIsInEveryListAtOnce) {
  MainWindow one(still()), other(still());
  SurfaceMaterial slate = *find_surface("blackboard");
  slate.id = "slate";
  slate.label = "Slate";
  Medium graphite = *find_medium("pencil");
  graphite.id = "graphite";
  graphite.label = "Graphite";
  UserMaterials::the().put(slate);
  UserMaterials::the().put(graphite);
  const auto lists = [](MainWindow& window) {
    window.materials().report_now();
    int found = 0;
    for (const char* name : {"top_surfaces", "top_media"}) {
      auto* box = window.findChild<QComboBox*>(QString::fromLatin1(name));
      found += box->findText(QStringLiteral("Slate")) >= 0;
      found += box->findText(QStringLiteral("Graphite")) >= 0;
    }
    for (const auto* button : window.findChildren<QAbstractButton*>()) {
      // If there is not enough space, the text of a button may be shorter than its accessible name.
      const QString name =
          button->accessibleName().isEmpty() ? button->text() : button->accessibleName();
      found += !button->isHidden() &&
               (name == QStringLiteral("Slate") || name == QStringLiteral("Graphite"));
    }
    return found;
  };
  EXPECT_EQ(lists(one), 4);
  EXPECT_EQ(lists(other), 4) << "and in every window";
  auto* surfaces = one.findChild<QComboBox*>(QStringLiteral("top_surfaces"));
  const int row = surfaces->findText(QStringLiteral("Slate"));
  surfaces->setCurrentIndex(row);
  Q_EMIT surfaces->activated(row);
  EXPECT_EQ(one.studio().session().surface().id, "slate");
  one.studio().apply(SetOption{"surface.material", OptionValue(std::string("paper"))});
  UserMaterials::the().revert({true, "slate"});
  UserMaterials::the().revert({false, "graphite"});
  EXPECT_EQ(lists(one), 0);
}

TEST(MainWindow, TheMaterialsWindowOpensByMenuKeyAndPanel) {
  const auto window = shown_window();
  QAction* open = window->actions().find(QStringLiteral("view.materials"));
  ASSERT_TRUE(open);
  open->trigger();
  EXPECT_TRUE(window->material_editor().isVisible());
  window->material_editor().close();
  for (auto* button : window->findChildren<QToolButton*>()) {
    if (button->accessibleName() == QStringLiteral("Edit surfaces and media")) button->click();
  }
  EXPECT_TRUE(window->material_editor().isVisible());
}

TEST(MainWindow, HidesAllPanelsAndShowsTheSameOnesAgain) {
  const auto window = shown_window();
  QAction* hide = window->actions().find(QStringLiteral("view.hide_panels"));
  QStringList before, after;
  const auto seen = [&window](QStringList& names) {
    for (QDockWidget* panel : window->findChildren<QDockWidget*>()) {
      if (!panel->isHidden()) names.push_back(panel->objectName());
    }
  };
  seen(before);
  hide->trigger();
  QStringList none;
  seen(none);
  EXPECT_TRUE(none.isEmpty());
  hide->trigger();
  seen(after);
  EXPECT_EQ(before, after);
  EXPECT_FALSE(before.contains(QStringLiteral("forces")));
}

TEST(ToolKeys, ATapTakesTheToolForGood) {
  const auto window = shown_window();
  QTest::keyPress(&window->canvas(), Qt::Key_E);
  EXPECT_EQ(tool_of(*window), "eraser");
  QTest::keyRelease(&window->canvas(), Qt::Key_E);
  touch(*window, true);
  touch(*window, false);
  EXPECT_EQ(tool_of(*window), "eraser");
}

TEST(ToolKeys, AKeyThatIsHeldWhileItsToolIsUsedGivesTheFormerToolBack) {
  const auto window = shown_window();
  QTest::keyPress(&window->canvas(), Qt::Key_E);
  touch(*window, true);
  QTest::qWait(ToolKeys::kHoldMs + 50);
  touch(*window, false);
  EXPECT_EQ(tool_of(*window), "eraser");
  QTest::keyRelease(&window->canvas(), Qt::Key_E);
  EXPECT_EQ(tool_of(*window), "pencil");
}

TEST(ToolKeys, AGestureThatGoesOnKeepsItsToolUntilThePenIsLifted) {
  const auto window = shown_window();
  QTest::keyPress(&window->canvas(), Qt::Key_E);
  touch(*window, true);
  QTest::qWait(ToolKeys::kHoldMs + 50);
  QTest::keyRelease(&window->canvas(), Qt::Key_E);
  EXPECT_EQ(tool_of(*window), "eraser");
  touch(*window, false);
  EXPECT_EQ(tool_of(*window), "pencil");
}

TEST(ToolKeys, AKeyThatIsHeldWithoutUseTakesTheToolForGood) {
  const auto window = shown_window();
  QTest::keyPress(&window->canvas(), Qt::Key_W);
  QTest::qWait(ToolKeys::kHoldMs + 50);
  QTest::keyRelease(&window->canvas(), Qt::Key_W);
  EXPECT_EQ(tool_of(*window), "width");
}

TEST(ToolKeys, XIsTheEraserAsLongAsItIsHeld) {
  const auto window = shown_window();
  QTest::keyPress(&window->canvas(), Qt::Key_X);
  EXPECT_EQ(tool_of(*window), "eraser");
  QTest::keyRelease(&window->canvas(), Qt::Key_X);
  EXPECT_EQ(tool_of(*window), "pencil");
}

TEST(ToolKeys, LosingTheWindowIsARelease) {
  const auto window = shown_window();
  QTest::keyPress(&window->canvas(), Qt::Key_X);
  EXPECT_EQ(tool_of(*window), "eraser");
  QEvent lost(QEvent::WindowDeactivate);
  QApplication::sendEvent(window.get(), &lost);
  EXPECT_EQ(tool_of(*window), "pencil");
}

TEST(ShortcutsPage, AKeyOfAnotherCommandIsTakenOverOnlyOnDemand) {
  MainWindow window(still());
  Actions& actions = window.actions();
  ShortcutsPage page(actions);
  page.select(QStringLiteral("tool.pull"));
  page.press(QKeySequence(Qt::Key_W));
  EXPECT_TRUE(page.has_conflict());
  EXPECT_EQ(actions.owner_of(QKeySequence(Qt::Key_W))->objectName(), QStringLiteral("tool.width"));
  page.take_over();
  EXPECT_FALSE(page.has_conflict());
  EXPECT_EQ(actions.owner_of(QKeySequence(Qt::Key_W))->objectName(), QStringLiteral("tool.pull"));
  EXPECT_TRUE(actions.find(QStringLiteral("tool.width"))->shortcuts().isEmpty());
  for (QAction* action : actions.all()) actions.reset_keys(action->objectName());
  EXPECT_EQ(actions.owner_of(QKeySequence(Qt::Key_W))->objectName(), QStringLiteral("tool.width"));
}

TEST(ShortcutsPage, AKeyThatIsChosenCountsInEveryWindow) {
  MainWindow one(still()), other(still());
  one.actions().set_keys(QStringLiteral("edit.duplicate"), {QKeySequence(Qt::Key_F8)});
  const QAction* there = other.actions().find(QStringLiteral("edit.duplicate"));
  EXPECT_EQ(there->shortcut(), QKeySequence(Qt::Key_F8));
  EXPECT_TRUE(there->toolTip().contains(QStringLiteral("F8")));
  one.actions().reset_keys(QStringLiteral("edit.duplicate"));
  EXPECT_EQ(there->shortcuts(), other.actions().default_keys(QStringLiteral("edit.duplicate")));
}

TEST(MainWindow, TheTitleSaysNameAndState) {
  MainWindow window(still());
  EXPECT_TRUE(window.windowTitle().contains(QStringLiteral("Feltline")));
  EXPECT_FALSE(window.isWindowModified());
  window.studio().set_modified(true);
  EXPECT_TRUE(window.isWindowModified());
  window.studio().set_modified(false);
}

TEST(Windows, AnExampleKeepsItsNameAndTakesOnlyAWindowWithNothingInIt) {
  Windows windows(still());
  MainWindow* first = windows.open();
  Document drawing;
  EXPECT_EQ(windows.open_drawing(drawing, QStringLiteral("A cat[*]"), first), first);
  EXPECT_EQ(first->files().display_name(), QStringLiteral("A cat[*]"));
  EXPECT_TRUE(first->windowTitle().startsWith(QStringLiteral("A cat")));
  EXPECT_FALSE(first->isWindowModified());
  MainWindow* second = windows.open_drawing(drawing, QStringLiteral("A dog"), first);
  EXPECT_NE(second, first) << "the first shows an example, and is not to be replaced";
  delete second;
  delete first;
}

TEST(Windows, ASignalEndsThemWithoutForceAndKeepsWhatWasDrawn) {
  QDir working(QDir::tempPath() + QStringLiteral("/felt-signal-test"));
  working.removeRecursively();
  Windows windows(still());
  QPointer<MainWindow> window = windows.open();
  window->files().start_autosave({working.path()});
  touch(*window, true);
  touch(*window, false);
  window->studio().advance(300'000'000);
  ASSERT_TRUE(window->studio().is_modified());
  window->studio().loop().set_forces(true);
  const SignalWatch signals;
  QSignalSpy asked(&signals, &SignalWatch::asked);
  ASSERT_EQ(std::raise(SIGTERM), 0);
  ASSERT_TRUE(asked.count() == 1 || asked.wait(5000));
  windows.release();
  const QString folder = window->files().autosave()->folder();
  EXPECT_FALSE(window->studio().loop().forces_are_on());
  windows.end();  // closes the windows without asking the user
  EXPECT_TRUE(window.isNull());
  EXPECT_FALSE(folder.isEmpty());
  EXPECT_TRUE(QDir(folder).exists()) << "the next start offers it";
  working.removeRecursively();
}

TEST(Windows, AFileThatCannotBeOpenedSaysSoInAWindowThatStays) {
  Windows windows(still());
  MainWindow* first = windows.open();
  const QString none = QStringLiteral("/nowhere/at all.felt");
  EXPECT_EQ(windows.open_file(none), first) << "there is nothing in it";
  first->studio().set_modified(true);
  MainWindow* second = windows.open_file(none);
  ASSERT_NE(second, nullptr);
  EXPECT_NE(second, first);
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  for (MainWindow* window : {first, second}) {
    const auto* box = window->findChild<QMessageBox*>();
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->isVisible());
    EXPECT_TRUE(box->text().contains(QStringLiteral("at all.felt")));
  }
  first->studio().set_modified(false);
  delete second;
  delete first;
}

TEST(MainWindow, TabHidesThePanelsWhileTheCanvasHasTheFocus) {
  const auto window = shown_window();
  ASSERT_TRUE(window->canvas().hasFocus());
  QTest::keyClick(window->windowHandle(), Qt::Key_Tab);
  QAction* hide = window->actions().find(QStringLiteral("view.hide_panels"));
  EXPECT_TRUE(hide->isChecked());
  QTest::keyClick(window->windowHandle(), Qt::Key_Tab);
  EXPECT_FALSE(hide->isChecked());
  auto* field = window->findChild<QDoubleSpinBox*>(QStringLiteral("top_size"));
  ASSERT_TRUE(field);
  field->setFocus();
  QTest::keyClick(window->windowHandle(), Qt::Key_Tab);
  EXPECT_FALSE(hide->isChecked()) << "elsewhere it goes to the next control";
}

/// Returns where the visible panels of the window are.
QMap<QString, QRect> panel_places(const MainWindow& window) {
  QMap<QString, QRect> all;
  for (const QDockWidget* panel : window.findChildren<QDockWidget*>()) {
    if (panel->isVisible()) all[panel->objectName()] = panel->geometry();
  }
  return all;
}

TEST(MainWindow, PanelsThatWereHiddenComeBackWithTheirSizes) {
  QMap<QString, QRect> before;
  for (const bool is_restarted : {false, true}) {
    const auto window = shown_window();
    window->resize(1200, 900);
    QApplication::processEvents();
    auto* options = window->findChild<QDockWidget*>(QStringLiteral("options"));
    auto* layers = window->findChild<QDockWidget*>(QStringLiteral("layers"));
    if (!is_restarted) {
      window->resizeDocks({options, layers}, {options->height() + 90, layers->height() - 90},
                          Qt::Vertical);
      QApplication::processEvents();
      before = panel_places(*window);
    }
    EXPECT_EQ(panel_places(*window), before) << is_restarted;
    EXPECT_GE(before.size(), 2);
    for (int time = 0; time < 3; ++time) {
      QTest::keyClick(&window->canvas(), Qt::Key_Tab);
      QApplication::processEvents();
      EXPECT_TRUE(panel_places(*window).isEmpty());
      QTest::keyClick(&window->canvas(), Qt::Key_Tab);
      QApplication::processEvents();
      EXPECT_EQ(panel_places(*window), before) << time;
    }
    QTest::keyClick(&window->canvas(), Qt::Key_Tab);
    EXPECT_TRUE(window->close()) << "while they are hidden";
  }
  Settings::the().reset(window_keys::kLayout);
  Settings::the().reset(window_keys::kGeometry);
}

TEST(MainWindow, APanelThatIsOpenedWhileAllAreHiddenStays) {
  const auto window = shown_window();
  QAction* hide = window->actions().find(QStringLiteral("view.hide_panels"));
  hide->setChecked(true);
  window->actions().find(QStringLiteral("view.panel_forces"))->setChecked(true);
  hide->setChecked(false);
  QApplication::processEvents();
  for (const char* name : {"forces", "options", "layers"}) {
    EXPECT_FALSE(window->findChild<QDockWidget*>(QString::fromLatin1(name))->isHidden()) << name;
  }
}

TEST(MainWindow, SingleCharactersCanBeSwitchedOffAsKeys) {
  MainWindow window(still());
  const auto keys = [&window] {
    QMap<QString, int> count;  // of keys, by their number of characters: "P", "Ctrl+P"
    for (const QAction* action : window.actions().all()) {
      for (const QKeySequence& key : action->shortcuts()) {
        ++count[key.toString().size() == 1 ? QStringLiteral("single") : QStringLiteral("other")];
      }
    }
    return count;
  };
  const QMap<QString, int> before = keys();
  EXPECT_GT(before[QStringLiteral("single")], 15);
  Preferences preferences(window);
  ASSERT_TRUE(preferences.show_page(QStringLiteral("shortcuts")));
  auto* letters = preferences.findChild<QCheckBox*>(QStringLiteral("single_characters"));
  ASSERT_TRUE(letters);
  EXPECT_TRUE(letters->isChecked());
  letters->click();
  EXPECT_EQ(keys().value(QStringLiteral("single")), 0);
  EXPECT_GE(keys().value(QStringLiteral("other")), 40) << "Ctrl+Z, F9 and Tab stay";
  EXPECT_FALSE(window.actions().find(QStringLiteral("tool.pull"))->toolTip().contains(u'('));
  MainWindow later(still());
  EXPECT_TRUE(later.actions().find(QStringLiteral("tool.pull"))->shortcuts().isEmpty());
  letters->click();
  EXPECT_EQ(keys(), before);
}

TEST(MainWindow, AMessageEndsWithItsReason) {
  const auto window = shown_window();
  Studio& studio = window->studio();
  const auto shown = [&] { return window->statusBar()->currentMessage(); };
  const auto refuse = [&] {
    Q_EMIT studio.refused(QStringLiteral("The smallest size is 0.05 mm."));
    EXPECT_FALSE(shown().isEmpty());
    studio.advance(40'000'000);
    EXPECT_FALSE(shown().isEmpty()) << "it stays while the user does nothing";
  };
  refuse();
  studio.apply(SetOption{"pencil.max_width_mm", 2.0});
  EXPECT_TRUE(shown().isEmpty()) << "the size has grown";
  refuse();
  studio.apply(SelectTool{"connect"});
  studio.advance(40'000'000);
  EXPECT_TRUE(shown().isEmpty()) << "another tool";
  refuse();
  studio.apply(SelectTool{"pencil"});
  window->statusBar()->showMessage(QStringLiteral("Erases the ink under it"));
  touch(*window, true);
  EXPECT_TRUE(shown().isEmpty()) << "the user draws";
  touch(*window, false);
  studio.set_modified(false);
}

TEST(MainWindow, TheMenuKnowsWhichPanelsAreSeenFromTheStart) {
  const auto window = shown_window();
  for (const QDockWidget* panel : window->findChildren<QDockWidget*>()) {
    const QAction* action =
        window->actions().find(QStringLiteral("view.panel_") + panel->objectName());
    ASSERT_TRUE(action);
    EXPECT_EQ(action->isChecked(), !panel->isHidden()) << panel->objectName().toStdString();
  }
  window->actions().find(QStringLiteral("view.panel_forces"))->trigger();
  EXPECT_FALSE(window->findChild<QDockWidget*>(QStringLiteral("forces"))->isHidden());
}

TEST(MainWindow, FitsASmallScreenWithEveryPanel) {
  const auto window = shown_window();
  window->show_panel(QStringLiteral("forces"));
  window->studio().use_device(QStringLiteral("simulated:touch"));
  window->resize(1280, 740);
  QCoreApplication::processEvents();
  EXPECT_LE(window->height(), 740);
  EXPECT_LE(window->width(), 1280);
  EXPECT_LE(window->minimumSizeHint().height(), 700);
}

TEST(MainWindow, ChoosingAToolMovesNothing) {
  const auto window = shown_window();
  const QRect before = window->canvas().geometry();
  for (const auto& tool : window->studio().session().tools()) {
    window->studio().apply(SelectTool{std::string(tool->info().id)});
    QCoreApplication::processEvents();
    EXPECT_EQ(window->canvas().geometry(), before) << tool->info().id;
  }
}

TEST(MainWindow, APasteIsWhatIsSelected) {
  const auto window = shown_window();
  Studio& studio = window->studio();
  touch(*window, true);
  for (int i = 0; i < 20; ++i) {
    studio.point({studio.now_ns(), {50.0 + i, 50}, true, 0.5});
    studio.advance(5'000'000);
  }
  studio.point({studio.now_ns(), {70, 50}, false, 0.0});
  studio.advance(400'000'000);
  ASSERT_EQ(studio.session().document().stroke_count(), 1U);
  const Document original = studio.session().document();
  for (const char* name : {"edit.select_all", "edit.copy", "edit.paste", "edit.delete"}) {
    window->actions().find(QString::fromLatin1(name))->trigger();
  }
  EXPECT_EQ(studio.session().document().stroke_count(), 1U);
  EXPECT_TRUE(studio.session().document().find(original.layers()[0].strokes[0]))
      << "the copy went, not the original";
}

}  // namespace
}  // namespace felt::desktop::main_window_test
