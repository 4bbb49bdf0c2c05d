#include "desktop/canvas/match_view.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "desktop/canvas/testing/canvas_fixture.h"
#include "felt/motion/key_layers.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::match_view_test {
namespace {

/// Two key drawings of two lines each, with ids 1, 2 and 3, 4, on a canvas.
struct MatchFixture : Fixture {
  MatchFixture() {
    add({30, 60}, 90);
    add({30, 120}, 40);
    studio.apply(LayerEvent{LayerEvent::Do::kAdd, {}});
    add({150, 62}, 90);
    add({150, 122}, 40);
    studio.apply(LayerEvent{LayerEvent::Do::kUse, {1}});
    studio.apply(SelectStrokes{SelectStrokes::What::kNone});
  }
  void add(Point start, double length) {
    studio.import(QStringLiteral("test"),
                  std::vector{std::make_shared<const Stroke>(
                      felt::testing::straight_stroke(start, {start.x + length, start.y}, 1, 1))});
  }
  [[nodiscard]] QPoint px(Point mm) const { return canvas.view().to_px(mm).toPoint(); }
  void drag(Point from, Point to) {
    QTest::mousePress(&matches, Qt::LeftButton, {}, px(from));
    QTest::mouseMove(&matches, px(to));
    QTest::mouseRelease(&matches, Qt::LeftButton, {}, px(to));
  }
  void click(Point mm) { QTest::mouseClick(&matches, Qt::LeftButton, {}, px(mm)); }
  [[nodiscard]] std::vector<KeyPair> pairs() const {
    return timing_or_default(studio.session().document().layer({1})->timing).pairs;
  }
  /// Returns the number of matches that are shown: with a line, without, and corrected.
  [[nodiscard]] std::vector<std::size_t> counts() {
    std::size_t lines = 0, lone = 0, given = 0;
    for (const MatchView::Shown& match : matches.shown()) {
      ++(match.from && match.to ? lines : lone);
      given += match.is_given ? 1 : 0;
    }
    return {lines, lone, given};
  }

  MatchView matches{canvas};
};

using Counts = std::vector<std::size_t>;
using Pairs = std::vector<KeyPair>;

TEST(MatchView, SearchesOnceForManyEdits) {
  MatchFixture f;
  ASSERT_TRUE(f.matches.start());
  EXPECT_EQ(f.counts(), (Counts{2, 0, 0}));
  const int before = f.matches.searches();
  for (int i = 0; i < 10; ++i) f.add({30.0, 10.0 + i}, 50);
  EXPECT_FALSE(f.matches.shown().empty());
  EXPECT_LE(f.matches.searches(), before + 1);
}

TEST(MatchView, ADragFromLineToLineMakesAPairThatCanBeUndone) {
  MatchFixture f;
  ASSERT_TRUE(f.matches.start());
  EXPECT_TRUE(f.matches.isVisible());
  EXPECT_EQ(f.counts(), (Counts{2, 0, 0}));
  f.drag({60, 60}, {170, 122});
  EXPECT_EQ(f.pairs(), (Pairs{{{1}, {4}}}));
  EXPECT_EQ(f.counts(), (Counts{1, 2, 1})) << "the other lines are too different";
  f.drag({170, 62}, {60, 60});
  EXPECT_EQ(f.pairs(), (Pairs{{{1}, {3}}})) << "backwards, and instead of the first pair";
  f.drag({60, 60}, {100, 190});
  EXPECT_EQ(f.pairs(), (Pairs{{{1}, {3}}})) << "the drag did not end at a line";
  f.studio.apply(UndoEvent{});
  EXPECT_EQ(f.pairs(), (Pairs{{{1}, {4}}}));
  f.studio.apply(UndoEvent{});
  EXPECT_EQ(f.pairs(), Pairs());
  EXPECT_EQ(f.counts(), (Counts{2, 0, 0}));
}

TEST(MatchView, AClickSaysThatALineHasNoPartnerAndTakesACorrectionBack) {
  MatchFixture f;
  ASSERT_TRUE(f.matches.start());
  f.click({50, 120});
  EXPECT_EQ(f.pairs(), (Pairs{{{2}, {}}}));
  EXPECT_EQ(f.counts(), (Counts{1, 2, 1}));
  f.click({170, 62});
  EXPECT_EQ(f.pairs(), (Pairs{{{2}, {}}, {{}, {3}}}));
  f.click({50, 120});
  EXPECT_EQ(f.pairs(), (Pairs{{{}, {3}}}));
  f.click({100, 190});
  EXPECT_EQ(f.pairs(), (Pairs{{{}, {3}}}));
}

TEST(MatchView, EndsWithEscapeAndWithoutANextKeyDrawing) {
  MatchFixture f;
  QSignalSpy stopped(&f.matches, &MatchView::stopped);
  ASSERT_TRUE(f.matches.start());
  QTest::keyClick(&f.matches, Qt::Key_Escape);
  EXPECT_FALSE(f.matches.isVisible());
  EXPECT_EQ(stopped.count(), 1);
  ASSERT_TRUE(f.matches.start());
  f.studio.apply(LayerEvent{LayerEvent::Do::kUse, {2}});
  EXPECT_FALSE(f.matches.isVisible()) << "the last key drawing";
  EXPECT_EQ(stopped.count(), 2);
  EXPECT_FALSE(f.matches.start());
}

TEST(Canvas, DoesNotShowLayersThatAreOutOfView) {
  MatchFixture f;
  f.settle();
  const QImage all = f.canvas.grab().toImage();
  f.studio.apply(UseView{{{2}}});
  f.settle();
  const QImage one = f.canvas.grab().toImage();
  EXPECT_NE(one, all);
  f.studio.apply(LayerEvent{LayerEvent::Do::kHide, {2}});
  f.settle();
  EXPECT_EQ(f.canvas.grab().toImage(), one);
  f.studio.apply(UseView{});
  f.settle();
  EXPECT_EQ(f.canvas.grab().toImage(), one) << "hidden in the drawing";
  f.studio.apply(UndoEvent{});
  f.settle();
  EXPECT_EQ(f.canvas.grab().toImage(), all);
}

}  // namespace
}  // namespace felt::desktop::match_view_test
