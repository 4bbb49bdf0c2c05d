#include "desktop/window/first_steps.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

#include "desktop/engine/settings.h"
#include "desktop/window/main_window.h"
#include "desktop/window/window_setting_keys.h"
#include "felt/document/testing/small_picture.h"
#include "felt/document/visible_strokes.h"

namespace felt::desktop::first_steps_test {
namespace {

class FirstSteps : public ::testing::Test {
 protected:
  FirstSteps() {
    Settings::the().reset(window_keys::kHasPulled);
    window_.resize(1100, 760);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
    refresh();
  }
  ~FirstSteps() override {
    Settings::the().reset(window_keys::kHasPulled);
    window_.studio().set_modified(false);
  }

  void refresh() {
    window_.canvas().flush();
    QApplication::processEvents();
  }
  void point(Point at, bool down) {
    Studio& studio = window_.studio();
    studio.point({.time_ns = studio.now_ns(), .position = at, .touching = down, .pressure = 0.5});
    studio.advance(20'000'000);
  }
  void draw(Point from, Point to) {
    point(from, false);
    for (int i = 0; i <= 20; ++i) point(from + (to - from) * (i / 20.0), true);
    point(to, false);
    window_.studio().advance(600'000'000);
    refresh();
  }
  PullHint& hint() { return *window_.findChild<PullHint*>(); }
  ExampleButton& button() { return *window_.findChild<ExampleButton*>(); }

  MainWindow window_{StudioOptions{.device = QStringLiteral("tablet"), .live = false}};
};

TEST_F(FirstSteps, NothingLiesOverAPictureToDrawOver) {
  EXPECT_TRUE(button().isVisible());
  window_.studio().apply(AddPicture{"Photo", felt::testing::picture_data(), {9, 0, 0, 9, 9, 9}});
  refresh();
  EXPECT_FALSE(window_.canvas().shows_first_hints());
  EXPECT_FALSE(button().isVisible());
  window_.studio().apply(UndoEvent{});
  refresh();
  EXPECT_TRUE(button().isVisible());
}

TEST_F(FirstSteps, TheFirstLineSaysHowToPullIt) {
  EXPECT_FALSE(hint().isVisible());
  draw({60, 60}, {120, 80});
  ASSERT_TRUE(hint().isVisible());
  EXPECT_EQ(hint().text(), QStringLiteral("Hold A and pull this line"));
  const QPointF end = window_.canvas().view().to_px({120, 80});
  EXPECT_LT((QPointF(hint().pos()) - end).manhattanLength(), 60.0);
  EXPECT_FALSE(hint().geometry().contains(end.toPoint()));
  point({60, 100}, true);
  EXPECT_FALSE(hint().isVisible()) << "not while one draws";
}

TEST_F(FirstSteps, TheHintIsInsideTheWindowAndLetsClicksThrough) {
  const QRect page = window_.canvas().rect();
  for (const QPoint px : {page.topLeft() + QPoint(3, 3), page.bottomRight() - QPoint(3, 3)}) {
    const Point end = window_.canvas().view().to_mm(px);
    draw(end + Vec{px.x() < 100 ? 40.0 : -40.0, px.y() < 100 ? 20.0 : -20.0}, end);
    ASSERT_TRUE(hint().isVisible());
    EXPECT_TRUE(page.contains(hint().geometry()));
    const QPoint middle = hint().geometry().center();
    EXPECT_EQ(window_.canvas().childAt(middle), nullptr);
  }
}

TEST_F(FirstSteps, WhoHasPulledNeedsNoHint) {
  draw({60, 60}, {120, 60});
  ASSERT_TRUE(hint().isVisible());
  ASSERT_TRUE(window_.studio().apply(SelectTool{"pull"}));
  draw({90, 60}, {90, 90});
  EXPECT_TRUE(Settings::the().flag(window_keys::kHasPulled, false));
  ASSERT_TRUE(window_.studio().apply(SelectTool{"pencil"}));
  draw({60, 120}, {120, 120});
  EXPECT_EQ(window_.studio().session().document().stroke_count(), 2U);
  EXPECT_FALSE(hint().isVisible());
}

TEST_F(FirstSteps, TheHintDoesNotGoOnForEver) {
  int seen = 0;
  for (int i = 0; i < PullHint::kMaxTimes + 3; ++i) {
    draw({60, 40.0 + 10.0 * i}, {120, 40.0 + 10.0 * i});
    seen += hint().isVisible() ? 1 : 0;
  }
  EXPECT_EQ(seen, PullHint::kMaxTimes);
}

TEST_F(FirstSteps, AnExampleIsOneClickFromTheEmptyPage) {
  ASSERT_TRUE(button().isVisible());
  EXPECT_TRUE(window_.canvas().rect().contains(button().geometry()));
  EXPECT_FALSE(button().geometry().intersects(window_.canvas().first_hints_area()));
  std::size_t strokes = 0;
  QObject::connect(&window_, &MainWindow::wants_drawing, &window_,
                   [&](const Document& drawing) { strokes = drawing.stroke_count(); });
  QTest::mouseClick(&button(), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return strokes > 10; }, 60'000));
}

TEST_F(FirstSteps, TheButtonGoesWithTheHints) {
  draw({20, 20}, {60, 20});
  EXPECT_FALSE(button().isVisible());
  window_.studio().apply(UndoEvent{});
  window_.studio().advance(600'000'000);
  refresh();
  EXPECT_TRUE(button().isVisible());
  window_.canvas().hide_first_hints();
  refresh();
  EXPECT_FALSE(button().isVisible());
}

}  // namespace
}  // namespace felt::desktop::first_steps_test
