// Tests of fills that follow the edits of a session, with the real tools.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "felt/document/visible_strokes.h"
#include "felt/fill/fill_shape.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::session_fills_test {
namespace {

/// A square of four lines with sides of 40 mm, filled with the tool Fill.
struct FilledSquare {
  explicit FilledSquare(const char* opened = "close") {
    const auto line = [](Point a, Point b) {
      return std::make_shared<const Stroke>(testing::straight_stroke(a, b, 1, 1));
    };
    const std::vector<StrokePtr> lines{line({-1, 0}, {41, 0}), line({40, -1}, {40, 41}),
                                       line({41, 40}, {-1, 40}), line({0, 41}, {0, -1})};
    SessionOptions options;
    options.document = document_of(lines);
    session = std::make_unique<Session>(make_tools(), std::move(options));
    must(SetOption{"fill.opened", std::string(opened)});
    must(SetOption{"ink.color", std::string("#b02020")});
    drag("fill", {20, 20}, {20.1, 20});
  }
  template <class Command>
  void must(Command what) {
    const Result<void> done = session->apply({now_ns += 1'000'000, std::move(what)});
    ASSERT_TRUE(done) << done.error().message;
  }
  void pen(Point p, double z) { must(PenEvent{{p.x, p.y, z}, {}, 0}); }
  void drag(const char* tool, Point from, Point to) {
    must(SelectTool{tool});
    now_ns += 1'000'000'000;
    pen(from, 5);
    for (int i = 0; i <= 100; ++i) pen(lerp(from, to, i / 100.0), -1);
    for (int i = 0; i < 100; ++i) pen(to, 5);
  }
  [[nodiscard]] FillPtr fill() const {
    const auto& fills = session->document().layers().front().fills;
    return fills.empty() ? nullptr : session->document().find_fill(fills.front());
  }
  [[nodiscard]] double area() const { return std::fabs(area_of(fill()->loops.front())); }

  std::int64_t now_ns = 0;
  std::unique_ptr<Session> session;
};

TEST(SessionFills, AFillFollowsAPullAndUndoIsExact) {
  FilledSquare f;
  ASSERT_TRUE(f.fill());
  EXPECT_NEAR(f.area(), 1600.0, 1.0);
  const Document before = f.session->document();
  const std::size_t steps = f.session->history().undo_count();
  f.drag("pull", {40, 20}, {50, 20});
  EXPECT_EQ(f.session->history().undo_count(), steps + 1);
  ASSERT_TRUE(f.fill());
  EXPECT_GT(f.area(), 1640.0);
  EXPECT_TRUE(is_in_fill(*f.fill(), {43, 20}));
  const Document after = f.session->document();
  f.must(UndoEvent{});
  EXPECT_EQ(f.session->document(), before);
  f.must(RedoEvent{});
  EXPECT_EQ(f.session->document(), after);
}

TEST(SessionFills, ThePreviewFollows) {
  FilledSquare f;
  f.must(SelectTool{"pull"});
  f.pen({40, 20}, 5);
  for (int i = 0; i <= 100; ++i) f.pen({40 + i / 10.0, 20}, -1);
  ASSERT_TRUE(f.session->preview_with_fills());
  EXPECT_EQ(f.session->preview_with_fills()->fills.size(), 1U);
  Document shown = f.session->document();
  EXPECT_TRUE(shown.apply(*f.session->preview_with_fills()));
  EXPECT_EQ(f.session->preview()->fills.size(), 0U);
}

TEST(SessionFills, TransformsAndCommandsTakeTheFillAlong) {
  FilledSquare f;
  f.must(SelectStrokes{SelectStrokes::What::kAll});
  const std::size_t steps = f.session->history().undo_count();
  f.must(MoveEvent{{5, 0}});
  f.must(MoveEvent{{5, 0}});
  EXPECT_EQ(f.session->history().undo_count(), steps + 1) << "steps that follow each other are one";
  ASSERT_TRUE(f.fill());
  EXPECT_NEAR(fill_bounds(*f.fill()).x0, 10.0, 1e-6);
  EXPECT_NEAR(f.area(), 1600.0, 1.0);
  f.must(UndoEvent{});
  EXPECT_NEAR(fill_bounds(*f.fill()).x0, 0.0, 1e-6);
  f.must(DeleteEvent{});
  EXPECT_FALSE(f.fill()) << "nothing is left of its outline";
  f.must(UndoEvent{});
  EXPECT_TRUE(f.fill());
}

TEST(SessionFills, TheEraserOpensOrClosesAsTheOptionSays) {
  for (const char* opened : {"close", "remove"}) {
    FilledSquare f(opened);
    const Document before = f.session->document();
    f.drag("eraser", {40, 14}, {40, 26});
    ASSERT_GT(f.session->document().stroke_count(), 4U) << "the line is in two parts";
    EXPECT_EQ(f.fill() != nullptr, std::string_view(opened) == "close") << opened;
    if (f.fill()) {
      EXPECT_NEAR(f.area(), 1600.0, 1.0);
    }
    f.must(UndoEvent{});
    EXPECT_EQ(f.session->document(), before);
  }
}

TEST(SessionFills, CopiesAndImportsTakeTheirFillsAlong) {
  FilledSquare f;
  f.must(SelectStrokes{SelectStrokes::What::kAll});
  f.must(DuplicateEvent{});
  ASSERT_EQ(f.session->document().fill_count(), 2U);
  f.must(MoveEvent{{100, 0}});
  const LayerId low = f.session->document().layers().front().id;
  const FillId copy = f.session->document().layer(low)->fills.back();
  EXPECT_GT(fill_bounds(*f.session->document().find_fill(copy)).x0, 100.0)
      << "it follows the copies";
  EXPECT_NEAR(fill_bounds(*f.fill()).x0, 0.0, 1e-6);

  const VisibleInk ink = visible_ink(f.session->document());
  FilledSquare other;
  ASSERT_TRUE(other.session->import(other.now_ns, {"a.felt", true}, ink.strokes, ink.fills));
  EXPECT_EQ(other.session->document().fill_count(), 3U);
  EXPECT_EQ(other.session->selection().strokes().size(), 8U);
  ASSERT_EQ(ink.fills.size(), 2U);
  for (const FillPtr& fill : ink.fills) EXPECT_EQ(fill->loops[0].pieces.size(), 4U);
  EXPECT_EQ(ink.fills[0]->loops[0].pieces[0].stroke, StrokeId{1});
  // The first imported fill lies exactly on the square that was there, and leaves it behind.
  const std::vector<FillId>& fills = other.session->document().layers().front().fills;
  const std::vector<FillId> ids(fills.begin(), fills.end());
  std::vector<Rect> before;
  for (const FillId id : ids)
    before.push_back(fill_bounds(*other.session->document().find_fill(id)));
  other.must(MoveEvent{{0, 100}});
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const FillPtr now = other.session->document().find_fill(ids[i]);
    ASSERT_TRUE(now);
    const double moved = now == other.fill() ? 0.0 : 100.0;
    EXPECT_NEAR(fill_bounds(*now).y0 - before[i].y0, moved, 1e-9) << i;
    EXPECT_NEAR(fill_bounds(*now).y1 - before[i].y1, moved, 1e-9) << i;
  }
}

TEST(SessionFills, AFillInALockedLayerStays) {
  FilledSquare f;
  const FillPtr before = f.fill();
  const LayerId low = f.session->document().layers().front().id;
  f.must(LayerEvent{LayerEvent::Do::kAdd, {}, "Top"});
  f.must(LayerEvent{LayerEvent::Do::kLock, low, {}});
  f.drag("pull", {40, 20}, {50, 20});
  EXPECT_EQ(f.fill(), before);
}

TEST(SessionFills, TheSameEventsGiveTheSameFills) {
  FilledSquare a, b;
  for (FilledSquare* f : {&a, &b}) {
    f->drag("pull", {40, 20}, {48, 22});
    f->drag("pull", {20, 0}, {20, -6});
  }
  EXPECT_EQ(a.session->document(), b.session->document());
}

}  // namespace
}  // namespace felt::session_fills_test
