#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/document/testing/random_guides.h"
#include "felt/tools/guide/guide_handles.h"
#include "felt/tools/guide/guide_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::guide_tool_test {
namespace {

struct Fixture {
  explicit Fixture(std::string kind = "ruler") { EXPECT_TRUE(tool.set_option("kind", kind)); }

  testing::Fixture fixture;
  GuideTool tool;
  testing::Pen pen{tool, fixture};

  void drag(Point from, Point to, std::uint32_t buttons = 0) {
    pen.buttons = buttons;
    pen.line(testing::way(from, to, 1.0));
  }
  [[nodiscard]] const DrawingGuide& guide() const {
    return *fixture.document.guides().begin()->second;
  }
  [[nodiscard]] std::size_t count() const { return fixture.document.guides().size(); }
};

TEST(GuideTool, ADragPlacesMovesTurnsAndRemovesARuler) {
  Fixture f;
  f.drag({20, 20}, {70, 20});
  ASSERT_EQ(f.count(), 1U);
  EXPECT_EQ(f.guide().origin, (Point{20, 20}));
  EXPECT_NEAR(f.guide().size_mm, 50.0, 1e-9);
  f.drag({45, 21}, {45, 31});  // at its line
  ASSERT_EQ(f.count(), 1U);
  EXPECT_NEAR(f.guide().origin.y, 30.0, 1e-9);
  f.drag({70, 30}, {20, 90});  // at its end
  EXPECT_NEAR(f.guide().angle_rad, 0.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(f.guide().size_mm, 60.0, 1e-9);
  f.drag({20, 60}, {20, 60}, kSecondModifier);
  EXPECT_EQ(f.count(), 0U);
  EXPECT_EQ(f.pen.commits, 4);
  for (int i = 0; i < 4; ++i) f.fixture.undo();
  EXPECT_EQ(f.fixture.document, Document());
}

TEST(GuideTool, TheFirstModifierTurnsInSteps) {
  Fixture f("line");
  f.drag({20, 20}, {60, 29}, kFirstModifier);
  ASSERT_EQ(f.count(), 1U);
  EXPECT_NEAR(f.guide().angle_rad, 15.0 / kDegPerRad, 1e-9);
}

TEST(GuideTool, EveryKindIsPlacedByADragAndByATap) {
  for (const std::string_view kind : kPlacedGuideKinds) {
    for (const Point to : {Point{80, 55}, Point{40, 40}}) {
      Fixture f{std::string(kind)};
      f.fixture.add(testing::straight_stroke({30, 41}, {90, 41}, 1, 1));
      f.drag({40, 40}, to);
      ASSERT_EQ(f.count(), 1U) << kind;
      EXPECT_EQ(guide_kind_name(f.guide().kind), kind);
      EXPECT_TRUE(check_drawing_guide(f.guide())) << kind;
    }
  }
}

TEST(GuideTool, ATraceNeedsAStroke) {
  Fixture f("trace");
  f.drag({40, 40}, {41, 40});
  EXPECT_EQ(f.count(), 0U);
  EXPECT_EQ(f.pen.commits, 0);
}

TEST(GuideTool, HiddenGuidesAreNotTakenAndANewOneShowsThem) {
  Fixture f;
  f.drag({20, 20}, {70, 20});
  Edit hide{"Hide guides", {}};
  hide.toggles_guides = true;
  f.fixture.apply(hide);
  f.drag({45, 20}, {45, 60});
  EXPECT_EQ(f.count(), 2U) << "placed a second one";
  EXPECT_TRUE(f.fixture.document.shows_guides());
}

TEST(GuideTool, DraggedHandlesFollowThePenAndStayValid) {
  testing::RandomStroke random(4);
  for (int i = 0; i < 500; ++i) {
    const DrawingGuide guide = testing::random_guide(random);
    const std::vector<Point> handles = guide_handles(guide);
    for (std::size_t h = 0; h < handles.size(); ++h) {
      const double far = random.chance(0.1) ? 1e9 : 100.0;
      const Point to{random.uniform(-far, far), random.uniform(-far, far)};
      const DrawingGuide dragged = with_guide_handle(guide, h, to, GuideTurn::kFree);
      ASSERT_TRUE(check_drawing_guide(dragged));
      const bool is_point = h == 0 || guide.kind == DrawingGuideKind::kPerspective;
      if (is_point && far < 1e3) {
        EXPECT_EQ(guide_handles(dragged)[h], to);
      }
    }
    ASSERT_TRUE(check_drawing_guide(moved_guide(guide, {random.uniform(-1e9, 1e9), 5.0})));
  }
}

}  // namespace
}  // namespace felt::guide_tool_test
