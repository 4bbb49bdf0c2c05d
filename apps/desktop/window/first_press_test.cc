// Chooses a colour in the well of the top bar and draws on, as a user does: the line must be drawn,
// and nothing may move the page under the pen.
#include <gtest/gtest.h>

#include <QApplication>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <QWindow>
#include <functional>

#include "desktop/engine/message_bar.h"
#include "desktop/panels/colors_panel.h"
#include "desktop/panels/swatch_view.h"
#include "desktop/window/main_window.h"

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
