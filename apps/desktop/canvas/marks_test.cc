#include "desktop/canvas/marks.h"

#include <gtest/gtest.h>

#include <QRegion>
#include <cmath>

#include "felt/tools/overlay_look.h"

namespace felt::desktop::marks_test {
namespace {

CanvasView at_one_px_per_mm() {
  CanvasView view;
  view.set_size({400, 300});
  view.set_scale(1.0);
  view.center_on({200, 150});  // 1 mm is 1 px
  return view;
}

Marks marks_of(const Overlay& overlay) {
  Marks marks;
  list_overlay(overlay, at_one_px_per_mm(), QFont(), marks);
  return marks;
}

TEST(Marks, WhatIsFarAwayCostsNothing) {
  Overlay overlay;
  overlay.rings.push_back({{1e7, 1e7}, 5.0});
  overlay.dots.push_back({{-1e5, 0}});
  overlay.labels.push_back({{0, 9e9}, "far"});
  overlay.lines.push_back({{-1e9, -1e9}, {-1e8, -1e3}});
  EXPECT_TRUE(marks_of(overlay).empty());
}

TEST(Marks, OfALongDashedLineOnlyWhatIsSeenIsThere) {
  Overlay overlay;
  overlay.lines.push_back({{-1e8, 150}, {1e8, 150}});
  const Marks marks = marks_of(overlay);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_LT(marks[0].points.boundingRect().width(), 1000.0);
  EXPECT_NEAR(marks[0].phase, 1e8, 100.0);
}

TEST(Marks, ALineThatGrowsChangesAtItsEndOnly) {
  Overlay overlay;
  overlay.outlines.push_back({{}, false});
  for (int i = 0; i < 500; ++i) {
    overlay.outlines[0].points.push_back({20.0 + 0.7 * i, 100 + 60 * std::sin(0.1 * i)});
  }
  const Marks before = marks_of(overlay);
  overlay.outlines[0].points.push_back({371, 60});
  const Marks after = marks_of(overlay);
  QRegion region;
  add_difference(before, after, region);
  EXPECT_FALSE(region.isEmpty());
  EXPECT_GT(region.boundingRect().left(), 320);
  QRegion none;
  add_difference(after, after, none);
  EXPECT_TRUE(none.isEmpty());
}

TEST(Marks, LabelsStayInTheWidget) {
  for (const Point at : {Point{2, 2}, {398, 2}, {398, 298}, {2, 298}, {200, 150}}) {
    Overlay overlay;
    overlay.labels.push_back({at, "12.3 mm"});
    const Marks marks = marks_of(overlay);
    ASSERT_EQ(marks.size(), 1u);
    const QRectF plate(marks[0].points[0], marks[0].points[1]);
    EXPECT_TRUE(QRectF(0, 0, 400, 300).contains(plate)) << at.x << "," << at.y;
    EXPECT_FALSE(plate.contains(QPointF(at.x, at.y)));
  }
}

TEST(Marks, ForceSaturatesAndItsSmallestIsNotShown) {
  const auto longest = [](double newton) {
    PenMark pen{{100, 100}, {100, 100}};
    pen.force_n = {newton, 0.0};
    Marks marks;
    list_pen(pen, marks);
    for (const Mark& mark : marks) {
      if (mark.kind == Mark::Kind::kForce) return mark.points[1].x() - mark.points[0].x();
    }
    return 0.0;
  };
  EXPECT_EQ(longest(0.01), 0.0);
  EXPECT_GT(longest(0.1), 3.0);
  EXPECT_GT(longest(1.0), 2 * longest(0.3) * 0.8);
  EXPECT_LT(longest(1000.0), 50.0);
}

TEST(Marks, EveryRoleIsSeenOnLightAndOnDarkPaper) {
  for (const QColor paper : {QColor(255, 255, 255), QColor(28, 30, 34), QColor(20, 60, 40),
                             QColor(250, 240, 210), QColor(255, 255, 255, 0)}) {
    const MarkLook look(paper);
    const QColor ground = paper.alpha() == 0 ? QColor(Qt::white) : paper;
    const auto far_from_ground = [&ground](const QColor& c) {
      return std::abs(c.red() - ground.red()) + std::abs(c.green() - ground.green()) +
             std::abs(c.blue() - ground.blue());
    };
    for (int role = 0; role <= static_cast<int>(Overlay::Role::kAxis); ++role) {
      EXPECT_GT(far_from_ground(look.color(static_cast<Overlay::Role>(role))), 120) << role;
      EXPECT_GT(far_from_ground(look.band(static_cast<Overlay::Role>(role))), 50) << role;
    }
    EXPECT_GT(std::abs(qGray(look.text().rgb()) - qGray(look.plate().rgb())), 150);
  }
}

/// Paints a mark, and checks that something was painted, and only within the box of the mark.
void expect_within_box(const Mark& mark) {
  QImage image(400, 300, QImage::Format_RGB32);
  image.fill(Qt::gray);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_mark(painter, mark, MarkLook(Qt::white), QFont());
  painter.end();
  bool any = false;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      if (image.pixel(x, y) == QColor(Qt::gray).rgb()) continue;
      any = true;
      ASSERT_TRUE(mark.box.contains(x, y)) << "kind " << static_cast<int>(mark.kind);
    }
  }
  EXPECT_TRUE(any);
}

/// A mark paints only within its box; otherwise a partial repaint would leave remains.
TEST(Marks, KeepToTheirBoxes) {
  Overlay overlay;
  using Role = Overlay::Role;
  for (const Role role : {Role::kReach, Role::kSnap, Role::kVector, Role::kHandle, Role::kCut}) {
    overlay.rings = {{{80, 60}, 22.3, role}};
    overlay.lines = {{{150.4, 60}, {190.2, 110.7}, role}};
    overlay.dots = {{{60.5, 140.2}, role}};
    overlay.labels = {{{120, 180}, "17.6 mm, gjy"}};
    overlay.outlines = {{{{230, 40}, {290.5, 60}, {240, 66}}, true, role}};
    Marks marks = marks_of(overlay);
    PenMark pen{{300, 200}, {320.5, 210.2}, 9.0, {-1.2, 0.7}, 0.8};
    list_pen(pen, marks);
    EXPECT_EQ(marks.size(), 9u);
    for (const Mark& mark : marks) expect_within_box(mark);
  }
}

}  // namespace
}  // namespace felt::desktop::marks_test
