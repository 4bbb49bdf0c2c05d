#include "desktop/help/tour_window.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QTest>

#include "desktop/engine/first_options.h"
#include "desktop/help/examples.h"

namespace felt::desktop::tour_window_test {
namespace {

constexpr std::int64_t kFrameNs = 16'000'000;

void play_to(TourWindow& tour, int act) {
  for (int i = 0; tour.act() < act && i < 100'000; ++i) tour.play(kFrameNs);
  ASSERT_EQ(tour.act(), act);
}

TEST(TourWindow, DrawsByItselfAndGoesBack) {
  TourWindow tour;
  EXPECT_EQ(tour.act_count(), 18);
  EXPECT_EQ(tour.studio().session().document().stroke_count(), 0U);
  tour.go_to(1);
  play_to(tour, 1);
  const std::size_t drawn = tour.studio().session().document().stroke_count();
  EXPECT_GT(drawn, 50U);  // strokes of the cat and the ball
  EXPECT_EQ(tour.studio().session().tool().info().id, "pencil");
  tour.play(kFrameNs);
  EXPECT_EQ(tour.studio().session().tool().info().id, "pull");
  tour.go_to(0);
  EXPECT_EQ(tour.act(), 0);
  EXPECT_EQ(tour.studio().session().document().stroke_count(), 0U);
}

TEST(TourWindow, EveryActChangesTheDrawingOrWhatIsSelectedOrReads) {
  TourWindow tour;
  for (int act = 0; act < tour.act_count(); ++act) {
    const std::uint64_t edits = tour.studio().session().edit_count();
    const std::uint64_t selections = tour.studio().session().selection_count();
    tour.go_to(act + 1);
    play_to(tour, act + 1);
    const Session& session = tour.studio().session();
    const Reading* reading = session.tool().reading();
    EXPECT_TRUE(session.edit_count() > edits || session.selection_count() > selections ||
                (reading && reading->clicks > 0))
        << "act " << act + 1;
  }
}

TEST(TourWindow, KeysPauseAndLeaf) {
  TourWindow tour;
  tour.show();
  tour.setFocus();
  QTest::keyClick(&tour, Qt::Key_Space);
  EXPECT_TRUE(tour.is_paused());
  QTest::keyClick(&tour, Qt::Key_Space);
  EXPECT_FALSE(tour.is_paused());
  QTest::keyClick(&tour, Qt::Key_Left);
  EXPECT_EQ(tour.act(), 0);
}

TEST(Examples, AreDrawings) {
  for (const Example& example : examples()) {
    EXPECT_FALSE(example.title.isEmpty());
    SCOPED_TRACE(example.id.toStdString());
    const Document drawing = example_document(example.id);
    EXPECT_GT(drawing.stroke_count(), 10U);
    for (const StrokeId id : drawing.layers()[0].strokes) {
      EXPECT_EQ(drawing.find(id)->medium(), kFirstMedium) << "as the first line drawn on it";
    }
  }
  EXPECT_EQ(example_document(QStringLiteral("no such")).stroke_count(), 0U);
}

TEST(TourWindow, TryItYourselfKeepsWhatTheTourHasDrawn) {
  TourWindow tour;
  tour.setAttribute(Qt::WA_DeleteOnClose, false);
  std::size_t strokes = 0;
  QObject::connect(&tour, &TourWindow::drawing_requested, &tour,
                   [&strokes](const Document& drawing) { strokes = drawing.stroke_count(); });
  tour.go_to(tour.act_count());
  play_to(tour, tour.act_count());
  for (auto* button : tour.findChildren<QPushButton*>()) {
    if (button->text().contains(QStringLiteral("Try"))) button->click();
  }
  EXPECT_GT(strokes, 20U);
}

}  // namespace
}  // namespace felt::desktop::tour_window_test
