#include "desktop/window/offer_popup.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "desktop/testing/accessible_names.h"
#include "desktop/window/main_window.h"

namespace felt::desktop::offer_popup_test {
namespace {

class OfferPopupTest : public ::testing::Test {
 protected:
  OfferPopupTest() {
    window_.show();
    popup_ = window_.findChild<OfferPopup*>();
    for (const char* id : {"pencil.scratch_out", "pencil.double_loop", "pencil.shapes"}) {
      studio().apply(SetOption{id, true});
    }
    studio().apply(SetOption{"pencil.snap", std::string("off")});
  }

  Studio& studio() { return window_.studio(); }
  const Session& session() { return studio().session(); }
  void pen(Point at, double z, double pressure) {
    now_ += 4'000'000;
    studio().point(
        {studio().now_ns(), at, z < 0.0, z < 0.0 ? std::optional(pressure) : std::nullopt});
    studio().advance(4'000'000);
  }
  void stroke(const std::vector<Point>& points, double pressure = 0.4) {
    pen(points.front(), 1.0, 0.0);
    for (const Point p : points) pen(p, -0.1, pressure);
    pen(points.back(), 1.0, 0.0);
    for (int i = 0; i < 20; ++i) pen(points.back(), 1.0, 0.0);
  }
  void line() {
    std::vector<Point> points;
    for (int i = 0; i <= 40; ++i) points.push_back({40.0 + 0.5 * i, 60.0});
    stroke(points);
  }
  void scratch() {
    std::vector<Point> points;
    for (int pass = 0; pass < 9; ++pass) {
      for (int i = 0; i < 20; ++i) {
        const double share = pass % 2 == 0 ? i / 20.0 : 1.0 - i / 20.0;
        points.push_back({37.0 + 26.0 * share, 56.0 + pass + i / 20.0});
      }
    }
    stroke(points);
  }
  QToolButton* button(const QString& text) {
    for (QToolButton* b : popup_->findChildren<QToolButton*>()) {
      if (b->text() == text && b->isVisibleTo(popup_)) return b;
    }
    return nullptr;
  }
  std::size_t lines() { return session().document().layers().back().strokes.size(); }

  MainWindow window_{StudioOptions{.device = QStringLiteral("tablet"), .live = false}};
  OfferPopup* popup_ = nullptr;
  std::int64_t now_ = 0;
};

TEST_F(OfferPopupTest, ScratchingOutOffersToDeleteAndKeepsTheInkUntilThen) {
  ASSERT_TRUE(popup_);
  line();
  EXPECT_FALSE(popup_->isVisible());
  scratch();
  ASSERT_TRUE(popup_->isVisible());
  EXPECT_EQ(lines(), 2U);
  EXPECT_FALSE(popup_->isAncestorOf(QApplication::focusWidget())) << "it does not steal the focus";
  EXPECT_TRUE(nameless_controls(*popup_).isEmpty());
  EXPECT_TRUE(popup_->accessibleName().contains(QStringLiteral("Delete 1 line")));
  ASSERT_TRUE(button(QStringLiteral("Keep the ink")));
  EXPECT_TRUE(button(QStringLiteral("Keep the ink"))->isChecked());
  button(QStringLiteral("Delete 1 line"))->click();
  EXPECT_EQ(lines(), 0U);
  EXPECT_FALSE(popup_->isVisible());
  studio().apply(UndoEvent{});
  EXPECT_EQ(lines(), 1U) << "one step";
}

TEST_F(OfferPopupTest, KeysChooseAndEscapeKeepsTheInk) {
  line();
  scratch();
  window_.actions().find(QStringLiteral("edit.cancel"))->trigger();
  EXPECT_FALSE(popup_->isVisible());
  EXPECT_EQ(lines(), 2U);
  studio().apply(UndoEvent{});
  scratch();
  window_.actions().find(QStringLiteral("edit.take_offer"))->trigger();
  EXPECT_EQ(lines(), 0U);
}

TEST_F(OfferPopupTest, TheKeysOfAnOfferAreNotThoseOfThePen) {
  auto* canvas = window_.findChild<Canvas*>();
  QTest::keyClick(canvas, Qt::Key_Right);  // from now on, Enter moves the pen down and up
  const auto is_for_pen = [canvas](Qt::KeyboardModifiers modifiers) {
    QKeyEvent event(QEvent::ShortcutOverride, Qt::Key_Return, modifiers);
    event.ignore();
    QApplication::sendEvent(canvas, &event);
    return event.isAccepted();
  };
  EXPECT_TRUE(is_for_pen(Qt::NoModifier));
  EXPECT_FALSE(is_for_pen(Qt::ControlModifier));
  EXPECT_FALSE(is_for_pen(Qt::ControlModifier | Qt::ShiftModifier));
}

TEST_F(OfferPopupTest, ItIsNeverUnderThePenAndDescribesTheCanvas) {
  auto* canvas = window_.findChild<Canvas*>();
  line();
  const QString before = canvas->accessibleDescription();
  CanvasView view = canvas->view();
  view.pan(QPointF(canvas->width() - 8.0, canvas->height() - 8.0) - view.to_px({63.0, 66.0}));
  canvas->set_view(view);
  scratch();
  ASSERT_TRUE(popup_->isVisible());
  EXPECT_TRUE(canvas->rect().contains(popup_->geometry()));
  EXPECT_FALSE(
      popup_->geometry().contains(canvas->view().to_px(session().offered()->at).toPoint()));
  EXPECT_TRUE(canvas->accessibleDescription().contains(QStringLiteral("Delete 1 line")));
  window_.actions().find(QStringLiteral("edit.cancel"))->trigger();
  EXPECT_EQ(canvas->accessibleDescription(), before);
}

TEST_F(OfferPopupTest, DrawingOnKeepsTheInk) {
  line();
  scratch();
  line();
  EXPECT_FALSE(popup_->isVisible());
  EXPECT_EQ(lines(), 3U);
}

TEST_F(OfferPopupTest, ARestingPenShowsTheShapeAndStayingTakesIt) {
  std::vector<Point> points;
  for (int i = 0; i <= 80; ++i) {
    const double a = 2.0 * 3.14159265 * i / 80.0;
    points.push_back({80.0 + 15.0 * std::cos(a), 80.0 + 15.0 * std::sin(a)});
  }
  pen(points.front(), 1.0, 0.0);
  for (const Point p : points) pen(p, -0.1, 0.4);
  for (int i = 0; i < 150; ++i) pen(points.back(), -0.1, 0.4);
  ASSERT_TRUE(popup_->isVisible());
  EXPECT_TRUE(popup_->findChild<QLabel*>()->isVisibleTo(popup_));
  ASSERT_TRUE(button(QStringLiteral("Circle")));
  for (int i = 0; i < 300; ++i) pen(points.back(), -0.1, 0.4);
  EXPECT_TRUE(button(QStringLiteral("Circle"))->isChecked());
  for (int i = 0; i < 20; ++i) pen(points.back(), 1.0, 0.0);
  EXPECT_EQ(session().history().undo_label(), "Shape");
  ASSERT_TRUE(popup_->isVisible());
  button(QStringLiteral("Keep the ink"))->click();
  EXPECT_EQ(session().history().undo_label(), "Draw");
  EXPECT_EQ(lines(), 1U);
}

}  // namespace
}  // namespace felt::desktop::offer_popup_test
