#include "desktop/pens/pen_input.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPointingDevice>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTouchEvent>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "desktop/engine/settings.h"
#include "desktop/pens/pen_setting_keys.h"
#include "felt/base/constants.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/tools/tool.h"

namespace felt::desktop::pen_input_test {
namespace {

const QPointingDevice& pen_device(QPointingDevice::PointerType end) {
  const auto make = [](qint64 id, QPointingDevice::PointerType type) {
    return new QPointingDevice(
        QStringLiteral("test pen"), id, QInputDevice::DeviceType::Stylus, type,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3, {},
        QPointingDeviceUniqueId::fromNumericId(1), qApp);
  };
  static const QPointingDevice* pen = make(11, QPointingDevice::PointerType::Pen);
  static const QPointingDevice* eraser = make(12, QPointingDevice::PointerType::Eraser);
  return end == QPointingDevice::PointerType::Eraser ? *eraser : *pen;
}

class PenInputTest : public ::testing::Test {
 protected:
  PenInputTest() : studio_(options()), canvas_(studio_), input_(canvas_) {
    set_defaults();
    canvas_.resize(800, 600);
    canvas_.show();
    wait(30);
  }
  ~PenInputTest() override { set_defaults(); }

  static void set_defaults() {
    using namespace pen_keys;
    set(kPressureOn, kPressureOnDefault);
    set(kThreshold, kThresholdDefault);
    set(kLowerButton, QString::fromLatin1(kLowerButtonDefault));
    set(kRightButton, QString::fromLatin1(kRightButtonDefault));
    set(kTouch, QString::fromLatin1(kTouchDefault));
    set(kTouchTaps, kTouchTapsDefault);
    set(kLongPress, kLongPressDefault);
  }
  StudioOptions options() {
    StudioOptions options;
    options.live = false;
    options.connect_early = [this](Studio& studio) {
      QObject::connect(&studio, &Studio::event_applied, [this](const Event& event) {
        if (const auto* pen = std::get_if<PenEvent>(&event.what)) samples_.push_back(*pen);
      });
    };
    return options;
  }
  static void set(const char* key, const QVariant& value) {
    Settings::the().set(QString::fromLatin1(key), value);
  }
  void wait(std::int64_t ms) { studio_.advance(ms * kMs); }

  void tablet(QEvent::Type type, QPointF at, double pressure, Qt::MouseButtons buttons,
              Qt::MouseButton button = Qt::NoButton,
              QPointingDevice::PointerType end = QPointingDevice::PointerType::Pen,
              Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QTabletEvent event(type, &pen_device(end), at, at, pressure, 0, 0, 0, 0, 0, keys, button,
                       buttons);
    event.setTimestamp(1000 + static_cast<quint64>(studio_.now_ns() / kMs));
    QApplication::sendEvent(&canvas_, &event);
    EXPECT_TRUE(event.isAccepted()) << "else a mouse event is made of it";
  }
  void hover(QPointF at, Qt::MouseButtons buttons = Qt::NoButton,
             QPointingDevice::PointerType end = QPointingDevice::PointerType::Pen) {
    tablet(QEvent::TabletMove, at, 0.0, buttons, Qt::NoButton, end);
    wait(5);
  }
  void tablet_line(QPointF from, QPointF to,
                   QPointingDevice::PointerType end = QPointingDevice::PointerType::Pen,
                   double pressure = 0.5) {
    tablet(QEvent::TabletPress, from, pressure, Qt::LeftButton, Qt::LeftButton, end);
    for (int i = 1; i <= 40; ++i) {
      wait(5);
      tablet(QEvent::TabletMove, from + (to - from) * (i / 40.0), pressure, Qt::LeftButton,
             Qt::NoButton, end);
    }
  }
  void release(QPointF at, QPointingDevice::PointerType end = QPointingDevice::PointerType::Pen) {
    tablet(QEvent::TabletRelease, at, 0.0, Qt::NoButton, Qt::LeftButton, end);
    wait(300);
  }
  void leave_proximity() {
    QTabletEvent event(QEvent::TabletLeaveProximity, &pen_device(QPointingDevice::PointerType::Pen),
                       {}, {}, 0, 0, 0, 0, 0, 0, Qt::NoModifier, Qt::NoButton, Qt::NoButton);
    QApplication::sendEvent(qApp, &event);
  }
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons,
             Qt::KeyboardModifiers keys = Qt::NoModifier,
             Qt::MouseEventSource source = Qt::MouseEventNotSynthesized) {
    QMouseEvent event(type, at, at, at, button, buttons, keys, source);
    QApplication::sendEvent(&canvas_, &event);
  }
  void mouse_line(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton) {
    mouse(QEvent::MouseButtonPress, from, button, button);
    for (int i = 1; i <= 40; ++i) {
      wait(8);
      mouse(QEvent::MouseMove, from + (to - from) * (i / 40.0), Qt::NoButton, button);
    }
    wait(8);
    mouse(QEvent::MouseButtonRelease, to, button, Qt::NoButton);
    wait(300);
  }
  void key(QEvent::Type type, int key, Qt::KeyboardModifiers keys = Qt::NoModifier,
           bool repeats = false) {
    QKeyEvent event(type, key, keys, QString(), repeats);
    QApplication::sendEvent(&canvas_, &event);
    wait(20);
  }
  void tap(int which, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    key(QEvent::KeyPress, which, keys);
    key(QEvent::KeyRelease, which, keys);
  }

  [[nodiscard]] std::size_t strokes() const { return studio_.session().document().stroke_count(); }
  [[nodiscard]] std::string tool() const { return std::string(studio_.session().tool().info().id); }
  [[nodiscard]] bool is_down() const { return in_contact(studio_.pen().sample); }
  [[nodiscard]] std::string drawing() const {
    std::string text;
    append_sketch_lines(text, studio_.session().document());
    return text;
  }

  std::vector<PenEvent> samples_;
  Studio studio_;
  Canvas canvas_;
  PenInput input_;
};

TEST_F(PenInputTest, ATabletDraws) {
  hover({100, 100});
  tablet_line({100, 100}, {500, 300});
  EXPECT_TRUE(is_down());
  release({500, 300});
  EXPECT_FALSE(is_down());
  EXPECT_EQ(strokes(), 1u);
}

// Events may arrive several together, as a window system delivers them. Each position is exactly
// one sample.
TEST_F(PenInputTest, EveryPlaceIsASample) {
  hover({100, 100});
  std::vector<Point> reported;
  tablet(QEvent::TabletPress, {100, 100}, 0.5, Qt::LeftButton, Qt::LeftButton);
  for (int i = 0; i < 1000; ++i) {
    const QPointF at(100 + 0.4 * i, 200 + 80 * std::sin(0.02 * i));
    tablet(QEvent::TabletMove, at, 0.4 + 0.0004 * i, Qt::LeftButton);
    reported.push_back(canvas_.view().to_mm(at));
    if (i % 7 == 6) wait(7);
  }
  wait(100);
  release({500, 200});
  auto at = samples_.begin();
  for (std::size_t i = 0; i < reported.size(); ++i) {
    at = std::find_if(at, samples_.end(), [&](const PenEvent& pen) {
      return pen.position.x == reported[i].x && pen.position.y == reported[i].y;
    });
    ASSERT_NE(at, samples_.end()) << "place " << i;
    EXPECT_NEAR(at->pressure.value_or(0.0), 0.4 + 0.0004 * static_cast<double>(i), 1e-9);
  }
}

// If a tablet senses tilt, the sample has the pen's tilt. Otherwise the tilt is unknown, whatever
// the tablet's events contain.
TEST_F(PenInputTest, ThePenTiltsAsTheTabletSays) {
  const auto* tilting =
      new QPointingDevice(QStringLiteral("tilting pen"), 13, QInputDevice::DeviceType::Stylus,
                          QPointingDevice::PointerType::Pen,
                          QInputDevice::Capability::Position | QInputDevice::Capability::Pressure |
                              QInputDevice::Capability::XTilt | QInputDevice::Capability::YTilt,
                          1, 3, {}, QPointingDeviceUniqueId::fromNumericId(2), qApp);
  const auto tilt = [this](const QPointingDevice& pen, float x_deg, float y_deg) {
    const QPointF at(200, 200);
    QTabletEvent event(QEvent::TabletMove, &pen, at, at, 0.0, x_deg, y_deg, 0, 0, 0, Qt::NoModifier,
                       Qt::NoButton, Qt::NoButton);
    event.setTimestamp(1000 + static_cast<quint64>(studio_.now_ns() / kMs));
    QApplication::sendEvent(&canvas_, &event);
    wait(60);
    return samples_.back().tilt_deg;
  };
  EXPECT_EQ(tilt(*tilting, 0, 0), 0.0);
  EXPECT_EQ(tilt(*tilting, 30, 0), 30.0);
  EXPECT_EQ(tilt(*tilting, 0, -60), 60.0);
  EXPECT_EQ(tilt(*tilting, -45, 45), 54.7);
  EXPECT_EQ(tilt(pen_device(QPointingDevice::PointerType::Pen), 30, 0), std::nullopt);
  leave_proximity();
  mouse(QEvent::MouseMove, {220, 200}, Qt::NoButton, Qt::NoButton);
  wait(60);
  EXPECT_EQ(samples_.back().tilt_deg, std::nullopt);
}

// Whatever ends a stroke, the pen is lifted afterwards and the stroke is in the document.
TEST_F(PenInputTest, NoPenStaysDown) {
  const std::vector<std::function<void()>> ends = {
      [this] { leave_proximity(); },
      [this] {
        hover({500, 310});
      },  // a release event was lost
      [this] {
        QFocusEvent event(QEvent::FocusOut);
        QApplication::sendEvent(&canvas_, &event);
      },
      [this] {
        QEvent event(QEvent::WindowDeactivate);
        QApplication::sendEvent(&canvas_, &event);
      },
      [this] { canvas_.hide(); },
  };
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double y = 50.0 + 100.0 * static_cast<double>(i);
    hover({100, y});
    tablet_line({100, y}, {500, y + 30});
    ASSERT_TRUE(is_down()) << i;
    ends[i]();
    wait(300);
    EXPECT_FALSE(is_down()) << i;
    EXPECT_FALSE(input_.hand().is_down()) << i;
    EXPECT_EQ(strokes(), i + 1);
  }
  canvas_.show();
  mouse(QEvent::MouseButtonPress, {100, 560}, Qt::LeftButton, Qt::LeftButton);
  wait(30);
  ASSERT_TRUE(is_down());
  mouse(QEvent::MouseMove, {300, 560}, Qt::NoButton, Qt::NoButton);
  wait(60);
  EXPECT_FALSE(is_down()) << "a release of the mouse was lost";
}

TEST_F(PenInputTest, TheEraserEndBorrowsTheEraser) {
  constexpr auto kEraser = QPointingDevice::PointerType::Eraser;
  hover({100, 100});
  tablet_line({100, 100}, {500, 100});
  release({500, 100});
  ASSERT_EQ(strokes(), 1u);
  hover({300, 50}, Qt::NoButton, kEraser);
  EXPECT_EQ(tool(), "eraser");
  tablet_line({300, 50}, {300, 150}, kEraser, 0.8);
  release({300, 150}, kEraser);
  EXPECT_EQ(tool(), "eraser");
  EXPECT_EQ(strokes(), 2u) << "it is cut";
  hover({310, 160});
  wait(100);
  EXPECT_EQ(tool(), "pencil");
  hover({300, 50}, Qt::NoButton, kEraser);
  leave_proximity();
  wait(100);
  EXPECT_EQ(tool(), "pencil");
}

// The eraser works to the end of its line, although the hand's last positions are played a moment
// later.
TEST_F(PenInputTest, TheRightButtonErasesToItsEnd) {
  mouse_line({100, 100}, {500, 100});
  ASSERT_EQ(strokes(), 1u);
  mouse_line({300, 20}, {300, 180}, Qt::RightButton);
  EXPECT_EQ(tool(), "pencil");
  EXPECT_EQ(strokes(), 2u);
  set(pen_keys::kRightButton, QStringLiteral("none"));
  mouse_line({200, 20}, {200, 180}, Qt::RightButton);
  EXPECT_EQ(strokes(), 2u);
}

// The stylus of a simulated device may still be on its way when the button is released.
TEST_F(PenInputTest, AShortUseOfABorrowedToolIsThatOfTheTool) {
  for (const char* device : {"simulated:premium", "simulated:touch-x", "simulated:inverse3"}) {
    SCOPED_TRACE(device);
    studio_.open(Document(), studio_.page());
    ASSERT_TRUE(studio_.use_device(QString::fromLatin1(device)));
    wait(1000);
    mouse_line({100, 100}, {500, 100});
    wait(1500);
    ASSERT_EQ(strokes(), 1u);
    mouse(QEvent::MouseMove, {300, 400}, Qt::NoButton, Qt::NoButton);
    wait(1000);
    for (int y = 400; y > 80; y -= 10) {
      mouse(QEvent::MouseMove, QPointF(300, y), Qt::NoButton, Qt::NoButton);
      wait(1);
    }
    mouse(QEvent::MouseButtonPress, {300, 80}, Qt::RightButton, Qt::RightButton);
    for (int y = 80; y <= 120; y += 2) {
      mouse(QEvent::MouseMove, QPointF(300, y), Qt::NoButton, Qt::RightButton);
      wait(1);
    }
    mouse(QEvent::MouseButtonRelease, {300, 120}, Qt::RightButton, Qt::NoButton);
    wait(1500);
    EXPECT_EQ(strokes(), 2u) << "it is cut, and nothing is drawn";
    EXPECT_EQ(tool(), "pencil");
  }
}

// A click of the right button opens the palette, whatever the button does while it is held.
TEST_F(PenInputTest, AClickOfTheRightButtonWantsThePalette) {
  QSignalSpy wanted(&canvas_, &Canvas::popup_wanted);
  mouse_line({100, 100}, {500, 100});
  const auto click = [this] {
    mouse(QEvent::MouseButtonPress, {300, 100}, Qt::RightButton, Qt::RightButton);
    wait(60);
    mouse(QEvent::MouseMove, {301, 101}, Qt::NoButton, Qt::RightButton);
    wait(60);
    mouse(QEvent::MouseButtonRelease, {301, 101}, Qt::RightButton, Qt::NoButton);
    wait(300);
  };
  for (const char* role : {"eraser", "none", "pan", "popup"}) {
    set(pen_keys::kRightButton, QString::fromLatin1(role));
    click();
    ASSERT_EQ(wanted.count(), 1) << role;
    EXPECT_EQ(wanted.takeFirst().at(0).toPointF(), QPointF(301, 101));
    EXPECT_EQ(strokes(), 1u) << "a click erases nothing";
    EXPECT_EQ(tool(), "pencil");
  }
  set(pen_keys::kRightButton, QStringLiteral("undo"));
  click();
  EXPECT_EQ(wanted.count(), 0) << "undo acts when the button is pressed";
  EXPECT_EQ(strokes(), 0u);
  set(pen_keys::kRightButton, QStringLiteral("eraser"));
  mouse_line({300, 20}, {300, 180}, Qt::RightButton);
  EXPECT_EQ(wanted.count(), 0) << "a drag is not a click";
  set(pen_keys::kLowerButton, QStringLiteral("popup"));
  hover({200, 120});
  hover({200, 120}, Qt::RightButton);
  EXPECT_EQ(wanted.count(), 1) << "a button of the pen";
  hover({200, 120});
}

// The right button held still opens the ring; a button with this role opens it when it is pressed.
TEST_F(PenInputTest, AButtonThatIsHeldStillWantsTheRing) {
  QSignalSpy ring(&canvas_, &Canvas::ring_wanted), palette(&canvas_, &Canvas::popup_wanted);
  hover({300, 100});
  for (const char* role : {"eraser", "none", "pan"}) {
    set(pen_keys::kRightButton, QString::fromLatin1(role));
    mouse(QEvent::MouseButtonPress, {300, 100}, Qt::RightButton, Qt::RightButton);
    QTest::qWait(MouseInput::kHoldMs + 100);
    ASSERT_EQ(ring.count(), 1) << role;
    EXPECT_EQ(ring.takeFirst().at(0).toPointF(), QPointF(300, 100));
    mouse(QEvent::MouseButtonRelease, {300, 100}, Qt::RightButton, Qt::NoButton);
    EXPECT_EQ(palette.count(), 0) << "no click";
    EXPECT_EQ(tool(), "pencil");
  }
  mouse_line({300, 20}, {300, 180}, Qt::RightButton);
  QTest::qWait(MouseInput::kHoldMs + 100);
  EXPECT_EQ(ring.count(), 0) << "only a button that is held still opens the ring";
  set(pen_keys::kRightButton, QStringLiteral("ring"));
  mouse(QEvent::MouseButtonPress, {200, 100}, Qt::RightButton, Qt::RightButton);
  EXPECT_EQ(ring.count(), 1);
  // The ring gets the release; the next press opens a ring again.
  mouse(QEvent::MouseMove, {201, 100}, Qt::NoButton, Qt::NoButton);
  mouse(QEvent::MouseButtonPress, {200, 100}, Qt::RightButton, Qt::RightButton);
  EXPECT_EQ(ring.count(), 2);
  mouse(QEvent::MouseButtonRelease, {200, 100}, Qt::RightButton, Qt::NoButton);
  set(pen_keys::kLowerButton, QStringLiteral("ring"));
  hover({200, 120});
  hover({200, 120}, Qt::RightButton);
  EXPECT_EQ(ring.count(), 3) << "a button of the pen";
  hover({200, 120});
}

// A touch that rests opens the ring, and its dot vanishes; everything else draws as before.
TEST_F(PenInputTest, ALongPressWantsTheRing) {
  QSignalSpy ring(&canvas_, &Canvas::ring_pressed);
  constexpr std::int64_t kLongMs = LongPress::kPressNs / kMs + 100;
  const auto press = [this](QPointF at, Qt::MouseButtons others = Qt::NoButton) {
    hover(at, others);
    tablet(QEvent::TabletPress, at, 0.5, others | Qt::LeftButton, Qt::LeftButton);
  };
  press({300, 200});
  wait(kLongMs);
  release({300, 200});
  EXPECT_EQ(ring.count(), 0) << "it is off at first";
  EXPECT_EQ(strokes(), 1u) << "a dot";
  set(pen_keys::kLongPress, true);
  press({300, 200});
  wait(LongPress::kPressNs / kMs - 100);
  EXPECT_EQ(ring.count(), 0);
  tablet(QEvent::TabletMove, {302, 201}, 0.5, Qt::LeftButton);
  wait(200);
  ASSERT_EQ(ring.count(), 1) << "a hand is never still";
  EXPECT_LT(QLineF(ring.takeFirst().at(0).toPointF(), {302, 201}).length(), 1.0);
  EXPECT_FALSE(input_.hand().is_down());
  tablet(QEvent::TabletMove, {400, 300}, 0.5, Qt::LeftButton);
  wait(kLongMs);
  release({400, 300});
  EXPECT_EQ(ring.count(), 0) << "once in a touch";
  EXPECT_EQ(strokes(), 1u) << "neither the dot nor the rest of the touch is ink";
  tablet_line({100, 100}, {500, 100});
  wait(kLongMs);
  release({500, 100});
  press({300, 200});
  tablet(QEvent::TabletMove, {310, 200}, 0.5, Qt::LeftButton);
  wait(30);
  tablet(QEvent::TabletMove, {300, 200}, 0.5, Qt::LeftButton);
  wait(kLongMs);
  release({300, 200});
  EXPECT_EQ(ring.count(), 0) << "the rest at the end of a line, and after a movement";
  EXPECT_EQ(strokes(), 3u);
}

TEST_F(PenInputTest, ARestThatMeansSomethingElseIsNoLongPress) {
  QSignalSpy ring(&canvas_, &Canvas::ring_pressed);
  constexpr std::int64_t kLongMs = LongPress::kPressNs / kMs + 100;
  set(pen_keys::kLongPress, true);
  const auto rest = [&] {
    hover({300, 200});
    tablet(QEvent::TabletPress, {300, 200}, 0.5, Qt::LeftButton, Qt::LeftButton);
    wait(kLongMs);
    release({300, 200});
  };
  mouse(QEvent::MouseButtonPress, {300, 100}, Qt::LeftButton, Qt::LeftButton);
  wait(kLongMs);
  mouse(QEvent::MouseButtonRelease, {300, 100}, Qt::LeftButton, Qt::NoButton);
  wait(300);
  EXPECT_EQ(ring.count(), 0) << "the right button of the mouse opens the ring";
  tap(Qt::Key_Left);
  tap(Qt::Key_Return);
  wait(kLongMs);
  tap(Qt::Key_Return);
  wait(300);
  EXPECT_EQ(ring.count(), 0) << "keys move the pen slowly";
  studio_.apply(SelectTool{"read"});
  rest();
  EXPECT_EQ(ring.count(), 0) << "fingers rest while they read";
  studio_.apply(SelectTool{"pencil"});
  input_.hand().set_locked(kFirstModifier);
  rest();
  EXPECT_EQ(ring.count(), 0) << "a modifier";
  input_.hand().set_locked(0);
  rest();
  EXPECT_EQ(ring.count(), 1);
}

TEST_F(PenInputTest, ArrowsMoveTheSelectedLines) {
  mouse_line({100, 100}, {500, 100});
  const auto start = [this] { return studio_.session().document().find({1})->position(0); };
  const Point before = start();
  studio_.apply(SelectStrokes{});
  const std::size_t steps = studio_.session().history().undo_count();
  tap(Qt::Key_Right);
  tap(Qt::Key_Down, Qt::ShiftModifier);
  tap(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_NEAR(start().x - before.x, 0.9, 1e-9);
  EXPECT_NEAR(start().y - before.y, 10.0, 1e-9);
  EXPECT_EQ(studio_.session().history().undo_count(), steps + 1) << "they are one step";
  CanvasView turned = canvas_.view();
  turned.set_angle(90);
  canvas_.set_view(turned);
  const Point there = start();
  tap(Qt::Key_Right);
  EXPECT_NEAR(std::abs(start().y - there.y), 1.0, 1e-6) << "as the view is turned";
  studio_.apply(SelectStrokes{SelectStrokes::What::kNone});
  const Point after = start();
  tap(Qt::Key_Right);
  EXPECT_EQ(start(), after) << "now the arrows move the pen";
}

TEST_F(PenInputTest, ADragWithCtrlAndAltChangesTheSize) {
  const auto size = [this] { return studio_.session().tool().size()->mm; };
  const double before = size();
  key(QEvent::KeyPress, Qt::Key_Control);
  key(QEvent::KeyPress, Qt::Key_Alt, Qt::ControlModifier);
  mouse_line({100, 100}, {220, 100});
  EXPECT_NEAR(size(), 2.0 * before, 1e-6);
  EXPECT_EQ(strokes(), 0u);
  key(QEvent::KeyRelease, Qt::Key_Alt, Qt::ControlModifier | Qt::AltModifier);
  key(QEvent::KeyRelease, Qt::Key_Control, Qt::ControlModifier);
  mouse_line({100, 100}, {220, 100});
  EXPECT_EQ(strokes(), 1u) << "without the keys it draws";
}

TEST_F(PenInputTest, SideButtonsDoWhatTheSettingsSay) {
  hover({100, 100});
  hover({100, 100}, Qt::RightButton);
  EXPECT_EQ(tool(), "eraser");
  hover({100, 100});
  wait(100);
  EXPECT_EQ(tool(), "pencil");
  set(pen_keys::kLowerButton, QStringLiteral("pull"));
  hover({100, 100}, Qt::RightButton);
  EXPECT_EQ(tool(), "pull");
  hover({100, 100});
  wait(100);
  set(pen_keys::kLowerButton, QStringLiteral("undo"));
  tablet_line({100, 100}, {500, 100});
  release({500, 100});
  ASSERT_EQ(strokes(), 1u);
  hover({100, 100}, Qt::RightButton);
  EXPECT_EQ(strokes(), 0u);
  hover({100, 100});
  set(pen_keys::kLowerButton, QStringLiteral("modifier-2"));
  hover({100, 100}, Qt::RightButton);
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, kSecondModifier);
  hover({100, 100});
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, 0u);
  const CanvasView before = canvas_.view();
  hover({100, 100}, Qt::MiddleButton);  // pans the view
  hover({140, 90}, Qt::MiddleButton);
  hover({140, 90});
  const QPointF moved = canvas_.view().to_px(before.to_mm({100, 100}));
  EXPECT_NEAR(moved.x(), 140, 1e-6);
  EXPECT_NEAR(moved.y(), 90, 1e-6);
}

TEST_F(PenInputTest, ShiftCtrlAndAltAreTheToolsModifiers) {
  mouse(QEvent::MouseMove, {100, 100}, Qt::NoButton, Qt::NoButton);
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, 0u);
  key(QEvent::KeyPress, Qt::Key_Shift);
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, kFirstModifier) << "while the pen rests, too";
  key(QEvent::KeyPress, Qt::Key_Control, Qt::ShiftModifier);
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, kFirstModifier | kSecondModifier);
  key(QEvent::KeyRelease, Qt::Key_Shift, Qt::ShiftModifier | Qt::ControlModifier);
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, kSecondModifier);
  key(QEvent::KeyPress, Qt::Key_Alt, Qt::ControlModifier);
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, kSecondModifier | kThirdModifier);
  QFocusEvent out(QEvent::FocusOut);
  QApplication::sendEvent(&canvas_, &out);
  wait(50);
  EXPECT_EQ(studio_.pen().sample.buttons, 0u);
}

TEST_F(PenInputTest, MouseEventsMadeOfOthersAreIgnored) {
  mouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier,
        Qt::MouseEventSynthesizedBySystem);
  mouse(QEvent::MouseMove, {300, 100}, Qt::NoButton, Qt::LeftButton, Qt::NoModifier,
        Qt::MouseEventSynthesizedByQt);
  wait(100);
  EXPECT_FALSE(is_down());
}

TEST_F(PenInputTest, PressureCanBeSwitchedOffAndHasAThreshold) {
  set(pen_keys::kThreshold, 0.2);
  hover({100, 100});
  tablet(QEvent::TabletPress, {100, 100}, 0.1, Qt::LeftButton, Qt::LeftButton);
  wait(50);
  EXPECT_FALSE(is_down());
  tablet(QEvent::TabletMove, {110, 100}, 0.6, Qt::LeftButton);
  wait(50);
  EXPECT_TRUE(is_down());
  EXPECT_NEAR(studio_.pen().sample.pressure.value_or(0), 0.5, 1e-6);
  release({110, 100});
  set(pen_keys::kPressureOn, false);
  for (const double raw : {0.3, 0.9}) {
    tablet(QEvent::TabletPress, {100, 100}, raw, Qt::LeftButton, Qt::LeftButton);
    wait(50);
    EXPECT_EQ(studio_.pen().sample.pressure, 0.5);
    release({100, 100});
  }
}

TEST_F(PenInputTest, SpaceAndADragMoveTheView) {
  const CanvasView before = canvas_.view();
  key(QEvent::KeyPress, Qt::Key_Space);
  mouse_line({100, 100}, {180, 130});
  EXPECT_EQ(strokes(), 0u);
  const QPointF moved = canvas_.view().to_px(before.to_mm({100, 100}));
  EXPECT_NEAR(moved.x(), 180, 1e-6);
  EXPECT_NEAR(moved.y(), 130, 1e-6);
  key(QEvent::KeyPress, Qt::Key_Control, Qt::NoModifier);
  mouse_line({400, 300}, {400, 180});
  EXPECT_NEAR(canvas_.view().px_per_mm() / before.px_per_mm(), 2.0, 1e-6);
  key(QEvent::KeyRelease, Qt::Key_Control, Qt::ControlModifier);
  key(QEvent::KeyPress, Qt::Key_Shift);
  mouse_line({600, 300}, {400, 500});
  EXPECT_NEAR(canvas_.view().angle_deg(), 90.0, 1e-6);
  key(QEvent::KeyRelease, Qt::Key_Shift, Qt::ShiftModifier);
  key(QEvent::KeyRelease, Qt::Key_Space);
  EXPECT_EQ(strokes(), 0u);
  mouse_line({400, 300}, {500, 320});
  EXPECT_EQ(strokes(), 1u);
}

TEST_F(PenInputTest, TheWheelZoomsAtThePointer) {
  const auto wheel = [this](QPoint angle, Qt::KeyboardModifiers keys) {
    QWheelEvent event({200, 150}, {200, 150}, {}, angle, Qt::NoButton, keys, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&canvas_, &event);
  };
  const CanvasView before = canvas_.view();
  const Point fixed = before.to_mm({200, 150});
  wheel({0, 480}, Qt::NoModifier);
  EXPECT_NEAR(canvas_.view().px_per_mm() / before.px_per_mm(), 2.0, 1e-9);
  EXPECT_NEAR(canvas_.view().to_px(fixed).x(), 200, 1e-6);
  wheel({0, -480}, Qt::ControlModifier);
  EXPECT_NEAR(canvas_.view().px_per_mm() / before.px_per_mm(), std::exp2(0.75), 1e-9);
  wheel({0, 120}, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NEAR(canvas_.view().angle_deg(), 5.0, 1e-9);
}

TEST_F(PenInputTest, TwoFingersMoveAndZoomTheView) {
  static QPointingDevice* screen = QTest::createTouchDevice();
  const CanvasView before = canvas_.view();
  QTest::touchEvent(&canvas_, screen).press(1, {300, 300}).press(2, {400, 300});
  QTest::touchEvent(&canvas_, screen).move(1, {280, 300}).move(2, {480, 300});
  QTest::touchEvent(&canvas_, screen).release(1, {280, 300}).release(2, {480, 300});
  EXPECT_NEAR(canvas_.view().px_per_mm() / before.px_per_mm(), 2.0, 1e-6);
  const QPointF left = canvas_.view().to_px(before.to_mm({300, 300}));
  EXPECT_NEAR(left.x(), 280, 1.0);
  EXPECT_EQ(strokes(), 0u);
}

TEST_F(PenInputTest, ATapOfTwoFingersUndoesAndOfThreeRedoes) {
  static QPointingDevice* screen = QTest::createTouchDevice();
  // The studio's clock counts, which stands still here: a busy machine makes no tap longer.
  int pause_ms = 0;
  const auto tap = [&](int fingers, int move_px) {
    // One sequence, because it knows where the stationary fingers are.
    auto touch = QTest::touchEvent(&canvas_, screen);
    for (int last = 1; last <= fingers; ++last) {
      for (int i = 1; i < last; ++i) touch.stationary(i);
      touch.press(last, {300 + 60 * last, 300});
      touch.commit();
    }
    for (int i = 1; i <= fingers; ++i) touch.move(i, {300 + 60 * i, 300 + move_px});
    touch.commit();
    QTest::qSleep(std::exchange(pause_ms, 0));
    for (int first = 1; first <= fingers; ++first) {
      touch.release(first, {300 + 60 * first, 300 + move_px});
      for (int i = first + 1; i <= fingers; ++i) touch.stationary(i);
      touch.commit();
    }
  };
  const auto add_line = [this] {
    StrokeData data;
    data.points = {{10, 10}, {20, 10}, {30, 10}, {40, 10}};
    data.widths = {{0.0, 1.0}, {1.0, 1.0}};
    canvas_.studio().import(
        QStringLiteral("test"),
        std::vector{std::make_shared<const Stroke>(Stroke::create(std::move(data)).value())});
  };
  const CanvasView before = canvas_.view();
  set(pen_keys::kTouchTaps, true);
  for (const char* mode : {"pan", "draw"}) {
    set(pen_keys::kTouch, QString::fromLatin1(mode));
    add_line();
    pause_ms = 400;
    tap(2, 5);
    EXPECT_EQ(strokes(), 0u) << mode;
    EXPECT_EQ(canvas_.view(), before) << "a tap does not move the view";
    tap(3, 5);
    EXPECT_EQ(strokes(), 1u) << mode;
    canvas_.studio().apply(UndoEvent{});
  }
  set(pen_keys::kTouch, QStringLiteral("pan"));
  add_line();
  tap(1, 0);
  tap(4, 0);
  tap(2, 60);
  EXPECT_EQ(strokes(), 1u) << "one finger, four fingers, and two that move the view";
  EXPECT_NE(canvas_.view(), before);
  set(pen_keys::kTouchTaps, false);
  tap(2, 0);
  EXPECT_EQ(strokes(), 1u) << "it is off";
  canvas_.set_view(before);
}

TEST_F(PenInputTest, APalmIsNoFinger) {
  static QPointingDevice* screen = QTest::createTouchDevice();
  set(pen_keys::kTouch, QStringLiteral("draw"));
  QTest::touchEvent(&canvas_, screen).press(1, {300, 300});
  wait(20);
  QTest::touchEvent(&canvas_, screen).move(1, {350, 300});
  wait(20);
  ASSERT_TRUE(is_down());
  hover({100, 100});  // the pen arrives: the finger's line is discarded
  wait(60);
  EXPECT_FALSE(is_down());
  QTest::touchEvent(&canvas_, screen).move(1, {380, 300});
  QTest::touchEvent(&canvas_, screen).release(1, {380, 300});
  QTest::touchEvent(&canvas_, screen).press(1, {300, 300});
  QTest::touchEvent(&canvas_, screen).move(1, {380, 300});
  QTest::touchEvent(&canvas_, screen).release(1, {380, 300});
  wait(300);
  EXPECT_EQ(strokes(), 0u);
}

TEST_F(PenInputTest, AFingerDrawsWhereItMay) {
  static QPointingDevice* screen = QTest::createTouchDevice();
  const auto drag = [this](int y) {
    QTest::touchEvent(&canvas_, screen).press(1, {100, y});
    for (int x = 110; x <= 400; x += 10) {
      wait(8);
      QTest::touchEvent(&canvas_, screen).move(1, {x, y});
    }
    QTest::touchEvent(&canvas_, screen).release(1, {400, y});
    wait(300);
  };
  const CanvasView before = canvas_.view();
  set(pen_keys::kTouch, QStringLiteral("off"));
  drag(100);
  EXPECT_EQ(strokes(), 0u);
  EXPECT_EQ(canvas_.view(), before);
  set(pen_keys::kTouch, QStringLiteral("draw"));
  drag(200);
  EXPECT_EQ(strokes(), 1u);
  EXPECT_EQ(canvas_.view(), before);
  set(pen_keys::kTouch, QStringLiteral("pan"));
  drag(300);
  EXPECT_EQ(strokes(), 1u);
  EXPECT_NE(canvas_.view(), before);
}

/// A device that moves only in the plane. A user holds it and draws a line to the right.
class PlanarPen : public DriverDevice {
 public:
  explicit PlanarPen(const Capabilities& capabilities) {
    descriptor_.label = "Planar";
    descriptor_.capabilities = capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override { return {}; }
  bool set_pen_down(bool is_down) noexcept override {
    is_down_ = is_down;
    return true;
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "planar"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    const double x_mm = 20.0 + 1e-8 * static_cast<double>(now_ns);  // 10 mm/s
    return PenSample{now_ns, {x_mm, 40.0, is_down_ ? -0.25 : 0.25}, {10, 0, 0}, {}, 0};
  }
  tl::expected<void, DeviceFault> write(const Force&) noexcept override { return {}; }
  void stop() noexcept override {}

 private:
  DeviceDescriptor descriptor_;
  bool is_down_ = false;
};

// The case of a user with a 2DIY: one hand moves it, the other holds a key in order to draw.
TEST_F(PenInputTest, AKeyThatIsHeldPutsAPlanarDevicesPenDown) {
  PenDeviceInfo info;
  info.id = QStringLiteral("planar:1");
  info.label = info.note = QStringLiteral("Planar");
  info.capabilities.sensed_axes = info.capabilities.actuated_axes = 2;
  info.capabilities.workspace_min = {0, 0, -1};
  info.capabilities.workspace_max = {100, 80, 1};
  info.has_own_frame = true;  // like the 2DIY, it needs the user's plane
  const int driver = add_pen_driver(
      {[info] { return std::vector<PenDeviceInfo>{info}; },
       [info](const QString&, const DeviceSetup& asked) -> Result<std::unique_ptr<OpenDevice>> {
         EXPECT_FALSE(asked.open.pen_begins_down);
         return std::make_unique<OpenDevice>(std::make_unique<PlanarPen>(info.capabilities),
                                             PlaneCalibration(), asked);
       }});
  ASSERT_TRUE(studio_.use_device(info.id));
  wait(300);
  EXPECT_EQ(studio_.session().document().stroke_count(), 0U) << "the pen is up by itself";
  for (int line = 1; line <= 2; ++line) {
    key(QEvent::KeyPress, Qt::Key_Return);
    wait(200);
    key(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, true);  // auto-repeat
    wait(200);
    if (line == 1) {
      key(QEvent::KeyRelease, Qt::Key_Return);
    } else {  // the window loses the focus, so no release arrives
      QFocusEvent out(QEvent::FocusOut);
      QApplication::sendEvent(&canvas_, &out);
    }
    wait(300);
    EXPECT_EQ(studio_.session().document().stroke_count(), static_cast<std::size_t>(line));
  }
  ASSERT_TRUE(studio_.use_device(QString::fromLatin1(kPenDeviceDefault)));
  remove_pen_driver(driver);
}

/// A device whose pen a hand presses against the surface, and moves less than 1 mm.
class RestingPen final : public PlanarPen {
 public:
  using PlanarPen::PlanarPen;
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    const double x_mm = 20.0 + 0.1 * std::sin(1e-7 * static_cast<double>(now_ns));
    return PenSample{now_ns, {x_mm, 40.0, -0.25}, {}, {}, 0};
  }
};

TEST_F(PenInputTest, ThePenOfADeviceMayPressLong) {
  QSignalSpy ring(&canvas_, &Canvas::ring_pressed);
  PenDeviceInfo info;
  info.id = QStringLiteral("resting:1");
  info.label = info.note = QStringLiteral("Resting");
  info.capabilities.workspace_min = {0, 0, -1};
  info.capabilities.workspace_max = {100, 80, 1};
  const int driver = add_pen_driver(
      {[info] { return std::vector<PenDeviceInfo>{info}; },
       [info](const QString&, const DeviceSetup& asked) -> Result<std::unique_ptr<OpenDevice>> {
         return std::make_unique<OpenDevice>(std::make_unique<RestingPen>(info.capabilities),
                                             PlaneCalibration(), asked);
       }});
  for (const bool on : {false, true}) {
    set(pen_keys::kLongPress, on);
    ASSERT_TRUE(studio_.use_device(info.id));
    wait(LongPress::kPressNs / kMs + 300);
    EXPECT_EQ(ring.count(), on ? 1 : 0);
    ASSERT_TRUE(studio_.use_device(QString::fromLatin1(kPenDeviceDefault)));
    hover({100, 100});
    wait(300);
  }
  EXPECT_EQ(strokes(), 1u) << "the press that opened no ring";
  remove_pen_driver(driver);
}

// Keys alone draw a line, erase across it, and undo. The same keys make the same line.
TEST_F(PenInputTest, KeysDrawAndEdit) {
  tap(Qt::Key_Return);
  EXPECT_FALSE(is_down()) << "an Enter that was meant for a text field";
  tap(Qt::Key_Left);
  const auto draw = [this] {
    tap(Qt::Key_Return);
    for (int i = 0; i < 60; ++i) key(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, i > 0);
    key(QEvent::KeyRelease, Qt::Key_Right);
    tap(Qt::Key_Return);
    wait(300);
  };
  const Point start = input_.hand().place_mm();
  draw();
  EXPECT_EQ(strokes(), 1u);
  const double way_px = (input_.hand().place_mm().x - start.x) * canvas_.view().px_per_mm();
  EXPECT_GT(way_px, 60 * KeyboardPen::kStepPx) << "faster while it is held";
  studio_.apply(SelectTool{"eraser"});
  for (int i = 0; i < 20; ++i) tap(Qt::Key_Left);
  for (int i = 0; i < 10; ++i) tap(Qt::Key_Up);
  tap(Qt::Key_Insert);
  for (int i = 0; i < 20; ++i) tap(Qt::Key_Down);
  tap(Qt::Key_Insert);
  wait(300);
  EXPECT_EQ(strokes(), 2u);
  studio_.apply(UndoEvent{});
  EXPECT_EQ(strokes(), 1u);
  const Point here = input_.hand().place_mm();
  tap(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR((input_.hand().place_mm().x - here.x) * canvas_.view().px_per_mm(),
              KeyboardPen::kFineStepPx, 1e-9);
  studio_.apply(SelectTool{"pencil"});
  tap(Qt::Key_Enter);
  for (int i = 0; i < 30; ++i) tap(Qt::Key_Down);
  tap(Qt::Key_Escape);
  wait(300);
  EXPECT_EQ(strokes(), 1u);
  EXPECT_FALSE(is_down());
}

TEST_F(PenInputTest, TheViewFollowsTheKeys) {
  for (int i = 0; i < 200; ++i) key(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier, i > 0);
  const QPointF px = canvas_.view().to_px(input_.hand().place_mm());
  EXPECT_GT(px.y(), 0);
  EXPECT_LT(px.y(), 600);
}

// Qt 6.4 rounds a mouse position for child widgets; only the position in the window has fractions.
TEST_F(PenInputTest, AMouseIsExactToAFractionOfAPixel) {
  const QPointF exact(200.5, 150.25);
  QMouseEvent event(QEvent::MouseMove, QPointF(exact.toPoint()), exact,
                    QPointF(canvas_.mapToGlobal(exact).toPoint()), Qt::NoButton, Qt::NoButton,
                    Qt::NoModifier);
  QApplication::sendEvent(&canvas_, &event);
  wait(50);
  EXPECT_LT(distance(studio_.pen().hand, canvas_.view().to_mm(exact)), 1e-6);
}

TEST_F(PenInputTest, ThePointerBringsTheFocusBackButNotFromAText) {
  QWidget window;
  canvas_.setParent(&window);
  canvas_.setGeometry(0, 0, 800, 600);
  QPushButton button(&window);
  QDoubleSpinBox number(&window);
  QLineEdit text(&window);
  for (QWidget* widget : std::initializer_list<QWidget*>{&button, &number, &text}) widget->show();
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  const auto enter = [this](QWidget& focus) {
    focus.setFocus();
    QEnterEvent event(QPointF(10, 10), QPointF(10, 10), QPointF(10, 10));
    QApplication::sendEvent(&canvas_, &event);
    return canvas_.hasFocus();
  };
  EXPECT_TRUE(enter(button));
  EXPECT_TRUE(enter(number));
  EXPECT_FALSE(enter(text));
  canvas_.setParent(nullptr);
}

TEST_F(PenInputTest, APointerThatRestsWhereTheWindowOpensIsShownWhereItIs) {
  const QPointF at(300, 200);
  QEnterEvent event(at, at, at);
  QApplication::sendEvent(&canvas_, &event);
  wait(30);
  const Point expected = canvas_.view().to_mm(at);
  EXPECT_NEAR(studio_.pen().hand.x, expected.x, 1e-6);
  EXPECT_NEAR(studio_.pen().hand.y, expected.y, 1e-6);
  EXPECT_NEAR(studio_.pen().sample.position.x, expected.x, 0.1);
  EXPECT_NEAR(studio_.pen().sample.position.y, expected.y, 0.1);
}

}  // namespace
}  // namespace felt::desktop::pen_input_test
