#include "desktop/feel/feel_panel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QBuffer>
#include <QImage>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "desktop/engine/settings.h"
#include "desktop/feel/contour_finder.h"
#include "desktop/feel/feel_actions.h"
#include "desktop/feel/feel_setting_keys.h"

namespace felt::desktop::feel_panel_test {
namespace {

StudioOptions by_hand(const QString& device) {
  StudioOptions options;
  options.device = device;
  options.live = false;
  return options;
}

struct Window : QMainWindow {
  explicit Window(const QString& device = QStringLiteral("simulated:touch"))
      : studio(by_hand(device), this), actions(this) {
    add_feel_actions(actions, studio, this);
    panel = new FeelPanel(studio, this);
    setCentralWidget(panel);
    show();
  }

  Studio studio;
  Actions actions;
  FeelPanel* panel = nullptr;
};

void forget_settings() {
  for (const char* key : {feel_keys::kStrength, feel_keys::kForceLimit, feel_keys::kMaterial}) {
    Settings::the().set(QString::fromLatin1(key), {});
  }
}

TEST(FeelActions, EdgesFollowTheSettingsAndThePage) {
  Window window;
  const Session& session = window.studio.session();
  EXPECT_EQ(session.edges(), UseEdges{}) << "off at first";
  window.actions.find(QStringLiteral("feel.page_edge"))->trigger();
  EXPECT_EQ(session.edges().page, window.studio.page().area());
  EXPECT_FALSE(session.edges().selection);
  Page page = window.studio.page();
  page.width_mm += 10.0;
  window.studio.set_page(page);
  EXPECT_EQ(session.edges().page, page.area());
  window.actions.find(QStringLiteral("feel.selection_edge"))->trigger();
  EXPECT_TRUE(session.edges().selection);
  window.studio.open(Document{}, Page{});
  EXPECT_EQ(window.studio.session().edges(), (UseEdges{Page{}.area(), true}));
  Window other;
  EXPECT_TRUE(other.studio.session().edges().selection) << "kept";
  for (const char* key : {feel_keys::kPageEdge, feel_keys::kSelectionEdge}) {
    Settings::the().set(QString::fromLatin1(key), false);
  }
  EXPECT_EQ(window.studio.session().edges(), UseEdges{});
  EXPECT_FALSE(other.actions.find(QStringLiteral("feel.page_edge"))->isChecked());
}

/// Returns a layer with a picture of a disk of 20 mm, at 0.1 mm per pixel.
AddPicture disk_picture() {
  QImage image(400, 400, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::black);
  painter.drawEllipse(QPointF(200.0, 200.0), 100.0, 100.0);
  painter.end();
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  AddPicture event;
  event.name = "Disk";
  event.data = make_picture_data(png.toStdString()).value();
  event.place = {0.1, 0.0, 0.0, 0.1, 30.0, 40.0};
  return event;
}

TEST(FeelActions, R74_ThePictureOfALockedLayerIsFeltUntilTheKeyIsPressed) {
  ASSERT_TRUE(ContourFinder::is_built_in()) << "the tests need OpenCV (./dev setup build)";
  Window window;
  const auto contours = [&]() -> const std::vector<std::vector<Point>>& {
    return window.studio.session().edges().contours;
  };
  ASSERT_TRUE(window.studio.apply(disk_picture()));
  const LayerId layer = window.studio.session().layer();
  QTest::qWait(50);
  EXPECT_TRUE(contours().empty()) << "not locked";
  ASSERT_TRUE(window.studio.apply(LayerEvent{.what = LayerEvent::Do::kLock, .layer = layer}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !contours().empty(); }));
  ASSERT_EQ(contours().size(), 1u);
  for (const Point p : contours().front()) EXPECT_NEAR(distance(p, {50.0, 60.0}), 10.0, 0.15);
  QTest::keyClick(&window, Qt::Key_J);
  EXPECT_TRUE(contours().empty());
  QTest::keyClick(&window, Qt::Key_J);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !contours().empty(); }));
  ASSERT_TRUE(window.studio.apply(LayerEvent{.what = LayerEvent::Do::kHide, .layer = layer}));
  EXPECT_TRUE(contours().empty()) << "not seen";
  ASSERT_TRUE(window.studio.apply(UndoEvent{}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !contours().empty(); }));
  window.studio.open(Document{}, Page{});
  EXPECT_TRUE(contours().empty());
}

TEST(FeelPanel, EscapeTwiceSwitchesForcesOffAndOnlyThePanelSwitchesThemOn) {
  forget_settings();
  Window window;
  ASSERT_TRUE(window.studio.loop().forces_are_on());
  QTest::keyClick(&window, Qt::Key_Escape);
  EXPECT_TRUE(window.studio.loop().forces_are_on());
  QTest::keyClick(&window, Qt::Key_Escape);
  EXPECT_FALSE(window.studio.loop().forces_are_on());
  for (int i = 0; i < 4; ++i) QTest::keyClick(&window, Qt::Key_Escape);
  EXPECT_FALSE(window.studio.loop().forces_are_on());
  window.actions.find(QStringLiteral("feel.forces"))->trigger();
  EXPECT_TRUE(window.studio.loop().forces_are_on());
}

TEST(FeelPanel, EscapesThatAreFarApartAreOthers) {
  forget_settings();
  Window window;
  QTest::keyClick(&window, Qt::Key_Escape);
  QTest::qWait(DoubleEscape::kWithinMs + 100);
  QTest::keyClick(&window, Qt::Key_Escape);
  EXPECT_TRUE(window.studio.loop().forces_are_on());
}

TEST(FeelPanel, HoldingEscapeIsOnePress) {
  forget_settings();
  Window window;
  QTest::keyPress(&window, Qt::Key_Escape);
  for (int i = 0; i < 20; ++i) {
    QKeyEvent again(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier, QString(), true);
    QCoreApplication::sendEvent(&window, &again);
  }
  EXPECT_TRUE(window.studio.loop().forces_are_on());
  QTest::keyRelease(&window, Qt::Key_Escape);
}

TEST(FeelPanel, StrengthIsKeptAndReachesTheLoop) {
  forget_settings();
  {
    Window window;
    auto* slider = window.panel->findChild<QSlider*>();
    ASSERT_NE(slider, nullptr);
    slider->setValue(40);
    EXPECT_DOUBLE_EQ(window.studio.loop().strength(), 0.4);
    EXPECT_EQ(window.panel->findChild<QSpinBox*>()->value(), 40);
    window.studio.advance(100'000'000);
    EXPECT_DOUBLE_EQ(window.studio.loop().tick().strength, 0.4);
    // Another device keeps the strength.
    ASSERT_TRUE(window.studio.use_device(QStringLiteral("simulated:omega")));
    window.studio.advance(100'000'000);
    EXPECT_DOUBLE_EQ(window.studio.loop().tick().strength, 0.4);
  }
  Window next;
  EXPECT_DOUBLE_EQ(next.studio.loop().strength(), 0.4);
  EXPECT_EQ(next.panel->findChild<QSlider*>()->value(), 40);
  next.actions.find(QStringLiteral("feel.stronger"))->trigger();
  EXPECT_NEAR(next.studio.loop().strength(), 0.5, 1e-12);
  forget_settings();
}

TEST(FeelPanel, AMaterialIsChosenByButtonActionOrEventAndAllAgree) {
  forget_settings();
  Window window;
  const auto chosen = [&] { return window.studio.session().surface().id; };
  QAbstractButton* glass = nullptr;
  for (auto* button : window.panel->findChildren<QAbstractButton*>()) {
    if (button->text() == QStringLiteral("Glass")) glass = button;
  }
  ASSERT_NE(glass, nullptr);
  glass->click();
  EXPECT_EQ(chosen(), "glass");
  EXPECT_TRUE(window.actions.find(QStringLiteral("feel.surface_glass"))->isChecked());
  EXPECT_EQ(Settings::the().text(feel_keys::kMaterial), QStringLiteral("glass"));
  window.actions.find(QStringLiteral("feel.surface_felt"))->trigger();
  EXPECT_EQ(chosen(), "felt");
  EXPECT_FALSE(glass->isChecked());
  window.studio.apply(SetOption{"surface.material", OptionValue(std::string("glass"))});
  EXPECT_TRUE(glass->isChecked());
  EXPECT_TRUE(window.actions.find(QStringLiteral("feel.surface_glass"))->isChecked());
  forget_settings();
}

TEST(FeelPanel, AShortcutThatWasStoredUnderTheFormerNameOfItsActionStillWorks) {
  Settings::the().set(QStringLiteral("shortcuts/feel.sheet_glass"), QStringLiteral("Ctrl+Alt+7"));
  const Window window;
  EXPECT_EQ(window.actions.find(QStringLiteral("feel.surface_glass"))->shortcut(),
            QKeySequence(QStringLiteral("Ctrl+Alt+7")));
  Settings::the().reset(QStringLiteral("shortcuts/feel.sheet_glass"));
}

TEST(FeelPanel, ASurfaceIsSeenInItsColourAlsoAtTheNextStart) {
  forget_settings();
  const Rgba green{0x34, 0x46, 0x3e, 255};
  {
    Window window;
    choose_material(window.studio, QStringLiteral("blackboard"));
    EXPECT_EQ(window.studio.page().paper, green);
    EXPECT_FALSE(window.studio.is_modified());
  }
  Window next;
  EXPECT_EQ(next.studio.page().paper, green);
  EXPECT_FALSE(next.studio.is_modified());
  Page page = next.studio.page();
  page.paper = {250, 240, 200, 255};
  next.studio.set_page(page);
  choose_material(next.studio, QStringLiteral("glass"));
  EXPECT_EQ(next.studio.page().paper, page.paper) << "a person's own";
  forget_settings();
}

TEST(FeelPanel, SurfacesOfOnesOwnAreInAMenuOfTheirOwn) {
  forget_settings();
  Window window;
  const auto chosen = [&] { return window.studio.session().surface().id; };
  QAction* own = window.actions.find(QStringLiteral("feel.surface_own"));
  ASSERT_NE(own, nullptr);
  EXPECT_FALSE(own->isVisible()) << "there are none yet";
  Materials known = Materials::built_in();
  SurfaceMaterial mine = *find_surface("glass");
  mine.id = "my-glass";
  mine.label = "My glass";
  known.put(mine);
  window.studio.set_user_materials(known);
  EXPECT_TRUE(own->isVisible());
  Q_EMIT own->menu()->aboutToShow();
  ASSERT_EQ(own->menu()->actions().size(), 1);
  QAction* choice = own->menu()->actions().front();
  EXPECT_EQ(choice->text(), QStringLiteral("My glass"));
  EXPECT_FALSE(choice->isChecked());
  choice->trigger();
  EXPECT_EQ(chosen(), "my-glass");
  Q_EMIT own->menu()->aboutToShow();
  EXPECT_TRUE(own->menu()->actions().front()->isChecked());
  EXPECT_EQ(Settings::the().text(feel_keys::kMaterial), QStringLiteral("my-glass"));
  window.actions.find(QStringLiteral("feel.surface_glass"))->trigger();
  EXPECT_EQ(chosen(), "glass");
  window.studio.set_user_materials(Materials::built_in());
  EXPECT_FALSE(own->isVisible());
  forget_settings();
}

TEST(FeelPanel, EveryControlHasANameForThoseWhoDoNotSee) {
  forget_settings();
  Window window;
  for (const QWidget* widget : window.panel->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible()) continue;
    if (widget->objectName() == QStringLiteral("qt_spinbox_lineedit")) continue;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    EXPECT_TRUE(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()))
        << widget->metaObject()->className();
  }
}

TEST(FeelPanel, APenWithoutMotorsIsSaidToBeOne) {
  forget_settings();
  Window window(QStringLiteral("tablet"));
  window.studio.advance(50'000'000);
  bool said = false;
  for (const auto* label : window.panel->findChildren<QLabel*>()) {
    said = said || label->text().contains(QStringLiteral("no motors"));
  }
  EXPECT_TRUE(said);
}

TEST(Studio, AForceLimitOfAPersonBoundsWhatIsSent) {
  Studio studio(by_hand(QStringLiteral("simulated:omega")));
  studio.loop().set_force_limit(0.5);
  EXPECT_DOUBLE_EQ(studio.loop().servo().options().limits.peak_force_n, 0.5);
  EXPECT_TRUE(studio.loop().forces_are_on());
  studio.loop().set_force_limit(99.0);
  EXPECT_DOUBLE_EQ(studio.loop().servo().options().limits.peak_force_n, 3.0);
  studio.loop().set_force_limit(std::nan(""));
  EXPECT_DOUBLE_EQ(studio.loop().force_limit(), 3.0);
}

TEST(DoubleEscape, LeavingMenusIsNotMeantForTheForces) {
  QWidget window;
  DoubleEscape escape(&window);
  QSignalSpy twice(&escape, &DoubleEscape::pressed_twice);
  QMenu menu;
  menu.addAction(QStringLiteral("one"));
  for (int i = 0; i < 2; ++i) {
    menu.popup(QPoint(0, 0));
    ASSERT_EQ(QApplication::activePopupWidget(), &menu);
    QTest::keyClick(&menu, Qt::Key_Escape);
    EXPECT_FALSE(menu.isVisible());
  }
  EXPECT_EQ(twice.count(), 0);
}

}  // namespace
}  // namespace felt::desktop::feel_panel_test
