#include "desktop/panels/motion_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QListWidget>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "desktop/engine/settings.h"
#include "desktop/panels/key_layers.h"
#include "desktop/panels/panel_setting_keys.h"
#include "desktop/panels/testing/panels_fixture.h"
#include "felt/document/visible_strokes.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::motion_panel_test {
namespace {

using Do = LayerEvent::Do;

/// A drawing with three layers, each with a line at its own height.
class MotionPanelTest : public ::testing::Test {
 protected:
  MotionPanelTest() {
    QObject::connect(&panel_, &MotionPanel::onion_changed, &panel_,
                     [this](const std::optional<Document>& onion) { onion_ = onion; });
    add_line(20);
    for (const double y : {40.0, 60.0}) {
      studio_.apply(LayerEvent{Do::kAdd, {}});
      add_line(y);
    }
  }
  ~MotionPanelTest() override {
    for (const char* key :
         {panel_keys::kMotionBetween, panel_keys::kMotionHold, panel_keys::kMotionEase}) {
      Settings::the().reset(QString::fromLatin1(key));
    }
  }
  void add_line(double y) {
    studio_.import(QStringLiteral("test"),
                   std::vector{std::make_shared<const Stroke>(
                       felt::testing::straight_stroke({20, y}, {80, y}, 1, 1))});
  }
  [[nodiscard]] const Document& document() const { return studio_.session().document(); }
  /// Returns the heights of the visible lines, from the bottom up.
  [[nodiscard]] static std::vector<double> heights(const Document& shown) {
    std::vector<double> all;
    for (const StrokePtr& s : visible_strokes(shown)) all.push_back(s->data().points.front().y);
    return all;
  }
  [[nodiscard]] QListWidget& list() { return *panel_.findChild<QListWidget*>(); }
  [[nodiscard]] QAction& action(const char* name) {
    return *actions_.find(QString::fromLatin1(name));
  }

  Studio studio_{testing::still()};
  QWidget window_;
  Actions actions_{&window_};
  MotionPanel panel_{studio_, actions_, &window_};
  std::optional<Document> onion_;
};

using Heights = std::vector<double>;

TEST_F(MotionPanelTest, TheKeysAreTheUnlockedLayersWithLines) {
  EXPECT_EQ(list().count(), 3);
  EXPECT_EQ(list().currentRow(), 2);
  const std::vector<LayerId> keys = key_layers(document());
  studio_.apply(LayerEvent{Do::kHide, keys[1]});
  studio_.apply(LayerEvent{Do::kLock, keys[0]});
  EXPECT_EQ(list().count(), 2) << "a hidden layer is a key drawing, a locked one is not";
  const std::vector<Drawing> drawings = key_drawings(document(), Page{});
  ASSERT_EQ(drawings.size(), 2u);
  EXPECT_EQ(heights(drawings[0].document), (Heights{40}));
  EXPECT_EQ(heights(drawings[1].document), (Heights{60}));
}

TEST_F(MotionPanelTest, TheOnionSkinShowsTheNeighboursAndHidesTheOtherKeys) {
  list().setCurrentRow(1);
  EXPECT_EQ(heights(document()), (Heights{20, 40, 60})) << "without the onion skin all are shown";
  action("view.onion_skin").setChecked(true);
  EXPECT_EQ(heights(document()), (Heights{40}));
  ASSERT_TRUE(onion_);
  EXPECT_EQ(heights(*onion_), (Heights{20, 60}));
  const std::vector<StrokePtr> ghosts = visible_strokes(*onion_);
  EXPECT_EQ(ghosts[0]->color(), kOnionBefore);
  EXPECT_EQ(ghosts[1]->color(), kOnionAfter);
  EXPECT_LT(onion_->layers().front().opacity, 0.5);
  list().setCurrentRow(2);
  EXPECT_EQ(heights(document()), (Heights{60}));
  EXPECT_EQ(heights(*onion_), (Heights{40}));
  // The next key drawing is above; what is drawn there does not change the onion skin.
  action("layer.add_key").trigger();
  EXPECT_EQ(heights(document()), (Heights{}));
  EXPECT_EQ(heights(*onion_), (Heights{60}));
  add_line(80);
  EXPECT_EQ(list().count(), 4);
  action("view.onion_skin").setChecked(false);
  EXPECT_FALSE(onion_);
  EXPECT_EQ(heights(document()), (Heights{20, 40, 60, 80}));
  while (studio_.session().history().can_undo()) studio_.apply(UndoEvent{});
  EXPECT_EQ(document().stroke_count(), 0u) << "every step can be undone";
}

TEST_F(MotionPanelTest, TheOnionSkinFollowsTheOtherLayers) {
  action("view.onion_skin").setChecked(true);
  EXPECT_EQ(heights(*onion_), (Heights{40}));
  studio_.apply(LayerEvent{Do::kRemove, key_layers(document())[1]});
  ASSERT_TRUE(QTest::qWaitFor([this] { return heights(*onion_) == Heights{20}; }, 20000));
  studio_.open(Document(), Page{});
  EXPECT_FALSE(action("view.onion_skin").isChecked());
  EXPECT_FALSE(onion_);
}

TEST_F(MotionPanelTest, TheSettingsAreKept) {
  const auto boxes = panel_.findChildren<QSpinBox*>();
  boxes[0]->setValue(5);
  boxes[1]->setValue(3);
  panel_.findChild<QComboBox*>()->setCurrentIndex(1);
  EXPECT_EQ(panel_.options().between, 5);
  EXPECT_EQ(panel_.options().hold, 3);
  EXPECT_LT(panel_.options().ease.at(0.5), 0.4);
  const MotionPanel next(studio_, *new Actions(&window_), &window_);
  EXPECT_EQ(next.options().between, 5);
  EXPECT_EQ(next.options().hold, 3);
  EXPECT_LT(next.options().ease.at(0.5), 0.4);
}

}  // namespace
}  // namespace felt::desktop::motion_panel_test
