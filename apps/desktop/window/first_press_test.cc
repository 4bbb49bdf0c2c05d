// Chooses a colour in the well of the top bar and draws on, as a user does: the line must be drawn.
#include <gtest/gtest.h>

#include <QApplication>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <QWindow>
#include <cmath>

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
  /// Draws a line of ten places on the page.
  void draw() {
    const QWidget& page = window_.canvas();
    mouse(QEvent::MouseButtonPress, page, kFrom);
    for (int i = 1; i <= 10; ++i) mouse(QEvent::MouseMove, page, kFrom + (kTo - kFrom) * i / 10);
    mouse(QEvent::MouseButtonRelease, page, kTo);
    window_.studio().advance(1'000'000'000);
  }
  void expect_whole_line() {
    const Document& document = window_.studio().session().document();
    ASSERT_EQ(document.stroke_count(), 1U);
    const CanvasView& view = window_.canvas().view();
    const Point from = view.to_mm(kFrom), to = view.to_mm(kTo);
    const double length_mm = norm(to - from);
    const Rect box = document.find(document.layers().front().strokes.front())->bounds();
    EXPECT_NEAR(std::hypot(box.x1 - box.x0, box.y1 - box.y0), length_mm, 0.1 * length_mm);
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

}  // namespace
}  // namespace felt::desktop::first_press_test
