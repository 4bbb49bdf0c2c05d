#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "felt/tools/connect/connect_tool.h"
#include "felt/tools/connect/near_tips.h"
#include "felt/tools/testing/joined_drawing.h"

namespace felt::joined_connect_test {
namespace {

using testing::JoinedDrawing;
using testing::Pen;
using testing::SharedEnd;

/// Lines may be this much farther from each other after connecting than before it.
constexpr double kApartMm = 0.03;

enum class Way { kDrag, kExtend, kTap };

/// Lines that share points, and an end of one of them that is connected.
struct Connected : JoinedDrawing {
  explicit Connected(std::uint64_t seed) : JoinedDrawing(seed) {
    draw(seed / 4);
    const Stroke* chosen = nullptr;
    do {
      moved.stroke =
          ids[static_cast<std::size_t>(random.pick(0, static_cast<int>(ids.size()) - 1))];
      chosen = fixture.document.find(moved.stroke).get();
    } while (chosen->closed());
    moved.tip = random.chance(0.5) ? StrokeTip::kStart : StrokeTip::kEnd;
    const StrokePtr line_of_end = fixture.document.find(moved.stroke);
    from = tip_point(*line_of_end, moved.tip);
    const double u = random.uniform(0.1, 0.9) * line_of_end->segment_count();
    post(moved.stroke, u, from + 40.0 * some_direction());
  }

  Vec some_direction() { return direction(random.uniform(0, 360)) - Point{}; }
  /// Of several ends in one point, the tool takes one.
  void find_taken_end() { moved = editable_tips_near(fixture.scene(), from, 1.0, 1).front().id; }
  /// Adds a line that begins at this distance from the end, and returns that point.
  Point add_target(double distance_mm) {
    const Point at = from + distance_mm * some_direction();
    target = line(at, at + 30.0 * some_direction());
    return at;
  }
  /// Returns true if a shared point is an end that the gesture takes away.
  [[nodiscard]] bool leaves(const SharedEnd& s) const {
    const Point p =
        tip_point(*fixture.document.find(s.a), s.at_end ? StrokeTip::kEnd : StrokeTip::kStart);
    return distance(p, from) < 0.05 && (s.a == moved.stroke || s.b == moved.stroke);
  }
  void forget_the_dragged_end() {
    std::erase_if(shared, [this](const SharedEnd& s) { return leaves(s); });
  }
  /// Makes the gesture. Returns true if it changed the drawing.
  bool go(Way how, Point to) {
    ConnectTool tool;
    Pen pen{tool, fixture};
    EXPECT_TRUE(tool.set_option("keep_separate", true));
    EXPECT_TRUE(tool.set_option("extend", how == Way::kExtend));
    pen.up(from);
    pen.at({from.x, from.y, -1.0});
    for (int k = 1; how != Way::kTap && k <= 20; ++k) {
      const Point at = lerp(from, to, k / 20.0);
      const ToolResult result = pen.at({at.x, at.y, -1.0});
      if (result.preview) during = std::max(during, worst_gap_mm(*result.preview));
    }
    pen.up(how == Way::kTap ? from : to);
    return pen.commits > 0;
  }

  TipId moved;
  Point from;
  StrokeId target;
  double during = 0.0;
};

TEST(JoinedConnect, R33_LinesThatStandOnALineWhoseEndMovesFollow) {
  int changed = 0, gestures = 0;
  std::vector<std::pair<std::uint64_t, double>> torn;  // seed and gap
  for (std::uint64_t seed = 0; seed < 1200; ++seed) {
    SCOPED_TRACE(seed);
    Connected d(seed);
    const Way how = static_cast<Way>(seed % 3);
    const double gap_mm = how == Way::kExtend ? d.random.uniform(2, 12)
                          : how == Way::kTap  ? d.random.uniform(0.5, 4)
                                              : d.random.uniform(3, 15);
    const Point to =
        how == Way::kExtend ? d.from + gap_mm * d.some_direction() : d.add_target(gap_mm);
    d.find_taken_end();
    if (how != Way::kTap) d.forget_the_dragged_end();
    d.note_gaps();
    const Document before = d.fixture.document;
    const bool is_changed = d.go(how, to);
    const double apart_mm = std::max(d.during, d.worst_gap_mm({}));
    if (apart_mm > kApartMm) torn.emplace_back(seed, apart_mm);
    ++gestures;
    changed += is_changed ? 1 : 0;
    if (!is_changed) continue;
    d.fixture.undo();
    EXPECT_EQ(d.fixture.document, before) << "one step";
  }
  EXPECT_GT(changed, gestures * 3 / 4);
  EXPECT_TRUE(torn.empty()) << ::testing::PrintToString(torn);
}

TEST(JoinedConnect, R33_AnEndThatGoesToTheEndOfTheLineItStandsOnLeavesThatLineAlone) {
  testing::Fixture f;
  const StrokeId base = f.add(testing::straight_stroke({0, 0}, {40, 0}, 1, 1));
  const StrokeId post = f.add(testing::straight_stroke({38, 1.4}, {39, 0}, 1, 1));
  const Stroke before = *f.document.find(base);
  ConnectTool tool;
  ASSERT_TRUE(tool.set_option("keep_separate", true));
  Pen pen{tool, f};
  pen.up({39, 0});
  pen.at({39, 0, -1.0});
  pen.up({39, 0});
  ASSERT_EQ(f.history.undo_label(), "Connect");
  EXPECT_EQ(*f.document.find(base), before);
  EXPECT_EQ(tip_point(*f.document.find(post), StrokeTip::kEnd), (Point{40, 0}));
}

TEST(JoinedConnect, R33_LinesFollowALineThatIsJoinedAndKeepTheirPlaces) {
  testing::Fixture f;
  const StrokeId left = f.add(testing::straight_stroke({0, 0}, {50, 0}, 1, 1));
  const StrokeId post = f.add(testing::straight_stroke({45, 30}, {45, 0}, 1, 1));
  const StrokeId right = f.add(testing::straight_stroke({54, 4}, {104, 4}, 1, 1));
  const StrokeId last = f.add(testing::straight_stroke({54, 50}, {104, 50}, 1, 1));
  const Document before = f.document;
  ConnectTool tool;
  Pen pen{tool, f};
  pen.line(testing::way({50, 0}, {54, 4}));
  ASSERT_EQ(f.history.undo_label(), "Connect");
  EXPECT_FALSE(f.document.find(left));
  const Stroke one = *f.document.find(right);
  const Point foot = tip_point(*f.document.find(post), StrokeTip::kEnd);
  EXPECT_LE(testing::distance_to(one, foot), kApartMm);
  EXPECT_GT(foot.y, 1.0);
  EXPECT_EQ(f.document.layers()[0].strokes, (std::vector<StrokeId>{post, right, last}));
  f.undo();
  EXPECT_EQ(f.document, before);
}

}  // namespace
}  // namespace felt::joined_connect_test
