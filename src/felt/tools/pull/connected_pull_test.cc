#include "felt/tools/connected_pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/tools/junctions.h"
#include "felt/tools/pull/pull_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::connected_pull_test {
namespace {

using testing::Fixture;
using testing::Pen;
using testing::straight_stroke;
using testing::way;

struct PullFixture {
  Fixture fixture;
  PullTool tool;
  Pen pen{tool, fixture};

  StrokeId add(Point a, Point b, Rgba color = {}) {
    StrokeData data = straight_stroke(a, b, 1, 1).data();
    data.color = color;
    return fixture.add(Stroke::create(std::move(data)).value());
  }
  [[nodiscard]] const Stroke& at(StrokeId id) const { return *fixture.document.find(id); }
};

constexpr Rgba kPullRed{200, 0, 0, 255};

TEST(ConnectedPull, R33_PullingASharedEndTakesTheOtherLineAlong) {
  for (const char* mode : {"brush", "sweep"}) {
    PullFixture p;
    ASSERT_TRUE(p.tool.set_option("mode", std::string(mode)));
    const StrokeId line = p.add({0, 0}, {80, 0}), red = p.add({80, 0}, {80, 90}, kPullRed);
    const Document before = p.fixture.document;
    p.pen.line(way({80, 0}, {100, -9}));
    EXPECT_EQ(p.pen.commits, 1) << mode;
    const Stroke &a = p.at(line), &b = p.at(red);
    const Point end = a.position(a.segment_count());
    EXPECT_GT(distance(end, {80, 0}), 5.0) << mode;
    EXPECT_LE(distance(b.position(0), end), kSharedPointMm) << mode;
    EXPECT_EQ(b.position(b.segment_count()), (Point{80, 90}));
    p.fixture.undo();
    EXPECT_EQ(p.fixture.document, before) << "one step";
  }
}

TEST(ConnectedPull, R33_PullingElsewhereLeavesTheSharedEndWhereItIs) {
  PullFixture p;
  const StrokeId line = p.add({0, 0}, {80, 0}), red = p.add({80, 0}, {80, 90}, kPullRed);
  const Stroke before = p.at(red);
  p.pen.line(way({40, 0}, {40, 15}));
  EXPECT_EQ(p.at(red), before);
  EXPECT_EQ(p.at(line).position(p.at(line).segment_count()), (Point{80, 0}));
}

TEST(ConnectedPull, R33_AnEndInTheMiddleStaysOnTheLineThatIsPulled) {
  PullFixture p;
  const StrokeId line = p.add({0, 0}, {80, 0}), post = p.add({40, 70}, {40, 0}, kPullRed);
  const StrokeId far = p.add({5, 70}, {5, 0}, kPullRed);
  const Stroke unmoved = p.at(far);
  p.pen.line(way({42, 0}, {42, -15}));
  const Stroke& end = p.at(post);
  const Point tip = end.position(end.segment_count());
  EXPECT_LT(tip.y, -10.0);
  double gap = 1e300;
  for (int i = 0; i < p.at(line).segment_count(); ++i) {
    gap = std::min(gap, nearest(p.at(line).segment(i), tip).distance_squared);
  }
  EXPECT_LE(std::sqrt(gap), 0.15) << "the refit at the lift may move the line a little";
  EXPECT_EQ(p.at(far), unmoved) << "beyond the reach of the brush";
}

TEST(ConnectedPull, R33_TheLineThatAPulledEndStandsOnFollows) {
  PullFixture p;
  const StrokeId base = p.add({0, 0}, {80, 0}, kPullRed), post = p.add({40, 70}, {40, 0});
  p.pen.line(way({40, 0.5}, {40, -14.5}));
  const Stroke& moved = p.at(post);
  const Point tip = moved.position(moved.segment_count());
  double gap = 1e300;
  for (int i = 0; i < p.at(base).segment_count(); ++i) {
    gap = std::min(gap, nearest(p.at(base).segment(i), tip).distance_squared);
  }
  EXPECT_LE(std::sqrt(gap), 0.15);
}

TEST(ConnectedPull, R33_AnEndOnALockedLineIsHeld) {
  PullFixture p;
  p.fixture.apply({"Layer", {}, {{{2}, std::nullopt, LayerState{"Other"}, 0, 1}}});
  const StrokeId line = p.add({0, 0}, {80, 0});
  p.fixture.layer = LayerId{2};
  const StrokeId red = p.add({80, 0}, {80, 90}, kPullRed);
  p.fixture.apply(
      {"State", {}, {{{2}, LayerState{"Other"}, LayerState{"Other", true, true}, 1, 1}}});
  p.fixture.layer = LayerId{1};
  const Stroke before = p.at(red);
  p.pen.line(way({80, 0}, {100, -9}));
  EXPECT_EQ(p.at(red), before);
  EXPECT_LE(distance(p.at(line).position(p.at(line).segment_count()), {80, 0}), 1e-9);
}

/// Parallel lines, with a post on the middle of each.
struct Posts {
  Fixture fixture;
  std::vector<StrokeId> lines;
  std::set<StrokeId> posts;

  explicit Posts(int count) {
    for (int i = 0; i < count; ++i) {
      const double x = 100.0 * i;
      lines.push_back(fixture.add(straight_stroke({x, 0}, {x + 80, 0}, 1, 1)));
      posts.insert(fixture.add(straight_stroke({x + 40, 70}, {x + 40, 0}, 1, 1)));
    }
  }
  /// Returns the edit of a gesture that bends each line, beginning with number `first`, by `mm`.
  [[nodiscard]] Edit bent(std::size_t first, double mm) const {
    EditBuilder edit(fixture.document);
    for (std::size_t i = first; i < lines.size(); ++i) {
      auto stroke = BrushPull(fixture.document.find(lines[i]), 0.5).at({0, -mm}).value();
      edit.replace(lines[i], std::make_shared<const Stroke>(std::move(stroke)));
    }
    return std::move(edit).build("Push");
  }
  [[nodiscard]] std::set<StrokeId> followers(const Edit& edit) const {
    std::set<StrokeId> found;
    for (const StrokeChange& c : edit.changes) {
      if (posts.contains(c.id)) found.insert(c.id);
    }
    return found;
  }
};

TEST(ConnectedPull, R33_ManyPushedLinesTakeTheirPostsAlong) {
  Posts p(200);
  ConnectedPull connected{BrushOptions{}};
  Edit edit = p.bent(0, 5.0);
  connected.complete(edit, p.fixture.scene());
  EXPECT_EQ(p.followers(edit), p.posts) << "the lines themselves do not count";
}

TEST(ConnectedPull, WhoeverFollowsGoesOnFollowingWhenOthersCome) {
  Posts p(300);
  ConnectedPull connected{BrushOptions{}};
  Edit last = p.bent(200, 5.0);
  connected.complete(last, p.fixture.scene());
  const auto first_ones = p.followers(last);
  EXPECT_EQ(first_ones.size(), 100u);
  Edit all = p.bent(0, 6.0);
  connected.complete(all, p.fixture.scene());
  const auto now = p.followers(all);
  EXPECT_EQ(now.size(), ConnectedPull::kMaxFollowers);
  EXPECT_TRUE(std::ranges::includes(now, first_ones));
}

TEST(ConnectedPull, ASampleMakesOneMapOfTheLineHoweverManyStandOnIt) {
  Fixture fixture;
  const StrokeId line = fixture.add(straight_stroke({0, 0}, {80, 0}, 1, 1));
  for (int i = 0; i < 40; ++i) {
    fixture.add(straight_stroke({25.0 + 0.7 * i, 70}, {25.0 + 0.7 * i, 0}, 1, 1));
  }
  const BrushPull pull(fixture.document.find(line), 0.5, {});
  ConnectedPull connected{BrushOptions{}};
  constexpr int kSamples = 30;
  for (int k = 1; k <= kSamples; ++k) {
    EditBuilder edit(fixture.document);
    edit.replace(line, std::make_shared<const Stroke>(pull.at({0, -0.5 * k}).value()));
    Edit whole = std::move(edit).build("Pull");
    connected.complete(whole, fixture.scene());
    EXPECT_EQ(whole.changes.size(), 41u);
  }
  EXPECT_LE(connected.work().maps, kSamples + 1);
  EXPECT_LE(connected.work().brushes, 40) << "one for each follower";
}

/// A line on which posts stand, one each 2 mm.
struct ManyPosts {
  Fixture fixture;
  StrokeId line;
  std::vector<StrokeId> posts;

  explicit ManyPosts(int count)
      : line(fixture.add(straight_stroke({0, 0}, {2.0 * count + 2, 0}, 1, 1))) {
    for (int i = 1; i <= count; ++i) {
      posts.push_back(fixture.add(straight_stroke({2.0 * i, 5}, {2.0 * i, 0}, 1, 1)));
    }
  }
  /// Moves all posts, each a little differently. The line follows. Returns the work.
  int move_posts(double mm) {
    EditBuilder edit(fixture.document);
    for (std::size_t i = 0; i < posts.size(); ++i) {
      StrokeData data = fixture.document.find(posts[i])->data();
      for (Point& p : data.points) p.y += mm + 0.2 * std::sin(static_cast<double>(i));
      edit.replace(posts[i], std::make_shared<const Stroke>(Stroke::create(data).value()));
    }
    return complete(std::move(edit).build("Push"));
  }
  /// Bends the line at its middle. The posts there follow. Returns the work.
  int bend(double mm) {
    const StrokePtr stroke = fixture.document.find(line);
    EditBuilder edit(fixture.document);
    const BrushPull pull(stroke, 0.5 * stroke->segment_count());
    edit.replace(line, std::make_shared<const Stroke>(pull.at({0, mm}).value()));
    return complete(std::move(edit).build("Pull"));
  }
  [[nodiscard]] double largest_gap_mm() const {
    double largest = 0.0;
    for (const StrokeId id : posts) {
      double gap = 1e300;
      for (int i = 0; i < fixture.document.find(line)->segment_count(); ++i) {
        const Point foot = fixture.document.find(id)->position(1.0);
        gap =
            std::min(gap, nearest(fixture.document.find(line)->segment(i), foot).distance_squared);
      }
      largest = std::max(largest, std::sqrt(gap));
    }
    return largest;
  }

 private:
  int complete(Edit edit) {
    ConnectedPull connected{BrushOptions{}};
    connected.complete(edit, fixture.scene());
    fixture.apply(edit);
    return connected.work().looks;
  }
};

TEST(ConnectedPull, TheWorkForManyPostsGrowsLittleFasterThanTheirNumber) {
  ManyPosts few(500), many(2000);
  const int few_moves = few.move_posts(3.0), many_moves = many.move_posts(3.0);
  EXPECT_EQ(few.fixture.document.find(few.line)->segment_count(), 1998);
  EXPECT_LE(few.largest_gap_mm(), 1e-6);
  EXPECT_LE(many_moves, 5 * few_moves);
  EXPECT_LE(few_moves, 20 * 500);
  // Now the line has hundreds of segments.
  const int few_bends = few.bend(4.0), many_bends = many.bend(4.0);
  EXPECT_LE(few.largest_gap_mm(), 1e-6);
  EXPECT_LE(many_bends, 5 * few_bends);
  EXPECT_LE(few_bends, 20 * 500);
}

TEST(ConnectedPull, WhatDoesNotChangeIsNotMadeAgain) {
  Posts p(50);
  ConnectedPull connected{BrushOptions{}};
  const Edit edit = p.bent(0, 5.0);
  Edit first = edit, second = edit;
  connected.complete(first, p.fixture.scene());
  const int maps = connected.work().maps;
  connected.complete(second, p.fixture.scene());
  EXPECT_EQ(first, second);
  EXPECT_EQ(connected.work().maps, maps);
}

TEST(ConnectedPull, ThePreviewShowsTheFollowersToo) {
  PullFixture p;
  p.add({0, 0}, {80, 0});
  p.add({80, 0}, {80, 90}, kPullRed);
  p.pen.up({80, 0});
  p.pen.down({80, 0});
  const ToolResult result = p.pen.at({90, 0, -1});
  ASSERT_TRUE(result.preview);
  EXPECT_EQ(result.preview->changes.size(), 2u);
}

}  // namespace
}  // namespace felt::connected_pull_test
