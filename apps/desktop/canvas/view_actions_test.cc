#include "desktop/canvas/view_actions.h"

#include <gtest/gtest.h>

#include <QMap>

#include "desktop/canvas/canvas_setting_keys.h"
#include "desktop/canvas/testing/canvas_fixture.h"
#include "desktop/engine/settings.h"

namespace felt::desktop::view_actions_test {
namespace {

class ViewActions : public ::testing::Test {
 protected:
  void SetUp() override { add_view_actions(actions, fixture.canvas); }
  void run(const char* name) {
    QAction* action = actions.find(QString::fromLatin1(name));
    ASSERT_NE(action, nullptr) << name;
    action->trigger();
  }
  [[nodiscard]] const CanvasView& view() const { return fixture.canvas.view(); }

  Fixture fixture;
  Actions actions{&fixture.canvas};
};

TEST_F(ViewActions, AreAllInWordsAndNoKeyIsTakenTwice) {
  QMap<QString, QString> taken;
  // These keys are used elsewhere: sizes, arrows for the keyboard pen, letters of tools.
  for (const char* key : {"[", "]", "Left", "Right", "Up", "Down", "Space", "Tab", "Esc", "X",  "H",
                          "P", "E", "V",    "A",     "W",  "S",    "C",     "T",   "F1",  "F11"}) {
    taken[QString::fromLatin1(key)] = QStringLiteral("of others");
  }
  for (const QAction* action : actions.all()) {
    const QString name = action->objectName();
    EXPECT_TRUE(name.startsWith(QStringLiteral("view."))) << name.toStdString();
    EXPECT_FALSE(action->text().isEmpty()) << name.toStdString();
    EXPECT_FALSE(action->statusTip().isEmpty()) << name.toStdString();
    QStringList own;
    for (const QKeySequence& key : actions.default_keys(name)) own << key.toString();
    own.removeDuplicates();
    for (const QString& key : own) {
      EXPECT_FALSE(taken.contains(key)) << key.toStdString() << " of " << name.toStdString()
                                        << " is " << taken[key].toStdString();
      taken[key] = name;
    }
  }
}

TEST_F(ViewActions, ZoomTurnMirrorAndBack) {
  run("view.zoom_100");
  EXPECT_NEAR(fixture.canvas.zoom(), 1.0, 1e-9);
  run("view.zoom_in");
  EXPECT_GT(fixture.canvas.zoom(), 1.0);
  run("view.zoom_out");
  EXPECT_NEAR(fixture.canvas.zoom(), 1.0, 1e-9);
  run("view.rotate_right");
  EXPECT_NEAR(view().angle_deg(), 15.0, 1e-9);
  run("view.rotate_left");
  run("view.rotate_left");
  EXPECT_NEAR(view().angle_deg(), -15.0, 1e-9);
  run("view.mirror");
  EXPECT_TRUE(view().is_mirrored());
  run("view.rotate_reset");
  EXPECT_EQ(view().angle_deg(), 0.0);
  run("view.fit_page");
  EXPECT_TRUE(view().visible_mm().contains({297, 210}));
}

TEST_F(ViewActions, ScrollShowsWhatLiesThere) {
  run("view.zoom_100");
  const Rect before = view().visible_mm();
  run("view.scroll_right");
  EXPECT_GT(view().visible_mm().x0, before.x0 + 1.0);
  run("view.scroll_left");
  run("view.scroll_down");
  EXPECT_GT(view().visible_mm().y0, before.y0 + 1.0);
  run("view.scroll_up");
  EXPECT_NEAR(view().visible_mm().x0, before.x0, 1e-9);
  EXPECT_NEAR(view().visible_mm().y0, before.y0, 1e-9);
}

TEST_F(ViewActions, FitShowsTheSelectionAndTheInk) {
  fixture.draw({{10, 10}, {30, 20}}, 0.5);
  fixture.draw({{200, 150}, {210, 160}}, 0.5);
  run("view.fit_ink");
  EXPECT_TRUE(view().visible_mm().contains({10, 10}));
  EXPECT_TRUE(view().visible_mm().contains({210, 160}));
  const double scale = view().px_per_mm();
  run("view.fit_selection");  // the selection is empty
  EXPECT_TRUE(view().visible_mm().contains({297, 210}));
  fixture.tool("lasso");
  fixture.draw({{195, 145}, {215, 145}, {215, 165}, {195, 165}}, 0.5);
  run("view.fit_selection");
  EXPECT_GT(view().px_per_mm(), 2.0 * scale);
  EXPECT_TRUE(view().visible_mm().contains({205, 155}));
}

TEST_F(ViewActions, SwitchesAreSettings) {
  const QString key = QString::fromLatin1(canvas_keys::kForceArrow);
  QAction* arrow = actions.find(QStringLiteral("view.force_arrow"));
  ASSERT_NE(arrow, nullptr);
  arrow->setChecked(false);
  EXPECT_FALSE(Settings::the().flag(key, true));
  Settings::the().set(key, true);
  EXPECT_TRUE(arrow->isChecked());
}

}  // namespace
}  // namespace felt::desktop::view_actions_test
