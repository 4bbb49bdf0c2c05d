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

}  // namespace
}  // namespace felt::desktop::guide_actions_test
