#include "felt/tools/moved_strokes.h"

#include <gtest/gtest.h>

#include "felt/document/edit_builder.h"
#include "felt/stroke/edit/point_marks.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::moved_strokes_test {
namespace {

using testing::Fixture;
using testing::random_stroke;
using testing::straight_stroke;

const Affine kMap = then(rotation(0.7, {10, 10}), translation({5, -3}));

/// Returns the strokes that an edit makes.
std::vector<Stroke> strokes_of(const Edit& edit) {
  std::vector<Stroke> strokes;
  for (const StrokeChange& c : edit.changes) strokes.push_back(*c.after);
  return strokes;
}

StrokeId add_marked(Fixture& fixture, Stroke stroke, Selection::Marks marks) {
  close_marks(stroke, marks);
  const StrokeId id = fixture.add(std::move(stroke));
  fixture.selection.set(id, std::move(marks));
  return id;
}

/// Returns a line of three segments between corners: 0-10-20-30 along x.
Stroke three_segments(double y = 0.0) {
  StrokeData d;
  for (int i = 0; i <= 9; ++i) d.points.push_back({10.0 * i / 3.0, y});
  d.joints.assign(2, JointKind::kCorner);
  d.widths = {{0.0, 1.0}, {3.0, 1.0}};
  return Stroke::create(std::move(d)).value();
}

TEST(MovedStrokes, R33_IsWithMarkedMovedInPlace) {
  Fixture fixture;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    testing::RandomStroke random(seed + 500);
    // Each stroke is in a square of its own, so that no two of them share a point.
    StrokeData data = random_stroke(seed).data();
    for (Point& p : data.points) p.x += 60.0 * static_cast<double>(seed);
    Stroke stroke = Stroke::create(std::move(data)).value();
    Selection::Marks marks(stroke.data().points.size());
    for (auto& m : marks) m = random.chance(0.5) ? 1 : 0;
    if (seed % 4 == 0) {
      fixture.add(std::move(stroke));  // not selected
    } else {
      add_marked(fixture, std::move(stroke), std::move(marks));
    }
  }
  const Document before = fixture.document;
  const MovedStrokes moved(fixture.document, fixture.index, fixture.selection, false);
  fixture.apply(moved.finished(kMap, 1.0, "Move"));
  for (const StrokeId id : before.layers()[0].strokes) {
    const Selection::Marks* marks = fixture.selection.find(id);
    if (marks) {
      EXPECT_EQ(*fixture.document.find(id), *with_marked_moved(*before.find(id), *marks, kMap));
    } else {
      EXPECT_EQ(fixture.document.find(id), before.find(id)) << "the same object";
    }
  }
  EXPECT_EQ(fixture.document.layers()[0].strokes, before.layers()[0].strokes);
}

TEST(MovedStrokes, R34_CountsTheAnchorsOfAllStrokes) {
  Fixture fixture;
  add_marked(fixture, three_segments(), {0, 0, 0, 1, 1, 1, 1, 0, 0, 0});
  add_marked(fixture, three_segments(5.0), {1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  add_marked(fixture, three_segments(9.0), Selection::Marks(10, 1));
  const MovedStrokes moved(fixture.document, fixture.index, fixture.selection, false);
  EXPECT_EQ(moved.anchors(), (std::vector<Point>{{0, 0}, {30, 0}, {10, 5}}));
  EXPECT_TRUE(
      MovedStrokes(fixture.document, fixture.index, fixture.selection, true).anchors().empty());
}

/// Each drag that duplicates everything would double the drawing.
TEST(MovedStrokes, CopiesStopBeforeTheyFillTheMemory) {
  StrokeData data;
  for (int i = 0; i <= 3000; ++i) data.points.push_back({0.1 * i, 0.0});
  data.joints.assign(999, JointKind::kCorner);
  data.widths = {{0.0, 0.5}, {1000.0, 0.5}};
  const auto stroke = std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
  for (const int count : {3300, 3400}) {
    Document document;
    EditBuilder builder(document);
    Selection selection;
    for (int i = 0; i < count; ++i) selection.set_whole(builder.add({1}, stroke), 3001);
    ASSERT_TRUE(document.apply(std::move(builder).build("Add")));
    const StrokeIndex index{Document()};  // not used for copies
    MovedStrokes copies(document, index, selection, true);
    EXPECT_EQ(copies.empty(), count == 3400) << "up to 20,000,000 control points";
    const std::optional<Error> refusal = copies.take_refusal();
    EXPECT_EQ(refusal.has_value(), count == 3400);
    EXPECT_EQ(refusal.value_or(Error{}).code,
              count == 3400 ? ErrorCode::kLimitExceeded : Error{}.code);
    EXPECT_FALSE(copies.take_refusal()) << "once";
    EXPECT_EQ(copies.copies().has_value(), count == 3300);
  }
}

TEST(MovedStrokes, APreviewIsMadeInPortions) {
  Fixture fixture;
  constexpr std::size_t kStrokes = 1000;
  for (std::size_t i = 0; i < kStrokes; ++i) {
    const double x = 0.5 * static_cast<double>(i);
    add_marked(fixture, straight_stroke({x, 0}, {x, 10}, 1, 1), {1, 1, 1, 1});
  }
  MovedStrokes moved(fixture.document, fixture.index, fixture.selection, false);
  std::size_t steps = 0;
  std::optional<Edit> preview;
  while (!preview) {
    preview = moved.step(translation({1, 0}), 1.0);
    ++steps;
  }
  EXPECT_EQ(steps,
            (4 * kStrokes + MovedStrokes::kPointsPerStep - 1) / MovedStrokes::kPointsPerStep);
  EXPECT_TRUE(strokes_of(*preview) == strokes_of(moved.finished(translation({1, 0}), 1.0, "Move")));
  EXPECT_FALSE(moved.step(translation({1, 0}), 1.0)) << "nothing new";
}

TEST(MovedStrokes, AHugeSelectionHasNoPreviewButComesAtTheLift) {
  Fixture fixture;
  EditBuilder builder(fixture.document);
  const auto stroke = std::make_shared<const Stroke>(straight_stroke({0, 0}, {0, 10}, 1, 1));
  for (std::size_t i = 0; i <= MovedStrokes::kMaxPreviewPoints / 4; ++i) {
    builder.add(fixture.layer, stroke);
  }
  fixture.apply(std::move(builder).build("Import"));
  fixture.selection = select_all(fixture.document);
  MovedStrokes moved(fixture.document, fixture.index, fixture.selection, false);
  EXPECT_FALSE(moved.step(translation({1, 0}), 1.0));
  EXPECT_EQ(moved.finished(translation({1, 0}), 1.0, "Move").changes.size(),
            MovedStrokes::kMaxPreviewPoints / 4 + 1);
}

TEST(MovedStrokes, ShrinksNoSegmentBelowWhatASegmentMayBe) {
  Fixture fixture;
  add_marked(fixture, three_segments(), Selection::Marks(10, 1));
  const MovedStrokes moved(fixture.document, fixture.index, fixture.selection, false);
  EXPECT_NEAR(moved.min_scale(), 0.005, 1e-6);
  EXPECT_FALSE(moved.finished(scaling(moved.min_scale()), 1.0, "Scale").empty());
  EXPECT_TRUE(moved.finished(scaling(0.9 * moved.min_scale()), 1.0, "Scale").empty());
}

TEST(MovedStrokes, ADotStaysADotHoweverSmallTheRestBecomes) {
  Fixture fixture;
  const StrokeId dot =
      add_marked(fixture, straight_stroke({40, 10}, {40.05, 10}, 1, 1), {1, 1, 1, 1});
  add_marked(fixture, three_segments(), Selection::Marks(10, 1));
  const MovedStrokes moved(fixture.document, fixture.index, fixture.selection, false);
  EXPECT_LT(moved.min_scale(), 0.1);
  fixture.apply(moved.finished(scaling(0.1), 1.0, "Scale"));
  const Stroke& after = *fixture.document.find(dot);
  EXPECT_NEAR(after.position(0.5).x, 4.0025, 1e-9);
  EXPECT_NEAR(after.position(0.5).y, 1.0, 1e-9);
  EXPECT_NEAR(control_length(after.segment(0)), kMinSegmentMm, 1e-3);
}

TEST(MovedStrokes, WhereAStrokeCannotBecomeThatTheLastPreviewStays) {
  Fixture fixture;
  // The end of the second segment is pulled onto its start.
  add_marked(fixture, three_segments(), {0, 0, 0, 0, 1, 1, 1, 1, 1, 1});
  MovedStrokes moved(fixture.document, fixture.index, fixture.selection, false);
  const auto good = moved.step(translation({-5, 0}), 1.0);
  ASSERT_TRUE(good);
  const Affine onto = scaling(1e-9, 1.0, {10, 0});
  EXPECT_FALSE(moved.step(onto, 1.0));
  EXPECT_TRUE(strokes_of(moved.finished(onto, 1.0, "Move")) == strokes_of(*good));
}

TEST(MovedStrokes, CopiesWholeStrokesInDrawingOrderOnTop) {
  Fixture fixture;
  const StrokeId low = add_marked(fixture, straight_stroke({0, 0}, {9, 0}, 1, 1), {1, 1, 1, 1});
  fixture.add(straight_stroke({0, 5}, {9, 5}, 1, 1));
  const StrokeId high = add_marked(fixture, straight_stroke({0, 9}, {9, 9}, 1, 1), {1, 1, 1, 1});
  const MovedStrokes moved(fixture.document, fixture.index, fixture.selection, true);
  const auto before = fixture.strokes();
  fixture.apply(moved.finished(translation({0, 20}), 1.0, "Duplicate"));
  const auto after = fixture.strokes();
  ASSERT_EQ(after.size(), 5u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(after[i], before[i]);
  EXPECT_EQ(after[3]->position(0.0), (Point{0, 20}));
  EXPECT_EQ(after[4]->position(0.0), (Point{0, 29}));
  EXPECT_EQ(moved.copies()->strokes().size(), 2u);
  EXPECT_EQ(moved.copies()->find(low), nullptr);
  EXPECT_EQ(moved.copies()->find(high), nullptr);
}

TEST(MovedStrokes, CopiesTheSelectedPartsOfOthers) {
  Fixture fixture;
  add_marked(fixture, three_segments(), {0, 0, 0, 1, 1, 1, 1, 1, 0, 0});
  add_marked(fixture, three_segments(), {1, 0, 0, 0, 0, 0, 0, 0, 0, 0});  // no segment
  StrokeData ring = three_segments().data();
  ring.points = {{0, 0}, {3, -3}, {6, -3}, {9, 0}, {9, 3}, {9, 6}, {9, 9},
                 {6, 9}, {5, 9},  {4, 9},  {0, 8}, {0, 5}, {0, 0}};
  ring.closed = true;
  ring.joints.assign(4, JointKind::kCorner);
  ring.widths.back().u = 4.0;
  const Stroke closed = Stroke::create(std::move(ring)).value();
  add_marked(fixture, closed,
             {1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1});  // the last segment and the first
  const MovedStrokes moved(fixture.document, fixture.index, fixture.selection, true);
  fixture.apply(moved.finished(translation({0, 50}), 1.0, "Duplicate"));
  const auto after = fixture.strokes();
  ASSERT_EQ(after.size(), 5u);
  EXPECT_EQ(after[3]->segment_count(), 1);
  EXPECT_EQ(after[3]->position(0.0), (Point{10, 50}));
  EXPECT_EQ(after[4]->segment_count(), 2);
  EXPECT_FALSE(after[4]->closed());
  EXPECT_EQ(after[4]->position(0.0), (Point{4, 59})) << "from before the seam";
  EXPECT_EQ(after[4]->position(2.0), (Point{9, 50}));
}

}  // namespace
}  // namespace felt::moved_strokes_test
