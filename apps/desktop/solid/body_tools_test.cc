#include "desktop/solid/body_tools.h"

#include <gtest/gtest.h>

#include <QTest>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "desktop/engine/settings.h"
#include "desktop/files/testing/studio_fixture.h"
#include "desktop/solid/body_strokes.h"
#include "desktop/solid/solid_panel.h"
#include "desktop/solid/testing/drawn_lines.h"
#include "desktop/testing/accessible_names.h"

namespace felt::desktop::body_tools_test {
namespace {

using testing::draw_square;

/// A panel that shows the body of a square of 40 mm.
class BodyToolsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    draw_square(studio_, {10, 10}, 40.0);
    panel_.scene().resize(400, 400);
    panel_.set_on(true);
    ASSERT_TRUE(waits());
    ASSERT_TRUE(panel_.solid());
  }
  bool waits() {
    return QTest::qWaitFor([this] { return panel_.is_up_to_date(); }, 20000);
  }
  [[nodiscard]] double volume() const {
    double sum = 0.0;
    for (const SolidBody& body : panel_.solid()->bodies) sum += volume_mm3(body);
    return sum;
  }
  [[nodiscard]] std::vector<BodyEdit> edits() const {
    return body_edits_of(studio_.session().document());
  }
  /// Drags over the picture, in pixels.
  void drag(const std::vector<QPointF>& px, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&panel_.scene(), button, {}, px.front().toPoint());
    for (const QPointF p : px) {
      QMouseEvent move(QEvent::MouseMove, p, panel_.scene().mapToGlobal(p), button, button, {});
      QCoreApplication::sendEvent(&panel_.scene(), &move);
    }
    QTest::mouseRelease(&panel_.scene(), button, {}, px.back().toPoint());
  }
  [[nodiscard]] QString hint() { return panel_.tools().findChild<QLabel*>()->text(); }

  StudioFixture fixture_{testing::without_threads()};
  Studio& studio_ = fixture_.studio;
  SolidPanel panel_{studio_};
};

TEST_F(BodyToolsTest, R60_ACutIsOneStepOfUndo) {
  const double whole = volume();
  panel_.tools().set_tool(BodyTool::kCut);
  drag({{200, 5}, {200, 200}, {200, 395}});
  ASSERT_TRUE(waits());
  ASSERT_EQ(edits().size(), 1U);
  EXPECT_EQ(edits()[0].kind, BodyEditKind::kCut);
  EXPECT_NEAR(volume(), 0.5 * whole, 0.05 * whole);
  studio_.apply(UndoEvent{});
  ASSERT_TRUE(waits());
  EXPECT_TRUE(edits().empty());
  EXPECT_DOUBLE_EQ(volume(), whole);
  studio_.apply(RedoEvent{});
  ASSERT_TRUE(waits());
  EXPECT_NEAR(volume(), 0.5 * whole, 0.05 * whole);
}

TEST_F(BodyToolsTest, R60_TheEditFollowsTheDrawing) {
  panel_.tools().set_tool(BodyTool::kCut);
  drag({{200, 395}, {200, 200}, {200, 5}});  // upwards: the left half goes
  ASSERT_TRUE(waits());
  const double half = volume();
  draw_square(studio_, {40, 10}, 40.0);  // makes the body wider at the right
  ASSERT_TRUE(waits());
  EXPECT_EQ(edits().size(), 1U);
  EXPECT_GT(volume(), 1.5 * half);
}

TEST_F(BodyToolsTest, ARefusedEditSaysWhyAndIsNotAdded) {
  const double whole = volume();
  panel_.tools().set_tool(BodyTool::kCut);
  drag({{200, 5}, {200, 200}});
  ASSERT_TRUE(waits());
  EXPECT_TRUE(hint().contains(QLatin1String("The stroke ends on the body.")))
      << hint().toStdString();
  EXPECT_TRUE(edits().empty());
  EXPECT_DOUBLE_EQ(volume(), whole);
  drag({{200, 5}, {200, 395}});
  ASSERT_TRUE(waits());
  EXPECT_FALSE(hint().contains(QLatin1String("ends on")));
  EXPECT_EQ(edits().size(), 1U);
}

TEST_F(BodyToolsTest, AnUndoWhileAnEditIsTriedTakesItBack) {
  draw_square(studio_, {80, 10}, 20.0);
  ASSERT_TRUE(waits());
  panel_.tools().set_tool(BodyTool::kCut);
  drag({{100, 5}, {100, 395}});
  studio_.apply(UndoEvent{});
  ASSERT_TRUE(waits());
  EXPECT_TRUE(edits().empty());
  EXPECT_TRUE(studio_.session().history().can_redo()) << "the second square";
}

/// The session takes no edit of the body while a line is drawn.
TEST_F(BodyToolsTest, AnEditThatEndsWhileALineIsDrawnIsAddedAfterIt) {
  const auto point = [this](double x, bool touching) {
    studio_.point({studio_.now_ns(), {x, 100.0}, touching, 0.5});
    studio_.advance(20'000'000);
  };
  panel_.tools().set_tool(BodyTool::kCut);
  drag({{200, 5}, {200, 395}});
  for (int i = 0; i < 20; ++i) point(20.0 + i, true);
  ASSERT_TRUE(studio_.session().gesture_in_progress());
  QTest::qWait(500);
  EXPECT_TRUE(edits().empty());
  point(40.0, false);
  for (int i = 0; i < 50; ++i) point(40.0, false);
  ASSERT_TRUE(waits());
  EXPECT_EQ(edits().size(), 1U);
}

TEST_F(BodyToolsTest, StrokesAreRefusedWhileAnEditIsTried) {
  panel_.tools().set_tool(BodyTool::kPaint);
  drag({{180, 200}, {220, 200}});
  drag({{180, 220}, {220, 220}});
  EXPECT_TRUE(hint().startsWith(QLatin1String("Wait until"))) << hint().toStdString();
  ASSERT_TRUE(waits());
  EXPECT_EQ(edits().size(), 1U);
  drag({{180, 220}, {220, 220}});
  ASSERT_TRUE(waits());
  EXPECT_EQ(edits().size(), 2U);
}

TEST_F(BodyToolsTest, AnExtrusionTakesAClosedLineAndAProfile) {
  const double whole = volume();
  panel_.tools().set_tool(BodyTool::kExtrude);
  drag({{170, 200}, {200, 170}, {230, 170}});
  EXPECT_TRUE(hint().contains(QLatin1String("not closed"))) << hint().toStdString();
  std::vector<QPointF> ring;
  for (int i = 0; i <= 40; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 40;
    ring.emplace_back(200 + 30 * std::cos(a), 200 + 30 * std::sin(a));
  }
  drag(ring);
  EXPECT_TRUE(hint().contains(QLatin1String("profile"))) << hint().toStdString();
  EXPECT_TRUE(edits().empty()) << "the profile is missing";
  drag({{200, 200}, {300, 200}}, Qt::RightButton);  // turns by 50 degrees
  const SolidCamera camera = panel_.scene().camera();
  std::vector<QPointF> profile;
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 20.0 - 1.0;
    const Vec3 px = camera.to_px(Vec3{0, 6.0 * t, 12.0 + 15.0 * (1.0 - t * t)});
    profile.emplace_back(px.x, px.y);
  }
  drag(profile);
  ASSERT_TRUE(waits());
  ASSERT_EQ(edits().size(), 1U) << hint().toStdString();
  EXPECT_EQ(edits()[0].kind, BodyEditKind::kExtrude);
  EXPECT_GT(volume(), 1.003 * whole);
}

TEST_F(BodyToolsTest, PaintHasTheColourOfThePen) {
  panel_.tools().set_tool(BodyTool::kPaint);
  drag({{180, 200}, {220, 200}});
  ASSERT_TRUE(waits());
  ASSERT_EQ(edits().size(), 1U);
  EXPECT_EQ(edits()[0].color, studio_.session().ink_color());
  EXPECT_DOUBLE_EQ(edits()[0].width_mm, 2.0);
  EXPECT_FALSE(panel_.solid()->bodies.front().paint.empty());
}

TEST_F(BodyToolsTest, SmoothingKeepsTheVolume) {
  const double whole = volume();
  panel_.tools().set_tool(BodyTool::kSmooth);
  drag({{180, 200}, {220, 200}});
  ASSERT_TRUE(waits());
  ASSERT_EQ(edits().size(), 1U);
  EXPECT_NEAR(volume(), whole, 0.02 * whole);
}

TEST_F(BodyToolsTest, OtherButtonsTurnAndEscapeEndsTheTool) {
  panel_.tools().set_tool(BodyTool::kPaint);
  const Vec3 before = panel_.scene().camera().towards;
  drag({{180, 200}, {220, 200}}, Qt::RightButton);
  EXPECT_NE(panel_.scene().camera().towards, before);
  QTest::keyClick(&panel_.scene(), Qt::Key_Escape);
  EXPECT_EQ(panel_.tools().tool(), BodyTool::kTurn);
  drag({{180, 200}, {220, 200}});
  ASSERT_TRUE(waits());
  EXPECT_TRUE(edits().empty());
}

TEST_F(BodyToolsTest, TheControlsHaveNames) {
  EXPECT_EQ(nameless_controls(panel_), QStringList());
}

// Seen along the normal, a profile has no height.
TEST(BodyStrokes, AProfileNeedsAViewFromTheSide) {
  ExtrusionRing ring;
  ring.normal = {0, 0, 1};
  const std::vector<QPointF> px{{0, 0}, {10, -10}, {20, 0}};
  EXPECT_FALSE(profile_over_solid(solid_camera(0.0, 0.0), px, ring, {}));
  EXPECT_FALSE(profile_over_solid(solid_camera(15.0, 0.0), px, ring, {}));
  const auto profile = profile_over_solid(solid_camera(60.0, 0.0), px, ring, {100, 50});
  ASSERT_TRUE(profile);
  ASSERT_EQ(profile->size(), 3U);
  for (const Vec3& p : *profile) EXPECT_NEAR(p.x, 100.0, 1e-9) << "in the plane of the normal";
  EXPECT_NEAR((*profile)[1].y, -40.0, 1e-9);
}

}  // namespace
}  // namespace felt::desktop::body_tools_test
