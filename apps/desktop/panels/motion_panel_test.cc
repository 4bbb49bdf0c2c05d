#include "desktop/panels/motion_panel.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include "desktop/panels/onion_skin.h"
#include "desktop/panels/testing/panels_fixture.h"
#include "felt/document/visible_strokes.h"
#include "felt/motion/key_layers.h"
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
  void add_line(double y) {
    studio_.import(QStringLiteral("test"),
                   std::vector{std::make_shared<const Stroke>(
                       felt::testing::straight_stroke({20, y}, {80, y}, 1, 1))});
  }
  [[nodiscard]] const Document& document() const { return studio_.session().document(); }
  /// Returns the document as tools and the canvas see it.
  [[nodiscard]] const Document& seen() const { return studio_.session().seen(); }
  [[nodiscard]] KeyTiming timing(std::size_t key) const {
    return timing_or_default(document().layer(key_layers(document())[key])->timing);
  }
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
  const std::vector<FilmKey> film = film_keys(document(), Page{});
  ASSERT_EQ(film.size(), 2u);
  EXPECT_EQ(heights(film[0].drawing.document), (Heights{40}));
  EXPECT_EQ(heights(film[1].drawing.document), (Heights{60}));
}

TEST_F(MotionPanelTest, TheOnionSkinShowsTheNeighboursAndPutsTheOtherKeysOutOfView) {
  list().setCurrentRow(1);
  EXPECT_EQ(heights(seen()), (Heights{20, 40, 60})) << "without the onion skin all are shown";
  action("view.onion_skin").setChecked(true);
  EXPECT_EQ(heights(seen()), (Heights{40}));
  EXPECT_EQ(heights(document()), (Heights{20, 40, 60}));
  ASSERT_TRUE(onion_);
  EXPECT_EQ(heights(*onion_), (Heights{20, 60}));
  const std::vector<StrokePtr> ghosts = visible_strokes(*onion_);
  EXPECT_EQ(ghosts[0]->color(), kOnionBefore);
  EXPECT_EQ(ghosts[1]->color(), kOnionAfter);
  EXPECT_LT(onion_->layers().front().opacity, 0.5);
  list().setCurrentRow(2);
  EXPECT_EQ(heights(seen()), (Heights{60}));
  EXPECT_EQ(heights(*onion_), (Heights{40}));
  // The next key drawing is above; what is drawn there does not change the onion skin.
  action("layer.add_key").trigger();
  EXPECT_EQ(heights(seen()), (Heights{}));
  EXPECT_EQ(heights(*onion_), (Heights{60}));
  add_line(80);
  EXPECT_EQ(list().count(), 4);
  action("view.onion_skin").setChecked(false);
  EXPECT_FALSE(onion_);
  EXPECT_EQ(heights(seen()), (Heights{20, 40, 60, 80}));
  while (studio_.session().history().can_undo()) studio_.apply(UndoEvent{});
  EXPECT_EQ(document().stroke_count(), 0u) << "every step can be undone";
}

// A file that is saved meanwhile contains this document.
TEST_F(MotionPanelTest, TheDocumentIsTheSameWithAndWithoutTheOnionSkin) {
  const Document before = document();
  const std::size_t steps = studio_.session().history().undo_count();
  studio_.set_modified(false);
  for (const int row : {1, 0, 2}) {
    action("view.onion_skin").setChecked(row != 0);
    list().setCurrentRow(row);
    EXPECT_TRUE(document() == before) << row;
  }
  EXPECT_EQ(heights(seen()), (Heights{60}));
  EXPECT_EQ(studio_.session().history().undo_count(), steps);
  EXPECT_FALSE(studio_.is_modified());
}

TEST_F(MotionPanelTest, TheOnionSkinFollowsTheOtherLayers) {
  action("view.onion_skin").setChecked(true);
  EXPECT_EQ(heights(*onion_), (Heights{40}));
  studio_.apply(LayerEvent{Do::kRemove, key_layers(document())[1]});
  ASSERT_TRUE(QTest::qWaitFor([this] { return heights(*onion_) == Heights{20}; }, 20000));
  studio_.apply(UndoEvent{});
  ASSERT_TRUE(QTest::qWaitFor([this] { return heights(*onion_) == Heights{40}; }, 20000));
  EXPECT_EQ(heights(seen()), (Heights{60}));
  studio_.open(Document(), Page{});
  EXPECT_FALSE(action("view.onion_skin").isChecked());
  EXPECT_FALSE(onion_);
}

TEST_F(MotionPanelTest, AnOnionSkinThatIsSwitchedWithThePenDownChangesWhenItIsLifted) {
  const auto move_pen = [this](double z_mm) { studio_.apply(PenEvent{{20, 90, z_mm}, {}, 0}); };
  for (const bool on : {true, false}) {
    move_pen(5.0);
    move_pen(-0.5);
    ASSERT_TRUE(studio_.session().gesture_in_progress());
    action("view.onion_skin").setChecked(on);
    QTest::qWait(200);
    EXPECT_EQ(studio_.session().out_of_view().empty(), on) << "not yet";
    move_pen(5.0);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return studio_.session().out_of_view().size() == (on ? 2U : 0U); }, 20000));
    EXPECT_EQ(onion_.has_value(), on);
  }
}

TEST_F(MotionPanelTest, ANewKeyDrawingIsOneStepOfUndo) {
  panel_.findChildren<QSpinBox*>()[0]->setValue(5);
  const std::size_t steps = studio_.session().history().undo_count();
  action("layer.add_key").trigger();
  EXPECT_EQ(studio_.session().history().undo_count(), steps + 1);
  const Layer* added = document().layer(studio_.session().layer());
  EXPECT_EQ(timing_or_default(added->timing).between, 5);
}

TEST_F(MotionPanelTest, ANewKeyDrawingIsInTheListAtOnce) {
  list().setCurrentRow(0);
  action("layer.add_key").trigger();  // above the lowest
  ASSERT_EQ(list().count(), 4);
  EXPECT_EQ(list().currentRow(), 1);
  EXPECT_TRUE(list().item(1)->text().contains(QStringLiteral("empty")));
  EXPECT_EQ(key_layers(document()).size(), 3u) << "it is a key drawing once it has ink";
  add_line(80);
  EXPECT_EQ(list().count(), 4);
  EXPECT_EQ(list().currentRow(), 1);
  EXPECT_FALSE(list().item(1)->text().contains(QStringLiteral("empty")));
  action("layer.add_key").trigger();
  list().setCurrentRow(0);
  EXPECT_EQ(list().count(), 4) << "an empty layer is a key drawing only while it is in use";
}

// The short label of the button stays when its command changes; a longer one would widen the panel.
TEST_F(MotionPanelTest, TheButtonsKeepTheirTexts) {
  const auto texts = [this] {
    QStringList all;
    for (const QToolButton* button : panel_.findChildren<QToolButton*>()) all << button->text();
    return all;
  };
  const QStringList before = texts();
  EXPECT_TRUE(before.contains(QStringLiteral("Matches")));
  const int width = panel_.minimumSizeHint().width();
  for (const char* name : {"view.correct_matches", "view.onion_skin"}) {
    action(name).setChecked(true);
    action(name).setEnabled(false);
    action(name).setEnabled(true);
    EXPECT_EQ(texts(), before) << name;
    EXPECT_EQ(panel_.minimumSizeHint().width(), width) << name;
  }
}

TEST_F(MotionPanelTest, TheTimingIsThatOfTheCurrentKeyDrawing) {
  const auto boxes = panel_.findChildren<QSpinBox*>();
  auto* ease = panel_.findChild<QComboBox*>();
  list().setCurrentRow(0);
  boxes[0]->setValue(5);
  boxes[1]->setValue(3);
  ease->setCurrentIndex(1);
  Q_EMIT ease->activated(1);
  EXPECT_EQ(timing(0), (KeyTiming{5, 3, {0.42, 0.0, 1.0, 1.0}}));
  EXPECT_EQ(timing(1), KeyTiming());
  list().setCurrentRow(1);
  EXPECT_EQ(boxes[0]->value(), 12);
  EXPECT_EQ(ease->currentIndex(), 0);
  list().setCurrentRow(0);
  EXPECT_EQ(boxes[1]->value(), 3);
  EXPECT_EQ(ease->currentIndex(), 1);
  EXPECT_NE(panel_.findChild<QLabel*>(QStringLiteral("length"))->text().indexOf("22"), -1)
      << "3 + 5 + 1 + 12 + 1";
  action("layer.same_timing").trigger();
  EXPECT_EQ(timing(2), timing(0));
  studio_.apply(UndoEvent{});
  EXPECT_EQ(timing(2), KeyTiming());
  studio_.apply(
      TimingEvent{.layers = {studio_.session().layer()}, .ease = EaseCurve{0.1, 0, 1, 1}});
  EXPECT_EQ(ease->currentIndex(), 4) << "a curve that the list does not have";
  list().setCurrentRow(1);
  EXPECT_EQ(ease->count(), 4);
  action("layer.add_key").trigger();
  EXPECT_EQ(boxes[0]->value(), 12);
  list().setCurrentRow(0);
  action("layer.add_key").trigger();
  EXPECT_EQ(boxes[0]->value(), 5) << "a new key drawing has the timing of the one before it";
}

}  // namespace
}  // namespace felt::desktop::motion_panel_test
