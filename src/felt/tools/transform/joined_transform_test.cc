#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "felt/stroke/edit/point_marks.h"
#include "felt/tools/junctions.h"
#include "felt/tools/testing/joined_drawing.h"
#include "felt/tools/transform/transform_tool.h"

namespace felt::joined_transform_test {
namespace {

using testing::JoinedDrawing;
using testing::Pen;
using testing::way;

/// Strokes may be this much farther from each other after a transform than before it.
constexpr double kApartMm = 0.03;
constexpr const char* kModes[] = {"move", "rotate", "scale"};

struct Transformed : JoinedDrawing {
  using JoinedDrawing::JoinedDrawing;

  TransformTool tool;

  void select(StrokeId id, Selection::Marks marks) {
    close_marks(*fixture.document.find(id), marks);
    fixture.selection.set(id, std::move(marks));
  }
  /// Selects some strokes: whole, or from a joint to an end.
  void select_some() {
    for (const StrokeId id : ids) {
      if (random.chance(0.6)) continue;
      const StrokePtr stroke = fixture.document.find(id);
      Selection::Marks marks(stroke->data().points.size(), 1);
      if (random.chance(0.5)) {
        const auto joint = static_cast<std::size_t>(random.pick(0, stroke->segment_count()));
        const bool first = random.chance(0.5);
        for (std::size_t k = 0; k < marks.size(); ++k) {
          marks[k] = (first ? k <= 3 * joint : k >= 3 * joint) ? 1 : 0;
        }
        if (stroke->closed()) marks.front() = marks.back() = 1;
      }
      select(id, std::move(marks));
    }
  }
  /// Selects the control points in a circle around a random point of a stroke.
  void select_loop() {
    const Point center = some_point();
    const double radius = random.uniform(3, 30);
    for (const StrokeId id : ids) {
      Selection::Marks marks;
      for (const Point p : fixture.document.find(id)->data().points) {
        marks.push_back(distance(p, center) < radius ? 1 : 0);
      }
      if (std::find(marks.begin(), marks.end(), 1) != marks.end()) select(id, std::move(marks));
    }
  }
  [[nodiscard]] Point some_point() {
    const auto k = static_cast<std::size_t>(random.pick(0, static_cast<int>(ids.size()) - 1));
    const StrokePtr stroke = fixture.document.find(ids[k]);
    return stroke->position(random.uniform(0, 1) * stroke->segment_count());
  }
  /// Drags along a straight path. Returns the largest gap of the previews and of the result.
  std::pair<double, double> drag(const char* mode, Point from, Point to) {
    EXPECT_TRUE(tool.set_option("mode", std::string(mode)));
    Pen pen{tool, fixture};
    Edit last;
    double during = 0.0;
    pen.up(from);
    for (const Point p : way(from, to, 0.8)) {
      ToolResult result = pen.at({p.x, p.y, -1.0});
      if (result.preview) last = *result.preview;
      during = std::max(during, worst_gap_mm(last));
    }
    pen.up(to);
    return {during, worst_gap_mm({})};
  }
  std::pair<double, double> drag(const char* mode) {
    const Point from = some_point();
    return drag(mode, from, from + Vec{random.uniform(-15, 15), random.uniform(-15, 15)});
  }
};

TEST(JoinedTransform, R33_JunctionsHoldWhateverPartIsSelected) {
  int commits = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Transformed d(seed);
    d.draw(seed);
    d.note_gaps();
    if (seed % 20 < 10) {
      d.select_some();
    } else {
      d.select_loop();
    }
    if (d.fixture.selection.strokes().empty()) continue;
    const Document before = d.fixture.document;
    const auto [during, after] = d.drag(kModes[seed % 3]);
    EXPECT_LE(during, kApartMm);
    EXPECT_LE(after, kApartMm);
    if (before == d.fixture.document) continue;
    ++commits;
    d.fixture.undo();
    EXPECT_EQ(before, d.fixture.document) << "one step";
  }
  EXPECT_GT(commits, 600);
}

/// Returns the largest distance from a stroke of `a` to the same stroke of `b`.
double largest_distance_mm(const JoinedDrawing& d, const Document& a, const Document& b) {
  double largest = 0.0;
  for (const StrokeId id : d.ids) {
    const Stroke& stroke = *a.find(id);
    for (double u = 0.0; u <= stroke.segment_count(); u += 0.125) {
      largest = std::max(largest, testing::distance_to(*b.find(id), stroke.position(u)));
    }
  }
  return largest;
}

TEST(JoinedTransform, R33_JunctionsHoldThroughManyTransforms) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Transformed d(seed);
    d.draw(seed);
    d.note_gaps();
    for (int k = 0; k < 5; ++k) {
      d.fixture.selection.clear();
      if (d.random.chance(0.5)) {
        d.select_some();
      } else {
        d.select_loop();
      }
      if (d.fixture.selection.strokes().empty()) continue;
      const auto [during, after] = d.drag(k % 2 == 0 ? "stretch" : kModes[seed % 3]);
      EXPECT_LE(during, kApartMm) << k;
      EXPECT_LE(after, kApartMm) << k;
    }
  }
}

/// Returns the number of points that the strokes share.
std::size_t count_junctions(const JoinedDrawing& d) {
  std::size_t count = 0;
  for (const StrokeId id : d.ids) {
    const Stroke& stroke = *d.fixture.document.find(id);
    std::set<std::tuple<StrokeId, double, double>> found;  // a point at a joint may be found twice
    for (const Junction& j : junctions_of(d.fixture.document, d.fixture.index, id, stroke)) {
      count += found.emplace(j.other, j.point.x, j.point.y).second ? 1 : 0;
    }
  }
  return count;
}

TEST(JoinedTransform, R33_ALoopedPartGoesThereAndBackWithinANanometre) {
  int commits = 0, loose = 0, met = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Transformed d(seed);
    d.draw(seed);
    d.select_loop();
    if (d.fixture.selection.strokes().empty()) continue;
    const Document before = d.fixture.document;
    const Point from = d.some_point();
    const Vec by{d.random.uniform(-9, 9), d.random.uniform(-9, 9)};
    if (MovedStrokes(before, d.fixture.index, d.fixture.selection, false).connected_pull()) {
      ++loose;
      continue;
    }
    const std::size_t junctions = count_junctions(d);
    d.drag("move", from, from + by);
    if (before == d.fixture.document) continue;
    if (count_junctions(d) != junctions) {
      ++met;  // an end has met another line, and so they share a point now
      continue;
    }
    ++commits;
    d.drag("move", from + by, from);
    EXPECT_LE(largest_distance_mm(d, before, d.fixture.document), 1e-9);
  }
  EXPECT_GT(commits, 150);
  EXPECT_LT(loose, 150);
  EXPECT_LT(met, 5);
}

TEST(JoinedTransform, R33_LinesThatAreSelectedWholeGoThereAndBackWithinANanometre) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Transformed d(seed);
    d.draw(seed);
    for (const StrokeId id : d.ids) {
      if (d.random.chance(0.4)) {
        d.select(id, Selection::Marks(d.fixture.document.find(id)->data().points.size(), 1));
      }
    }
    if (d.fixture.selection.strokes().empty()) continue;
    const Document before = d.fixture.document;
    const std::size_t junctions = count_junctions(d);
    const Affine map = then(rotation(d.random.uniform(-1, 1), {3, 4}), scaling(0.8));
    const MovedStrokes there(before, d.fixture.index, d.fixture.selection, false);
    d.fixture.apply(there.finished(map, 1.0, "There"));
    const std::size_t after_there = count_junctions(d);
    const MovedStrokes back(d.fixture.document, d.fixture.index, d.fixture.selection, false);
    d.fixture.apply(back.finished(*inverse(map), 1.0, "Back"));
    if (!there.connected_pull() && junctions == after_there) {
      EXPECT_LE(largest_distance_mm(d, before, d.fixture.document), 1e-9);
    }
  }
}

TEST(JoinedTransform, R33_LinesStayJoinedToLockedOnes) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Transformed d(seed);
    // The locked line begins on the middle of a line, and two lines end on its middle.
    const StrokeId base = d.line({5, -40}, {45, -20});
    const StrokePtr on = d.fixture.document.find(base);
    d.begin_locked();
    const StrokeId locked =
        d.line(on->position(d.random.uniform(0.1, 0.9) * on->segment_count()), {25, 30});
    d.end_locked();
    const StrokePtr held = d.fixture.document.find(locked);
    const Point foot = held->position(d.random.uniform(0.1, 0.9) * held->segment_count());
    const StrokeId a = d.line({-30, 0}, foot), b = d.line(foot, {0, 40});
    d.shared = {{a, true, locked}, {b, false, locked}, {a, true, b}, {locked, false, base}};
    d.ids = {base, a, b};
    d.note_gaps();
    for (const StrokeId id : d.ids) {
      // The first or the second half, so that no line is selected as a whole.
      const std::size_t points = d.fixture.document.find(id)->data().points.size();
      Selection::Marks marks(points);
      const bool first = d.random.chance(0.5);
      for (std::size_t k = 0; k < points; ++k) marks[k] = (2 * k < points) == first ? 1 : 0;
      if (d.random.chance(0.7)) d.select(id, std::move(marks));
    }
    if (d.fixture.selection.strokes().empty()) continue;
    const auto [during, after] = d.drag(kModes[seed % 3]);
    EXPECT_EQ(d.fixture.document.find(locked), held);
    EXPECT_LE(during, kApartMm);
    EXPECT_LE(after, kApartMm);
  }
}

TEST(JoinedTransform, R33_AWholeLineKeepsItsShapeAndTheOthersFollow) {
  Transformed d(1);
  d.star(4, 80, 100);
  d.note_gaps();
  const StrokePtr whole = d.fixture.document.find(d.ids[0]);
  d.select(d.ids[0], Selection::Marks(whole->data().points.size(), 1));
  // Of another line only the far part is selected, so that its shared end is not.
  const StrokePtr part = d.fixture.document.find(d.ids[1]);
  Selection::Marks marks(part->data().points.size());
  const bool starts_here = distance(part->position(0.0), {0, 0}) < 1e-9;
  marks[starts_here ? marks.size() - 1 : 0] = 1;
  d.select(d.ids[1], std::move(marks));
  const auto [during, after] = d.drag("move", {1, 1}, {8, -3});
  EXPECT_LE(std::max(during, after), 1e-9);
  const Stroke& moved = *d.fixture.document.find(d.ids[0]);
  for (std::size_t i = 0; i < whole->data().points.size(); ++i) {
    EXPECT_LE(distance(moved.data().points[i], whole->data().points[i] + Vec{7, -4}), 1e-9);
  }
}

TEST(JoinedTransform, R33_ASelectedPartGetsAJointUnderAMovedEndAndStaysSelected) {
  Transformed d(3);
  const StrokeId base = d.line({-40, 0}, {40, 0});
  const StrokePtr stroke = d.fixture.document.find(base);
  const Point foot = stroke->position(0.4 * stroke->segment_count());
  const StrokeId post = d.line(foot + Vec{0, 30}, foot);
  Selection::Marks marks(stroke->data().points.size());
  marks[0] = marks[1] = 1;
  d.select(base, std::move(marks));
  d.select(post, Selection::Marks(d.fixture.document.find(post)->data().points.size(), 1));
  EXPECT_FALSE(MovedStrokes(d.fixture.document, d.fixture.index, d.fixture.selection, false)
                   .connected_pull())
      << "nothing has to be bent";
  d.drag("move", {-40, 0}, {-44, 6});
  const Selection::Marks* after = d.fixture.selection.find(base);
  ASSERT_TRUE(after);
  const Stroke& cut = *d.fixture.document.find(base);
  ASSERT_EQ(after->size(), cut.data().points.size());
  EXPECT_GT(cut.segment_count(), stroke->segment_count());
  EXPECT_TRUE(after->front());
  EXPECT_FALSE(after->back());
}

}  // namespace
}  // namespace felt::joined_transform_test
