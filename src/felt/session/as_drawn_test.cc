// The event "as-drawn": the line of the steady hand becomes the line of the pen.
#include <gtest/gtest.h>

#include <cmath>

#include "felt/base/constants.h"
#include "felt/session/session.h"

namespace felt::as_drawn_test {
namespace {

struct AsDrawnFixture {
  Session session{make_tools(), {}};
  std::int64_t now_ns = 0;

  explicit AsDrawnFixture(bool steady = true) {
    must(SetOption{"pencil.steady", steady});
    must(SetOption{"pencil.steady_axis_deg", 90.0});
  }
  template <class What>
  void must(What what) {
    const Result<void> done = session.apply({now_ns += 5'000'000, std::move(what)});
    ASSERT_TRUE(done) << done.error().message;
  }
  /// Draws a line of 2 s at this height, by a hand that shakes.
  void line(double y) {
    must(PenEvent{{20, y, 5}, {}, 0});
    for (int i = 0; i < 400; ++i) {
      must(PenEvent{{20 + 0.2 * i, y + std::sin(kTau * 5.0 * 0.005 * i), 0}, 0.5, 0});
    }
    must(PenEvent{{100, y, 5}, {}, 0});
    must(PenEvent{{100, y, 20}, {}, 0});
  }
  [[nodiscard]] std::vector<StrokePtr> strokes() const {
    std::vector<StrokePtr> all;
    for (const Layer& l : session.document().layers()) {
      for (const StrokeId id : l.strokes) all.push_back(session.document().find(id));
    }
    return all;
  }
  [[nodiscard]] std::size_t steps() const { return session.history().undo_count(); }
};

TEST(AsDrawn, IsOneUndoStepThatRestoresTheLineOfThePen) {
  AsDrawnFixture raw(false), f;
  raw.line(50);
  f.line(50);
  ASSERT_EQ(f.steps(), 1u);
  const Stroke calm = *f.strokes()[0];
  EXPECT_NE(calm, *raw.strokes()[0]);
  f.must(AsDrawnEvent{});
  EXPECT_EQ(f.steps(), 2u);
  ASSERT_EQ(f.strokes().size(), 1u);
  EXPECT_EQ(*f.strokes()[0], *raw.strokes()[0]);
  EXPECT_EQ(f.session.history().undo_label(), "As drawn");
  f.must(AsDrawnEvent{});
  EXPECT_EQ(f.steps(), 2u) << "there is nothing more to restore";
  f.must(UndoEvent{});
  EXPECT_EQ(*f.strokes()[0], calm);
  f.must(UndoEvent{});
  EXPECT_TRUE(f.strokes().empty());
}

TEST(AsDrawn, WorksWhileTheLiftIsNotCertainAndOnlyForTheLastChange) {
  AsDrawnFixture f;
  f.must(AsDrawnEvent{});
  EXPECT_EQ(f.steps(), 0u);
  f.line(50);
  f.line(80);
  const Stroke first = *f.strokes()[0];
  f.must(AsDrawnEvent{});
  EXPECT_EQ(*f.strokes()[0], first);
  EXPECT_EQ(f.steps(), 3u);
  f.must(UndoEvent{});
  f.must(UndoEvent{});
  f.must(AsDrawnEvent{});
  EXPECT_EQ(*f.strokes()[0], first) << "the last change is another line now";
}

TEST(AsDrawn, DoesNothingWithoutTheSteadyHandOrDuringAGesture) {
  AsDrawnFixture f(false);
  f.line(50);
  f.must(AsDrawnEvent{});
  EXPECT_EQ(f.steps(), 1u);
  AsDrawnFixture g;
  g.line(50);
  g.must(PenEvent{{10, 10, 0}, 0.5, 0});
  g.must(PenEvent{{12, 10, 0}, 0.5, 0});
  g.must(AsDrawnEvent{});
  EXPECT_EQ(g.steps(), 1u);
  EXPECT_TRUE(g.session.gesture_in_progress());
}

}  // namespace
}  // namespace felt::as_drawn_test
