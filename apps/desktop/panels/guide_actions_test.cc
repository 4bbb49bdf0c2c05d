#include "desktop/panels/guide_actions.h"

#include <gtest/gtest.h>

#include <QWidget>

#include "desktop/panels/testing/panels_fixture.h"

namespace felt::desktop::guide_actions_test {
namespace {

using testing::still;

TEST(GuideActions, TheSwitchShowsWhetherTheGuidesAreShownAlsoIfAStrokeRefusesIt) {
  Studio studio{still()};
  QWidget window;
  Actions actions{&window};
  add_guide_actions(actions, studio);
  QAction* show = actions.find(QStringLiteral("guide.show"));
  ASSERT_NE(show, nullptr);
  EXPECT_TRUE(show->isChecked());
  show->trigger();
  EXPECT_FALSE(show->isChecked());
  EXPECT_FALSE(studio.session().document().shows_guides());
  show->trigger();
  EXPECT_TRUE(studio.session().document().shows_guides());
  for (const double z : {5.0, -1.0}) studio.apply(PenEvent{{20.0, 20.0, z}, {}, 0});
  ASSERT_TRUE(studio.session().gesture_in_progress());
  show->trigger();
  EXPECT_TRUE(studio.session().document().shows_guides());
  EXPECT_TRUE(show->isChecked()) << "nothing has changed";
}

/// Draws a line with the pen and the current tool.
void draw(Studio& studio) {
  for (int i = 0; i <= 41; ++i) {
    studio.point({.time_ns = studio.now_ns(),
                  .position = {20.0 + 0.5 * i, 30.0 + 0.25 * i},
                  .touching = i > 0 && i < 41,
                  .pressure = 0.5});
    studio.advance(8'000'000);
  }
  studio.advance(1'000'000'000);
}

// A guide from the menu is there once. What is drawn next is a line along it, not another guide.
TEST(GuideActions, AfterAGuideIsAddedOneDrawsWithTheToolOfBefore) {
  for (const char* kind : {"ruler", "line", "parallels", "ellipse", "perspective", "grid",
                           "isometric_grid", "symmetry"}) {
    Studio studio({.device = QStringLiteral("tablet"), .live = false});
    QWidget window;
    Actions actions{&window};
    add_guide_actions(actions, studio);
    QAction* add = actions.find(QStringLiteral("guide.add_%1").arg(QLatin1String(kind)));
    ASSERT_NE(add, nullptr) << kind;
    const std::string tool(studio.session().tool().info().id);
    add->trigger();
    ASSERT_EQ(studio.session().document().guides().size(), 1U) << kind;
    EXPECT_EQ(studio.session().tool().info().id, tool) << kind;
    draw(studio);
    EXPECT_EQ(studio.session().document().guides().size(), 1U) << kind;
    EXPECT_EQ(studio.session().document().stroke_count(), std::string(kind) == "symmetry" ? 2U : 1U)
        << kind;
  }
}

// Whoever chooses the tool Guide then places the same kind.
TEST(GuideActions, TheToolPlacesTheKindThatTheMenuAddedLast) {
  Studio studio{still()};
  QWidget window;
  Actions actions{&window};
  add_guide_actions(actions, studio);
  const std::string tool(studio.session().first_tool(ToolKind::kGuides)->info().id);
  for (const char* kind : {"symmetry", "perspective", "ruler"}) {
    actions.find(QStringLiteral("guide.add_%1").arg(QLatin1String(kind)))->trigger();
    EXPECT_EQ(studio.session().option(tool + ".kind").value(), OptionValue(std::string(kind)));
  }
}

}  // namespace
}  // namespace felt::desktop::guide_actions_test
