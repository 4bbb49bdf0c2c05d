// Chooses a colour in the well of the top bar, or opens a list or a menu, and draws on, as a user
// does: the line must be drawn, and nothing may move the page under the pen.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QMenu>
#include <QMenuBar>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QTest>
#include <QToolButton>
#include <QWindow>
#include <functional>

#include "desktop/engine/message_bar.h"
#include "desktop/panels/colors_panel.h"
#include "desktop/panels/swatch_view.h"
#include "desktop/panels/tool_bar.h"
#include "desktop/window/main_window.h"
#include "desktop/window/size_field.h"

namespace felt::desktop::first_press_test {
namespace {

constexpr QPoint kFrom{200, 300}, kTo{320, 340};

class FirstPress : public ::testing::Test {
 protected:
  FirstPress() {
    window_.resize(1100, 760);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
    window_.activateWindow();
    QApplication::processEvents();
  }
  ~FirstPress() override { window_.studio().set_modified(false); }

  /// Sends the event to the window as the window system does, so that open menus get it first.
  void mouse(QEvent::Type type, const QWidget& on, QPoint at) {
    const QWidget* popup = QApplication::activePopupWidget();
    QWindow* target = (popup ? popup : on.window())->windowHandle();
    const QPoint local = target->mapFromGlobal(on.mapToGlobal(at));
    if (type == QEvent::MouseButtonPress) QTest::mousePress(target, Qt::LeftButton, {}, local);
    if (type == QEvent::MouseMove) QTest::mouseMove(target, local);
    if (type == QEvent::MouseButtonRelease) QTest::mouseRelease(target, Qt::LeftButton, {}, local);
    QApplication::processEvents();
    window_.studio().advance(20'000'000);
  }
  void click(const QWidget& on, QPoint at) {
    mouse(QEvent::MouseButtonPress, on, at);
    mouse(QEvent::MouseButtonRelease, on, at);
  }
  /// Draws a line of ten places on the page. Calls `halfway` in the middle of it.
  void draw(const std::function<void()>& halfway = [] {}) {
    const QWidget& page = window_.canvas();
    const CanvasView& view = window_.canvas().view();
    from_mm_ = view.to_mm(kFrom);
    to_mm_ = view.to_mm(kTo);
    px_per_mm_ = view.px_per_mm();
    mouse(QEvent::MouseButtonPress, page, kFrom);
    for (int i = 1; i <= 10; ++i) {
      mouse(QEvent::MouseMove, page, kFrom + (kTo - kFrom) * i / 10);
      if (i == 5) halfway();
    }
    mouse(QEvent::MouseButtonRelease, page, kTo);
    window_.studio().advance(1'000'000'000);
  }
  /// Expects one line with the ends that the page showed when the line began.
  void expect_whole_line() {
    const Document& document = window_.studio().session().document();
    ASSERT_EQ(document.stroke_count(), 1U);
    const StrokePtr line = document.find(document.layers().front().strokes.front());
    const double px = 1.0 / px_per_mm_;
    EXPECT_LT(distance(line->position(0.0), from_mm_), 2.0 * px);
    EXPECT_LT(distance(line->position(line->segment_count()), to_mm_), 2.0 * px);
    EXPECT_EQ(window_.canvas().view().to_mm(kFrom), from_mm_) << "the page has moved";
    EXPECT_EQ(window_.canvas().view().to_mm(kTo), to_mm_) << "the page has moved";
  }
  ColorsPanel& open_well() {
    auto* well = window_.findChild<QToolButton*>(QStringLiteral("top_color"));
    // The menu of the button runs an event loop of its own, so it is opened without one.
    QMenu* menu = well->menu();
    menu->popup(well->mapToGlobal(QPoint(0, well->height())));
    EXPECT_TRUE(QTest::qWaitForWindowExposed(menu));
    return *menu->findChild<ColorsPanel*>();
  }

  /// Opens a pop-up and returns true if it is open. As on X11, Qt does not send presses beside it
  /// once more.
  bool opens(const std::function<void()>& open) {
    open();
    QApplication::processEvents();
    QWidget* popup = QApplication::activePopupWidget();
    if (popup) popup->setAttribute(Qt::WA_NoMouseReplay);
    return popup != nullptr;
  }
  struct Popup {
    QString name;
    std::function<void()> open;
  };
  /// Returns all pop-ups that can be opened in the window as it is.
  QList<Popup> popups() {
    QList<Popup> all;
    for (QComboBox* box : window_.findChildren<QComboBox*>()) {
      if (!box->isVisible() || !box->isEnabled() || box->count() == 0) continue;
      all.push_back({QStringLiteral("list ") + box->accessibleName(), [box] { box->showPopup(); }});
    }
    for (QToolButton* button : window_.findChildren<QToolButton*>()) {
      if (!button->isVisible() || !button->menu()) continue;
      all.push_back(
          {QStringLiteral("menu of ") + button->accessibleName() + button->objectName(),
           [button] { button->menu()->popup(button->mapToGlobal(QPoint(0, button->height()))); }});
    }
    for (QAction* title : window_.menuBar()->actions()) {
      all.push_back({QStringLiteral("menu ") + title->text(), [this, title] {
                       const QRect place = window_.menuBar()->actionGeometry(title);
                       title->menu()->popup(window_.menuBar()->mapToGlobal(place.bottomLeft()));
                     }});
    }
    all.push_back({QStringLiteral("palette"),
                   [this] { Q_EMIT window_.canvas().popup_wanted(QPointF(330, 120)); }});
    return all;
  }
  /// Returns a pixel of the canvas, such that it and the pixels up to 40 below it are free.
  [[nodiscard]] QPoint free_place() {
    const QWidget& page = window_.canvas();
    const QRect popup = QApplication::activePopupWidget()->geometry();
    for (int x = page.width() - 30; x > 20; x -= 10) {
      const QRect line(page.mapToGlobal(QPoint(x, page.height() - 90)), QSize(1, 41));
      if (!popup.intersects(line)) return {x, page.height() - 90};
    }
    ADD_FAILURE() << "the pop-up covers the page";
    return {};
  }

  MainWindow window_{StudioOptions{.device = QStringLiteral("tablet"), .live = false}};
  Point from_mm_, to_mm_;
  double px_per_mm_ = 1.0;
};

TEST_F(FirstPress, AfterASwatchDraws) {
  ColorsPanel& colors = open_well();
  const QList<SwatchView*> views = colors.findChildren<SwatchView*>();
  for (const SwatchView* swatches : views) {
    if (!swatches->isVisible()) continue;
    const QRect place = swatches->visualRect(swatches->model()->index(3, 0));
    click(*swatches->viewport(), place.center());
  }
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr) << "the menu stays open";
  draw();
  expect_whole_line();
}

TEST_F(FirstPress, BesideAnOpenPopUpDraws) {
  std::size_t drawn = 0;
  for (const Popup& popup : popups()) {
    SCOPED_TRACE(popup.name.toStdString());
    ASSERT_TRUE(opens(popup.open));
    const QPoint at = free_place();
    const QWidget& page = window_.canvas();
    mouse(QEvent::MouseButtonPress, page, at);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr) << "it stays open";
    for (int y = 0; y <= 40; y += 4) mouse(QEvent::MouseMove, page, at + QPoint(0, y));
    mouse(QEvent::MouseButtonRelease, page, at + QPoint(0, 40));
    window_.studio().advance(1'000'000'000);
    EXPECT_EQ(window_.studio().session().document().stroke_count(), ++drawn);
  }
  EXPECT_GE(drawn, 12U) << "lists, menus of buttons, titles, the palette";
}

TEST_F(FirstPress, BesideAnOpenPopUpActsOnTheControl) {
  QAction* eraser = window_.actions().find(QStringLiteral("tool.eraser"));
  QAction* pencil = window_.actions().find(QStringLiteral("tool.pencil"));
  QWidget* button = window_.findChild<ToolBar*>()->widgetForAction(eraser);
  ASSERT_TRUE(button && button->isVisible());
  for (const Popup& popup : popups()) {
    SCOPED_TRACE(popup.name.toStdString());
    pencil->trigger();
    ASSERT_TRUE(opens(popup.open));
    const QRect place(button->mapToGlobal(QPoint()), button->size());
    if (QApplication::activePopupWidget()->geometry().intersects(place)) {
      QApplication::activePopupWidget()->close();
      continue;
    }
    click(*button, button->rect().center());
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_EQ(window_.studio().session().tool().info().id, "eraser");
  }
}

// A press on the control itself only closes its list.
TEST_F(FirstPress, OnTheControlOfAnOpenListClosesIt) {
  int lists = 0;
  for (QComboBox* box : window_.findChildren<QComboBox*>()) {
    if (!box->isVisible() || !box->isEnabled() || box->count() == 0) continue;
    SCOPED_TRACE(box->accessibleName().toStdString());
    ASSERT_TRUE(opens([box] { box->showPopup(); }));
    const QRect popup = QApplication::activePopupWidget()->geometry();
    if (popup.contains(box->mapToGlobal(box->rect().center()))) {
      QApplication::activePopupWidget()->close();
      continue;
    }
    ++lists;
    click(*box, box->rect().center());
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  }
  auto* well = window_.findChild<QToolButton*>(QStringLiteral("top_color"));
  ASSERT_TRUE(opens([well] { well->menu()->popup(well->mapToGlobal(QPoint(0, well->height()))); }));
  click(*well, well->rect().center());
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  EXPECT_EQ(window_.studio().session().document().stroke_count(), 0U);
}

// The first press also draws while a number is being typed.
TEST_F(FirstPress, AfterATypedSizeDraws) {
  auto* size = window_.findChild<SizeField*>();
  ASSERT_TRUE(size && size->isVisible());
  click(*size, size->rect().center());
  size->selectAll();
  QTest::keyClicks(size, QStringLiteral("2"));
  draw();
  expect_whole_line();
}

TEST_F(FirstPress, OfATabletBesideAnOpenPopUpDraws) {
  const auto* pen =
      new QPointingDevice(QStringLiteral("test pen"), 31, QInputDevice::DeviceType::Stylus,
                          QPointingDevice::PointerType::Pen,
                          QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                          1, 3, {}, QPointingDeviceUniqueId::fromNumericId(31), qApp);
  const auto send = [&](QEvent::Type type, QPoint at) {
    const QWidget* popup = QApplication::activePopupWidget();
    QWindow* target = (popup ? popup : static_cast<const QWidget*>(&window_))->windowHandle();
    const QPointF global = window_.canvas().mapToGlobal(QPointF(at));
    const bool touches = type != QEvent::TabletRelease;
    QTabletEvent event(type, pen, target->mapFromGlobal(global), global, touches ? 0.5 : 0.0, 0, 0,
                       0, 0, 0, {}, type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                       touches ? Qt::LeftButton : Qt::NoButton);
    event.setTimestamp(1000 + quint64(window_.studio().now_ns() / 1'000'000));
    QApplication::sendEvent(target, &event);
    QApplication::processEvents();
    window_.studio().advance(10'000'000);
  };
  std::size_t drawn = 0;
  for (const Popup& popup : popups()) {
    SCOPED_TRACE(popup.name.toStdString());
    ASSERT_TRUE(opens(popup.open));
    const QPoint at = free_place();
    send(QEvent::TabletPress, at);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    for (int y = 0; y <= 40; y += 4) send(QEvent::TabletMove, at + QPoint(0, y));
    send(QEvent::TabletRelease, at + QPoint(0, 40));
    window_.studio().advance(1'000'000'000);
    EXPECT_EQ(window_.studio().session().document().stroke_count(), ++drawn);
  }
}

TEST_F(FirstPress, AMessageDuringALineLeavesThePageInPlace) {
  const QList<MessageBar*> bars = window_.findChildren<MessageBar*>();
  ASSERT_EQ(bars.size(), 3) << "the device, the file, the colour";
  const QRect before = window_.canvas().geometry();
  draw([&] {
    for (MessageBar* bar : bars) bar->show();
    QApplication::processEvents();
    for (const MessageBar* bar : bars) {
      EXPECT_TRUE(bar->isVisible());
      EXPECT_GT(bar->height(), 0);
      EXPECT_EQ(bar->width(), window_.canvas().width());
    }
  });
  expect_whole_line();
  for (MessageBar* bar : bars) bar->hide();
  QApplication::processEvents();
  EXPECT_EQ(window_.canvas().geometry(), before);
  EXPECT_EQ(window_.childAt(window_.canvas().mapTo(&window_, QPoint(20, 5))), &window_.canvas())
      << "a closed message lies over the page";
}

TEST_F(FirstPress, AMessageTakesItsOwnClicks) {
  MessageBar* bar = window_.findChild<MessageBar*>(QStringLiteral("color_notice"));
  bar->show();
  QApplication::processEvents();
  click(*bar, QPoint(3, 3));
  window_.studio().advance(1'000'000'000);
  EXPECT_EQ(window_.studio().session().document().stroke_count(), 0U);
}

}  // namespace
}  // namespace felt::desktop::first_press_test
