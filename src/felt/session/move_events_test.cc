// A move by the arrow keys keeps shared points together, as a drag of the transform tool does.
#include <gtest/gtest.h>

#include "felt/document/visible_strokes.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::move_events_test {
namespace {

using testing::straight_stroke;

/// A selected line, an end on its end, an end on its middle, and a line under its start.
struct Connected {
  Connected() {
    std::vector<StrokePtr> strokes;
    for (const auto& [from, to] : {std::pair{Point{0, 0}, Point{10, 0}},
                                   {Point{10, 0}, Point{10, 10}},
                                   {Point{5, 0}, Point{5, 9}},
                                   {Point{0, -5}, Point{0, 5}}}) {
      strokes.push_back(std::make_shared<const Stroke>(straight_stroke(from, to, 1, 1)));
    }
    SessionOptions options;
    options.document = document_of(strokes);
    options.selection.set_whole({1}, 4);
    session = std::make_unique<Session>(make_tools(), std::move(options));
  }

  template <class What>
  void must(What what) {
    const Result<void> done = session->apply({now_ns += 10'000'000, std::move(what)});
    ASSERT_TRUE(done) << done.error().message;
  }
  [[nodiscard]] Point at(std::uint64_t id, double u) const {
    return session->document().find({id})->position(u);
  }

  std::int64_t now_ns = 0;
  std::unique_ptr<Session> session;
};

TEST(MoveEvents, R33_LinesThatShareAPointFollow) {
  Connected f;
  const Document before = f.session->document();
  for (int i = 0; i < 3; ++i) f.must(MoveEvent{{0, 1}});
  EXPECT_EQ(f.at(1, 0), (Point{0, 3}));
  EXPECT_EQ(f.at(1, 1), (Point{10, 3}));
  EXPECT_EQ(f.at(2, 0), (Point{10, 3})) << "an end on its end";
  EXPECT_EQ(f.at(2, 1), (Point{10, 10})) << "the other end stays";
  EXPECT_EQ(f.at(3, 0), (Point{5, 3})) << "an end on its middle";
  ASSERT_EQ(f.session->document().find({4})->segment_count(), 2) << "a joint under its end";
  EXPECT_LE(distance(f.at(4, 1), Point{0, 3}), 1e-9);
  EXPECT_TRUE(f.session->selection().is_whole({1}));
  EXPECT_EQ(f.session->selection().strokes().size(), 1U);
  EXPECT_EQ(f.session->history().undo_count(), 1U) << "three keys in quick succession";
  f.must(UndoEvent{});
  EXPECT_EQ(f.session->document(), before);
}

TEST(MoveEvents, R33_APastedCopyLeavesItsOriginalsBehind) {
  for (const bool by_one_line : {false, true}) {
    Connected f;
    const Document before = f.session->document();
    f.must(SelectStrokes{by_one_line ? SelectStrokes::What::kNone : SelectStrokes::What::kAll});
    const VisibleInk ink = visible_ink(before);
    const std::vector<StrokePtr> some{ink.strokes.front()};
    ASSERT_TRUE(f.session->import(f.now_ns, {"copy", true}, by_one_line ? some : ink.strokes));
    f.must(MoveEvent{{0, 3}});
    for (std::uint64_t id = 1; id <= 4; ++id) {
      EXPECT_EQ(f.session->document().find({id})->data(), before.find({id})->data()) << id;
    }
    EXPECT_EQ(f.at(5, 0), (Point{0, 3}));
  }
}

// A copy that has moved a little along its original touches it, and a line that is only passed does
// so for one key.
TEST(MoveEvents, R33_WhatTheSelectionPassesStays) {
  Connected f;
  const Document before = f.session->document();
  const std::vector<StrokePtr> some{visible_ink(before).strokes.front()};
  f.must(SelectStrokes{SelectStrokes::What::kNone});
  ASSERT_TRUE(f.session->import(f.now_ns, {"copy", true}, some));
  for (int i = 0; i < 4; ++i) f.must(MoveEvent{{1, 0}});
  for (int i = 0; i < 12; ++i) f.must(MoveEvent{{0, 1}});
  for (std::uint64_t id = 1; id <= 4; ++id) {
    EXPECT_EQ(f.session->document().find({id})->data(), before.find({id})->data()) << id;
  }
  EXPECT_EQ(f.at(5, 0), (Point{4, 12}));
  f.must(UndoEvent{});
  EXPECT_EQ(f.session->document().find({5})->data().points, some.front()->data().points);
}

TEST(MoveEvents, R33_AnotherSelectionIsAMoveOfItsOwn) {
  Connected f;
  f.must(MoveEvent{{0, 1}});
  f.must(SelectStrokes{SelectStrokes::What::kInvert});
  const Point at = f.at(1, 0.5);
  f.must(MoveEvent{{20, 0}});
  EXPECT_EQ(f.session->history().undo_count(), 2U);
  EXPECT_NEAR(f.at(1, 0.5).y, at.y, 1e-9);
}

TEST(MoveEvents, R33_LinesStayInRecordingsOfOlderVersions) {
  Connected f;
  f.must(UseDevice{{}, kFirmPushDefaults - 1});
  f.must(MoveEvent{{0, 3}});
  EXPECT_EQ(f.at(1, 0), (Point{0, 3}));
  EXPECT_EQ(f.at(2, 0), (Point{10, 0}));
}

TEST(MoveEvents, R33_ThereAndBackIsWhereItWas) {
  Connected f;
  for (const double by : {1.0, 1.0, -1.0, -1.0}) f.must(MoveEvent{{by, -by}});
  EXPECT_LE(distance(f.at(1, 0), Point{0, 0}), 1e-6);
  EXPECT_LE(distance(f.at(2, 0), Point{10, 0}), 1e-6);
  EXPECT_LE(distance(f.at(3, 0), Point{5, 0}), 1e-6);
  EXPECT_LE(distance(f.at(4, 2), Point{0, 5}), 1e-6);
}

TEST(MoveEvents, R33_ADragOfTheSameLengthGivesTheSame) {
  Connected keys, drag;
  keys.must(MoveEvent{{0, 4}});
  drag.must(SelectTool{"transform"});
  drag.must(PenEvent{{3, 0, 5}, {}, 0});
  for (int i = 0; i <= 40; ++i) drag.must(PenEvent{{3, 0.1 * i, -1}, {}, 0});
  drag.must(PenEvent{{3, 4, 5}, {}, 0});
  drag.must(SelectTool{"pencil"});
  for (const std::uint64_t id : {1U, 2U, 3U, 4U}) {
    const int n = keys.session->document().find({id})->segment_count();
    ASSERT_EQ(drag.session->document().find({id})->segment_count(), n) << id;
    for (int i = 0; i <= 4 * n; ++i) {
      EXPECT_LE(distance(keys.at(id, i / 4.0), drag.at(id, i / 4.0)), 1e-9) << id;
    }
  }
}

TEST(MoveEvents, NothingMovesWithoutASelection) {
  Connected f;
  const Document before = f.session->document();
  f.must(SelectStrokes{SelectStrokes::What::kNone});
  f.must(MoveEvent{{1, 1}});
  EXPECT_EQ(f.session->document(), before);
  EXPECT_EQ(f.session->history().undo_count(), 0U);
}

}  // namespace
}  // namespace felt::move_events_test
