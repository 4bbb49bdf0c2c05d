#include "desktop/window/ring_menu.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTabletEvent>
#include <QTest>
#include <QToolButton>
#include <vector>

#include "desktop/engine/settings.h"
#include "desktop/engine/testing/kept_events.h"
#include "desktop/engine/tool_size.h"
#include "desktop/pens/long_press.h"
#include "desktop/pens/pen_setting_keys.h"
#include "desktop/testing/accessible_names.h"
#include "desktop/window/main_window.h"
#include "felt/base/constants.h"
#include "felt/haptics/force_memory.h"
#include "felt/session/session_medium.h"

namespace felt::desktop::ring_menu_test {
namespace {

class RingMenuTest : public ::testing::Test {
 protected:
  RingMenuTest() : window_(options(QStringLiteral("tablet"))) { window_.show(); }

  StudioOptions options(const QString& device) {
    return {.device = device, .live = false, .connect_early = keep_events(events_)};
  }
  Canvas& canvas() { return window_.canvas(); }
  RingMenu& menu() { return *window_.findChild<RingMenu*>(); }
  std::string tool() { return std::string(window_.studio().session().tool().info().id); }
  void key(Qt::Key key, Qt::KeyboardModifiers keys = {}) {
    QWidget* focus = menu().isVisible() ? static_cast<QWidget*>(&menu()) : &canvas();
    QTest::keyClick(focus, key, keys);
  }
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, canvas().mapToGlobal(at), button, buttons, {});
    QApplication::sendEvent(&canvas(), &event);
  }
  void drag_to(QPointF at, Qt::MouseButtons buttons = Qt::RightButton) {
    mouse(QEvent::MouseMove, at, Qt::NoButton, buttons);
  }
  void release(QPointF at) { mouse(QEvent::MouseButtonRelease, at, Qt::RightButton, {}); }
  void click(QPointF at) {
    mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    EXPECT_TRUE(menu().isVisible()) << "the release chooses";
    mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, {});
  }
  void tablet(QEvent::Type type, QPointF at, Qt::MouseButtons buttons) {
    static const auto* pen =
        new QPointingDevice(QStringLiteral("test pen"), 11, QInputDevice::DeviceType::Stylus,
                            QPointingDevice::PointerType::Pen,
                            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                            1, 3, {}, QPointingDeviceUniqueId::fromNumericId(1), qApp);
    const bool changes = type != QEvent::TabletMove;
    QTabletEvent event(type, pen, at, canvas().mapToGlobal(at), buttons ? 0.5 : 0.0, 0, 0, 0, 0, 0,
                       {}, changes ? Qt::LeftButton : Qt::NoButton, buttons);
    event.setTimestamp(1000 + static_cast<quint64>(window_.studio().now_ns() / kMs));
    QApplication::sendEvent(&canvas(), &event);
    window_.studio().advance(10 * kMs);
  }
  /// Presses with a tablet's pen until the ring opens.
  void press_long() {
    Settings::the().set(QString::fromLatin1(pen_keys::kLongPress), true);
    tablet(QEvent::TabletMove, kAt, {});
    tablet(QEvent::TabletPress, kAt, Qt::LeftButton);
    window_.studio().advance(LongPress::kPressNs + 50 * kMs);
    Settings::the().set(QString::fromLatin1(pen_keys::kLongPress), pen_keys::kLongPressDefault);
    ASSERT_TRUE(menu().isVisible());
  }
  /// Draws a line of 100 pixels to the right of kAt.
  void draw_line() {
    mouse(QEvent::MouseButtonPress, kAt, Qt::LeftButton, Qt::LeftButton);
    for (int x = 0; x <= 100; x += 5) {
      drag_to(kAt + QPointF(x, 0), Qt::LeftButton);
      window_.studio().advance(10 * kMs);
    }
    mouse(QEvent::MouseButtonRelease, kAt + QPointF(100, 0), Qt::LeftButton, {});
    window_.studio().advance(300 * kMs);
    ASSERT_EQ(window_.studio().session().document().stroke_count(), 1u);
  }
  void trigger(const char* name) { window_.actions().find(QString::fromLatin1(name))->trigger(); }

  static constexpr QPointF kAt{300, 250};
  std::vector<Event> events_;
  MainWindow window_;
};

// A flick: the button goes down, the hand moves, the button comes up.
TEST_F(RingMenuTest, AFlickWithTheButtonChoosesTheToolInItsDirection) {
  Q_EMIT canvas().ring_wanted(kAt);
  ASSERT_TRUE(menu().isVisible());
  events_.clear();
  drag_to(kAt + QPointF(30, 4));
  drag_to(kAt + QPointF(60, 10));
  EXPECT_EQ(menu().ring()->chosen(), 2u);
  release(kAt + QPointF(60, 10));
  EXPECT_EQ(tool(), "pull");
  EXPECT_FALSE(menu().isVisible());
  int selects = 0, strokes = 0;
  for (const Event& event : events_) {
    if (const auto* select = std::get_if<SelectTool>(&event.what)) {
      ++selects;
      EXPECT_EQ(select->id, "pull");
    }
    const auto* pen = std::get_if<PenEvent>(&event.what);
    strokes += pen && (pen->position.z < 0.0 || pen->pressure.value_or(0.0) > 0.0);
  }
  EXPECT_EQ(selects, 1) << "a recording holds the choice as the tool bar makes it";
  EXPECT_EQ(strokes, 0);
  Q_EMIT canvas().ring_wanted(kAt);
  drag_to(kAt + QPointF(0, 300));
  release(kAt + QPointF(0, 300));
  EXPECT_EQ(tool(), "eraser") << "a long movement chooses, too";
}

TEST_F(RingMenuTest, AReleaseInTheMiddleLeavesItOpenForAClick) {
  Q_EMIT canvas().ring_wanted(kAt);
  drag_to(kAt + QPointF(3, 0));
  release(kAt + QPointF(3, 0));
  EXPECT_TRUE(menu().isVisible());
  click(kAt + QPointF(-80, 0));
  EXPECT_EQ(tool(), "lasso");
  EXPECT_EQ(window_.studio().session().document().stroke_count(), 0u) << "nothing was drawn";
  Q_EMIT canvas().ring_wanted(kAt);
  release(kAt);
  click(kAt);
  EXPECT_FALSE(menu().isVisible()) << "a click in the middle closes it";
  EXPECT_EQ(tool(), "lasso");
}

TEST_F(RingMenuTest, MediaLieBehindADirectionAndAKey) {
  Q_EMIT canvas().ring_wanted(kAt);
  drag_to(kAt + QPointF(-60, -60));
  release(kAt + QPointF(-60, -60));
  ASSERT_TRUE(menu().isVisible());
  EXPECT_EQ(menu().accessibleName(), QStringLiteral("Ring of media"));
  click(kAt + QPointF(20, -60));  // to the right of the pen, around which this ring opened
  EXPECT_EQ(drawing_medium(window_.studio().session()), "ink-pen");
  trigger("tool.media_ring");
  ASSERT_TRUE(menu().isVisible());
  key(Qt::Key_Down);
  key(Qt::Key_Left);
  key(Qt::Key_Return);
  EXPECT_EQ(drawing_medium(window_.studio().session()), "crayon");
  EXPECT_EQ(tool(), "pencil");
}

TEST_F(RingMenuTest, KeysChooseAndEscapeCloses) {
  trigger("tool.ring");
  ASSERT_TRUE(menu().isVisible());
  EXPECT_TRUE(nameless_controls(menu()).isEmpty());
  for (const auto& [press, well] : {std::pair{Qt::Key_Right, 2u},
                                    {Qt::Key_Up, 1u},
                                    {Qt::Key_Up, 0u},
                                    {Qt::Key_Down, 4u},
                                    {Qt::Key_Left, 5u}}) {
    key(press);
    EXPECT_EQ(menu().ring()->chosen(), well);
  }
  key(Qt::Key_Escape);
  EXPECT_FALSE(menu().isVisible());
  EXPECT_EQ(tool(), "pencil");
  trigger("tool.ring");
  trigger("tool.ring");
  EXPECT_FALSE(menu().isVisible()) << "the key closes it, too";
  trigger("tool.ring");
  key(Qt::Key_Down);
  key(Qt::Key_Return);
  EXPECT_EQ(tool(), "eraser");
}

// The key is held, the hand moves without a button, the key comes up.
TEST_F(RingMenuTest, AFlickWithTheKeyHeldChooses) {
  trigger("tool.ring");
  const QPointF middle = canvas().view().to_px(menu().ring()->middle());
  drag_to(middle + QPointF(0, 60), {});
  QTest::keyRelease(&menu(), Qt::Key_Q);
  EXPECT_FALSE(menu().isVisible());
  EXPECT_EQ(tool(), "eraser");
  trigger("tool.ring");
  EXPECT_FALSE(menu().isVisible()) << "a repetition of the held key";
}

TEST_F(RingMenuTest, StaysClosedWhileALineIsDrawn) {
  mouse(QEvent::MouseButtonPress, kAt, Qt::LeftButton, Qt::LeftButton);
  drag_to(kAt + QPointF(50, 0), Qt::LeftButton);
  window_.studio().advance(50 * kMs);
  ASSERT_TRUE(window_.studio().session().gesture_in_progress());
  trigger("tool.ring");
  EXPECT_FALSE(menu().isVisible());
  mouse(QEvent::MouseButtonRelease, kAt + QPointF(50, 0), Qt::LeftButton, {});
}

// Sizes are detents around the pen that grow clockwise.
TEST_F(RingMenuTest, SizesAreAnotherRing) {
  Q_EMIT canvas().ring_wanted(kAt);
  drag_to(kAt + QPointF(60, 60));
  release(kAt + QPointF(60, 60));
  ASSERT_TRUE(menu().isVisible());
  EXPECT_EQ(menu().accessibleName(), QStringLiteral("Ring of sizes"));
  EXPECT_TRUE(nameless_controls(menu()).isEmpty());
  click(kAt + QPointF(60, 140));
  EXPECT_EQ(tool_size(window_.studio().session())->mm, 1.5);
  trigger("tool.size_ring");
  for (int i = 0; i < 5; ++i) key(i == 0 ? Qt::Key_Up : Qt::Key_Right);
  EXPECT_EQ(menu().ring()->chosen(), 2u);
  key(Qt::Key_Return);
  EXPECT_EQ(tool_size(window_.studio().session())->mm, 0.7);
  trigger("tool.eraser");
  trigger("tool.size_ring");
  key(Qt::Key_Down);
  key(Qt::Key_Return);
  EXPECT_EQ(tool_size(window_.studio().session())->mm, 15.0);
}

// Screen readers hear every choice of the pen, and cue devices tick.
TEST_F(RingMenuTest, SaysAndTicksEachChoice) {
  QSignalSpy ticks(&window_.studio(), &Studio::tick_wanted);
  Q_EMIT canvas().ring_wanted(kAt);
  drag_to(kAt + QPointF(0, 60));
  EXPECT_EQ(menu().accessibleName(), QStringLiteral("Ring of tools: Eraser"));
  drag_to(kAt + QPointF(0, 70));
  EXPECT_EQ(ticks.count(), 1);
  drag_to(kAt + QPointF(60, 0));
  EXPECT_EQ(menu().accessibleName(), QStringLiteral("Ring of tools: Pull"));
  EXPECT_EQ(ticks.count(), 2);
  drag_to(kAt);
  EXPECT_EQ(ticks.count(), 2);
}

// A pen that ticks is felt while the other hand chooses by keys.
TEST_F(RingMenuTest, AChoiceByKeyTicksToo) {
  QSignalSpy ticks(&window_.studio(), &Studio::tick_wanted);
  trigger("tool.ring");
  key(Qt::Key_Right);
  EXPECT_EQ(ticks.count(), 1);
  key(Qt::Key_Right);
  EXPECT_EQ(ticks.count(), 1) << "the same choice";
  key(Qt::Key_Up);
  EXPECT_EQ(ticks.count(), 2);
  key(Qt::Key_Return);
  EXPECT_EQ(ticks.count(), 2) << "carrying it out is not another choice";
}

TEST_F(RingMenuTest, OtherThingsCloseIt) {
  const auto open = [this] {
    Q_EMIT canvas().ring_wanted(kAt);
    ASSERT_TRUE(menu().isVisible());
  };
  open();
  QTest::mouseClick(window_.statusBar(), Qt::LeftButton);
  EXPECT_FALSE(menu().isVisible()) << "a click elsewhere";
  open();
  trigger("tool.eraser");
  EXPECT_FALSE(menu().isVisible()) << "another tool";
  open();
  CanvasView view = canvas().view();
  view.pan({10, 10});
  canvas().set_view(view);
  EXPECT_FALSE(menu().isVisible()) << "another view";
  open();
  window_.studio().loop().set_forces(true);
  key(Qt::Key_Escape);
  key(Qt::Key_Escape);
  EXPECT_FALSE(window_.studio().loop().forces_are_on()) << "Escape twice stops forces";
}

// In an active window, the window's own shortcut of Escape would clear the selection.
TEST_F(RingMenuTest, EscapeClosesOnlyTheRing) {
  draw_line();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  window_.studio().apply(SelectStrokes{SelectStrokes::What::kAll});
  trigger("tool.ring");
  ASSERT_TRUE(menu().isVisible());
  key(Qt::Key_Escape);
  EXPECT_FALSE(menu().isVisible());
  EXPECT_FALSE(window_.studio().session().selection().empty());
  key(Qt::Key_Escape);
  EXPECT_TRUE(window_.studio().session().selection().empty());
}

TEST_F(RingMenuTest, TabAndReturnChooseTheFocusedButton) {
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  trigger("tool.ring");
  const auto buttons = menu().findChildren<QToolButton*>();
  ASSERT_EQ(buttons.size(), 8);
  buttons[4]->setFocus(Qt::TabFocusReason);
  EXPECT_EQ(menu().ring()->chosen(), 4u);
  QTest::keyClick(buttons[4], Qt::Key_Return);
  EXPECT_EQ(tool(), "eraser");
}

// The right button erases, as long as no ring is open.
TEST_F(RingMenuTest, TheRestOfAPressAfterItClosedDoesNothing) {
  draw_line();
  const Document drawn = window_.studio().session().document();
  Q_EMIT canvas().ring_wanted(kAt);
  drag_to(kAt + QPointF(5, 0));
  key(Qt::Key_Escape);
  ASSERT_FALSE(menu().isVisible());
  for (int x = 0; x <= 100; x += 5) drag_to(kAt + QPointF(x, 0));
  release(kAt + QPointF(100, 0));
  window_.studio().advance(300 * kMs);
  EXPECT_TRUE(window_.studio().session().document() == drawn);
  mouse(QEvent::MouseButtonPress, kAt, Qt::RightButton, Qt::RightButton);
  for (int x = 0; x <= 100; x += 5) drag_to(kAt + QPointF(x, 0));
  release(kAt + QPointF(100, 0));
  window_.studio().advance(300 * kMs);
  EXPECT_FALSE(window_.studio().session().document() == drawn) << "the next press erases";
}

TEST_F(RingMenuTest, APalmDoesNotChoose) {
  QPointingDevice* screen = QTest::createTouchDevice();
  Q_EMIT canvas().ring_wanted(kAt);
  QTest::touchEvent(&canvas(), screen).press(0, (kAt + QPointF(0, 60)).toPoint(), &canvas());
  EXPECT_FALSE(menu().ring()->chosen());
  QTest::touchEvent(&canvas(), screen).release(0, (kAt + QPointF(0, 60)).toPoint(), &canvas());
  EXPECT_TRUE(menu().isVisible());
}

// The simulated pen may still be on the surface when the next touch begins.
TEST_F(RingMenuTest, ALineRightAfterAChoiceIsDrawn) {
  Studio& studio = window_.studio();
  ASSERT_TRUE(studio.use_device(QStringLiteral("simulated:premium")));
  studio.advance(600 * kMs);
  drag_to(kAt, {});
  studio.advance(300 * kMs);
  Q_EMIT canvas().ring_wanted(kAt);
  release(kAt);
  const QPointF top = canvas().view().to_px(menu().ring()->well(0));
  mouse(QEvent::MouseButtonPress, top, Qt::LeftButton, Qt::LeftButton);
  studio.advance(500 * kMs);
  mouse(QEvent::MouseButtonRelease, top, Qt::LeftButton, {});
  ASSERT_FALSE(menu().isVisible());
  mouse(QEvent::MouseButtonPress, top, Qt::LeftButton, Qt::LeftButton);
  for (int x = 0; x <= 100; x += 5) {
    drag_to(top + QPointF(x, 0), Qt::LeftButton);
    studio.advance(20 * kMs);
  }
  mouse(QEvent::MouseButtonRelease, top + QPointF(100, 0), Qt::LeftButton, {});
  studio.advance(1000 * kMs);
  const Document& drawn = studio.session().document();
  ASSERT_EQ(drawn.stroke_count(), 1u);
  const StrokePtr line = drawn.find(drawn.layers().front().strokes.front());
  EXPECT_LT(distance(line->position(0.0), canvas().view().to_mm(top)), 0.7);
}

// With the hand of a mouse or a tablet, and on every simulated device.
TEST_F(RingMenuTest, APressBesideAnOpenRingDraws) {
  for (const PenDeviceInfo& device : pen_devices()) {
    if (device.id != QStringLiteral("tablet") &&
        !device.id.startsWith(QStringLiteral("simulated"))) {
      continue;
    }
    SCOPED_TRACE(device.id.toStdString());
    Studio& studio = window_.studio();
    studio.open(Document(), studio.page());
    ASSERT_TRUE(studio.use_device(device.id));
    studio.advance(1000 * kMs);
    drag_to(kAt, {});
    Q_EMIT canvas().ring_wanted(kAt);
    release(kAt);
    ASSERT_TRUE(menu().isVisible());
    const QPointF beside = kAt + QPointF(250, 100);
    mouse(QEvent::MouseButtonPress, beside, Qt::LeftButton, Qt::LeftButton);
    EXPECT_FALSE(menu().isVisible());
    for (int y = 0; y <= 100; y += 5) {
      drag_to(beside + QPointF(0, y), Qt::LeftButton);
      studio.advance(10 * kMs);
    }
    mouse(QEvent::MouseButtonRelease, beside + QPointF(0, 100), Qt::LeftButton, {});
    studio.advance(1000 * kMs);
    EXPECT_EQ(studio.session().document().stroke_count(), 1u);
    EXPECT_EQ(tool(), "pencil");
  }
}

// The pen touches and rests, moves in a direction, and lifts.
TEST_F(RingMenuTest, AFlickAfterALongPressChooses) {
  press_long();
  tablet(QEvent::TabletMove, kAt + QPointF(30, 0), Qt::LeftButton);
  tablet(QEvent::TabletMove, kAt + QPointF(70, 5), Qt::LeftButton);
  EXPECT_EQ(menu().ring()->chosen(), 2u);
  tablet(QEvent::TabletRelease, kAt + QPointF(70, 5), {});
  EXPECT_FALSE(menu().isVisible());
  EXPECT_EQ(tool(), "pull");
  window_.studio().advance(300 * kMs);
  EXPECT_EQ(window_.studio().session().document().stroke_count(), 0u);
  EXPECT_EQ(window_.studio().session().history().undo_count(), 0u);
}

TEST_F(RingMenuTest, ALongPressThatIsLiftedInTheMiddleLeavesItOpen) {
  press_long();
  tablet(QEvent::TabletRelease, kAt, {});
  ASSERT_TRUE(menu().isVisible());
  tablet(QEvent::TabletMove, kAt + QPointF(0, 70), {});
  tablet(QEvent::TabletPress, kAt + QPointF(0, 70), Qt::LeftButton);
  EXPECT_TRUE(menu().isVisible());
  tablet(QEvent::TabletRelease, kAt + QPointF(0, 70), {});
  EXPECT_EQ(tool(), "eraser");
  press_long();
  tablet(QEvent::TabletMove, kAt + QPointF(-60, -60), Qt::LeftButton);
  tablet(QEvent::TabletRelease, kAt + QPointF(-60, -60), {});
  ASSERT_TRUE(menu().isVisible()) << "the ring of media";
  tablet(QEvent::TabletMove, kAt + QPointF(-60, 10), {});
  EXPECT_TRUE(menu().isVisible()) << "only a touch and lift chooses";
}

TEST_F(RingMenuTest, EscapeDuringALongPressDrawsNothing) {
  press_long();
  key(Qt::Key_Escape);
  EXPECT_FALSE(menu().isVisible());
  for (int x = 0; x <= 100; x += 5) {
    tablet(QEvent::TabletMove, kAt + QPointF(x, 0), Qt::LeftButton);
  }
  tablet(QEvent::TabletRelease, kAt + QPointF(100, 0), {});
  window_.studio().advance(300 * kMs);
  EXPECT_EQ(window_.studio().session().document().stroke_count(), 0u);
  for (int x = 0; x <= 100; x += 5) {
    tablet(x == 0 ? QEvent::TabletPress : QEvent::TabletMove, kAt + QPointF(x, 0), Qt::LeftButton);
  }
  tablet(QEvent::TabletRelease, kAt + QPointF(100, 0), {});
  window_.studio().advance(300 * kMs);
  EXPECT_EQ(window_.studio().session().document().stroke_count(), 1u) << "the next touch draws";
}

// The pen of a device feels the wells on the surface, and leaves no ink there.
TEST_F(RingMenuTest, ADeviceFeelsTheWells) {
  Studio& studio = window_.studio();
  ASSERT_TRUE(studio.use_device(QStringLiteral("simulated:premium")));
  studio.advance(600 * kMs);
  drag_to(kAt, {});
  studio.advance(300 * kMs);
  Q_EMIT canvas().ring_wanted(kAt);
  const Point well = menu().ring()->well(2);
  const QPointF beside = canvas().view().to_px(well + 0.15 * (well - menu().ring()->middle()));
  release(kAt);
  mouse(QEvent::MouseButtonPress, beside, Qt::LeftButton, Qt::LeftButton);
  double pull_n = 0.0;
  for (int i = 0; i < 100; ++i) {
    studio.advance(10 * kMs);
    pull_n = std::max(pull_n, std::hypot(studio.pen().asked.x, studio.pen().asked.y));
  }
  EXPECT_TRUE(in_contact(studio.pen().sample));
  EXPECT_GT(pull_n, 0.2);
  EXPECT_LE(pull_n, 0.55);
  mouse(QEvent::MouseButtonRelease, beside, Qt::LeftButton, {});
  studio.advance(300 * kMs);
  EXPECT_EQ(tool(), "pull");
  EXPECT_EQ(studio.session().document().stroke_count(), 0u);
  EXPECT_EQ(studio.session().history().undo_count(), 0u);
}

}  // namespace
}  // namespace felt::desktop::ring_menu_test
