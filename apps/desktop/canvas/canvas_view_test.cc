#include "desktop/canvas/canvas_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace felt::desktop::canvas_view_test {
namespace {

class ViewDice {
 public:
  double between(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine_); }
  bool coin() { return between(0, 1) < 0.5; }
  CanvasView view() {
    CanvasView view;
    view.set_size({std::floor(between(50, 4000)), std::floor(between(50, 3000))});
    view.center_on({between(-500, 500), between(-500, 500)});
    view.set_scale(std::exp(between(std::log(CanvasView::kMinPxPerMm),  //
                                    std::log(CanvasView::kMaxPxPerMm))));
    if (coin()) view.set_angle(coin() ? 90.0 * std::floor(between(-2, 3)) : between(-180, 180));
    if (coin()) view.mirror();
    return view;
  }
  QPointF place_in(const CanvasView& view) {
    return {between(0, view.size().width()), between(0, view.size().height())};
  }

 private:
  std::mt19937 engine_{20261121};
};

double apart(QPointF a, QPointF b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

TEST(CanvasView, ThereAndBackIsHome) {
  ViewDice dice;
  for (int i = 0; i < 2000; ++i) {
    const CanvasView view = dice.view();
    const QPointF px = dice.place_in(view);
    EXPECT_LT(apart(view.to_px(view.to_mm(px)), px), 1e-6) << i;
    const Point mm{dice.between(-1000, 1000), dice.between(-1000, 1000)};
    EXPECT_LT(distance(view.to_mm(view.to_px(mm)), mm), 1e-9) << i;
    EXPECT_LT(apart(view.transform().map(QPointF(mm.x, mm.y)), view.to_px(mm)),
              1e-9 * (1000.0 + 2000.0 * view.px_per_mm()))
        << i;
  }
}

TEST(CanvasView, ZoomAndTurnKeepWhatIsUnderThePointer) {
  ViewDice dice;
  for (int i = 0; i < 2000; ++i) {
    CanvasView view = dice.view();
    const QPointF at = dice.place_in(view);
    const Point under = view.to_mm(at);
    const double angle = view.angle_deg();
    view.zoom(std::exp(dice.between(-3, 3)), at);
    EXPECT_LT(apart(view.to_px(under), at), 1e-6) << i;
    const double by = dice.between(-400, 400);
    view.turn(by, at);
    EXPECT_LT(apart(view.to_px(under), at), 1e-6) << i;
    EXPECT_NEAR(std::remainder(view.angle_deg() - angle - by, 360.0), 0.0, 1e-9) << i;
  }
}

TEST(CanvasView, TurnsClockwiseAsSeenMirroredOrNot) {
  ViewDice dice;
  for (int i = 0; i < 200; ++i) {
    CanvasView view = dice.view();
    const QPointF middle(view.size().width() / 2, view.size().height() / 2);
    const Point right = view.to_mm(middle + QPointF(10, 0));
    view.turn(90, middle);
    EXPECT_LT(apart(view.to_px(right), middle + QPointF(0, 10)), 1e-6) << i;
  }
}

TEST(CanvasView, PanMovesThePageWithTheHand) {
  ViewDice dice;
  for (int i = 0; i < 500; ++i) {
    CanvasView view = dice.view();
    const QPointF from = dice.place_in(view);
    const QPointF by(dice.between(-900, 900), dice.between(-900, 900));
    const Point held = view.to_mm(from);
    view.pan(by);
    EXPECT_LT(apart(view.to_px(held), from + by), 1e-6) << i;
  }
}

TEST(CanvasView, MirrorsAboutTheMiddle) {
  ViewDice dice;
  for (int i = 0; i < 500; ++i) {
    CanvasView view = dice.view();
    const CanvasView before = view;
    const QPointF px = dice.place_in(view);
    const Point mm = view.to_mm(px);
    view.mirror();
    EXPECT_LT(apart(view.to_px(mm), {view.size().width() - px.x(), px.y()}), 1e-6) << i;
    view.mirror();
    EXPECT_EQ(view, before);
  }
}

TEST(CanvasView, FitShowsAllOfItHoweverTurned) {
  ViewDice dice;
  for (int i = 0; i < 1000; ++i) {
    CanvasView view = dice.view();
    view.set_size({std::floor(dice.between(200, 4000)), std::floor(dice.between(200, 3000))});
    const double x = dice.between(-500, 500), y = dice.between(-500, 500);
    const Rect box{x, y, x + dice.between(5, 800), y + dice.between(5, 800)};
    view.fit(box, 24.0);
    const QRectF inside = QRectF({0, 0}, view.size()).adjusted(23.9, 23.9, -23.9, -23.9);
    double nearest = 1e9;  // one side touches the margin, so the scale is not smaller than needed
    for (const Point p :
         {Point{box.x0, box.y0}, {box.x1, box.y0}, {box.x0, box.y1}, {box.x1, box.y1}}) {
      const QPointF px = view.to_px(p);
      EXPECT_TRUE(inside.contains(px)) << i;
      nearest = std::min({nearest, px.x() - inside.left(), px.y() - inside.top()});
    }
    if (view.px_per_mm() < CanvasView::kMaxPxPerMm) {
      EXPECT_LT(nearest, 0.3) << i;
    }
  }
}

TEST(CanvasView, VisibleHoldsEveryCornerAndTakesNoNonsense) {
  ViewDice dice;
  for (int i = 0; i < 200; ++i) {
    CanvasView view = dice.view();
    const Point mm = view.to_mm(dice.place_in(view));
    EXPECT_TRUE(view.visible_mm().inflated(1e-6).contains(mm)) << i;
    const CanvasView before = view;
    view.zoom(0.0, {1, 1});
    view.zoom(-2.0, {1, 1});
    view.zoom(std::nan(""), {1, 1});
    view.set_angle(HUGE_VAL);
    view.set_scale(std::nan(""));
    view.fit({});
    EXPECT_EQ(view, before);
  }
}

}  // namespace
}  // namespace felt::desktop::canvas_view_test
