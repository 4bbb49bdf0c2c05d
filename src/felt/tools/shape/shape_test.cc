#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/stroke/fit/width_map.h"
#include "felt/tools/shape/shape_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::shape_test {
namespace {

struct Fixture {
  explicit Fixture(std::string shape) { EXPECT_TRUE(tool.set_option("shape", shape)); }

  testing::Fixture fixture;
  ShapeTool tool;
  testing::Pen pen{tool, fixture};

  StrokePtr drag(Point from, Point to, std::uint32_t buttons = 0) {
    pen.buttons = buttons;
    pen.line(testing::way(from, to, 1.0));
    return fixture.strokes().empty() ? nullptr : fixture.strokes().back();
  }
};

TEST(Shape, ARectangleHasItsCornersAndIsOneStep) {
  Fixture f("rectangle");
  f.fixture.color = {10, 20, 30, 200};
  const StrokePtr drawn = f.drag({20, 10}, {60, 40});
  ASSERT_TRUE(drawn);
  EXPECT_TRUE(drawn->closed());
  ASSERT_EQ(drawn->segment_count(), 4);
  const Point corners[] = {{20, 10}, {60, 10}, {60, 40}, {20, 40}};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(drawn->position(i), corners[i]);
    EXPECT_EQ(drawn->joint(i), JointKind::kCorner);
  }
  EXPECT_EQ(drawn->color(), (Rgba{10, 20, 30, 200}));
  EXPECT_EQ(drawn->width_mm(2.5), Scene::kUsualInkWidthMm);
  EXPECT_EQ(f.pen.commits, 1);
  EXPECT_EQ(f.fixture.history.undo_label(), "Shape");
  f.fixture.undo();
  EXPECT_EQ(f.fixture.document, Document());
}

TEST(Shape, ModifiersMakeSquaresAndCentres) {
  Fixture f("rectangle");
  EXPECT_EQ(f.drag({20, 20}, {50, 30}, kFirstModifier)->position(2), (Point{50, 50}));
  EXPECT_EQ(f.drag({20, 20}, {10, 17}, kFirstModifier)->position(2), (Point{10, 10}));
  const StrokePtr centred = f.drag({20, 20}, {50, 30}, kSecondModifier);
  EXPECT_EQ(centred->position(0), (Point{-10, 10}));
  EXPECT_EQ(centred->position(2), (Point{50, 30}));
}

TEST(Shape, ALineGoesFromThePenDownToThePenInStepsIfWanted) {
  Fixture f("line");
  const StrokePtr line = f.drag({10, 10}, {60, 33});
  EXPECT_EQ(line->position(0), (Point{10, 10}));
  EXPECT_EQ(line->position(1), (Point{60, 33}));
  EXPECT_FALSE(line->closed());
  const StrokePtr level = f.drag({10, 10}, {60, 12}, kFirstModifier);
  EXPECT_EQ(level->position(1), (Point{60, 10}));
  const StrokePtr steep = f.drag({10, 10}, {40, 50}, kFirstModifier);
  const Vec way = steep->position(1) - steep->position(0);
  EXPECT_NEAR(std::atan2(way.y, way.x) * 180.0 / std::numbers::pi, 60.0, 1e-9)
      << "53 degrees are nearer to 60 than to 45";
}

TEST(Shape, ATapAndACancelledDragDrawNothing) {
  Fixture f("ellipse");
  EXPECT_FALSE(f.drag({20, 20}, {20.1, 20.1}));
  f.pen.up({20, 20});
  f.pen.along(testing::way({20, 20}, {50, 50}));
  Overlay overlay;
  f.tool.draw(overlay);
  EXPECT_EQ(overlay.ink.size(), 4U) << "the shape is seen while it is drawn";
  f.tool.cancel();
  f.pen.up({50, 50});
  EXPECT_EQ(f.pen.commits, 0);
}

// The tone is that of a line drawn with half of the pressure, so that a shape and a line that a
// mouse draws look the same.
TEST(Shape, HasTheMediumAndWidthOfNewInk) {
  Fixture f("line");
  Scene scene = f.fixture.scene();
  scene.medium = "charcoal";
  scene.ink_width_mm = 3.5;
  const auto stroke = shape_stroke(ShapeKind::kLine, {{0, 0}, {30, 0}}, scene);
  ASSERT_TRUE(stroke);
  EXPECT_EQ(stroke->medium(), "charcoal");
  EXPECT_EQ(stroke->width_mm(0.5), 3.5);
  const MediumLine& line = medium_of(scene, "charcoal").line;
  EXPECT_NEAR(
      stroke->tone(0.5),
      line.tone_light + (line.tone_heavy - line.tone_light) * std::pow(0.5, line.tone_gamma), 1e-9);
}

RC_GTEST_PROP(Shape, AnEllipseIsExactTo2In10000, ()) {
  const auto number = [](int low, int high) { return 0.01 * *rc::gen::inRange(low, high); };
  const Point from{number(-50'000, 50'000), number(-50'000, 50'000)};
  const Point to = from + Vec{number(21, 40'000), -number(21, 40'000)};
  const testing::Fixture fixture;
  const auto stroke = shape_stroke(ShapeKind::kEllipse, {from, to}, fixture.scene());
  RC_ASSERT(stroke.has_value());
  RC_ASSERT(stroke->closed());
  const Point m = lerp(from, to, 0.5);
  for (double u = 0.0; u < 4.0; u += 0.01) {
    const Vec off = stroke->position(u) - m;
    const double x = 2.0 * off.x / (to.x - from.x), y = 2.0 * off.y / (to.y - from.y);
    RC_ASSERT(std::abs(std::hypot(x, y) - 1.0) < 2.0e-4);
  }
}

}  // namespace
}  // namespace felt::shape_test
