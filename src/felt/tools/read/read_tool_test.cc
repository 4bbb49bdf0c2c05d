#include <gtest/gtest.h>

#include <cmath>

#include "felt/document/edit_builder.h"
#include "felt/tools/read/read_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::read_tool_test {
namespace {

using Kind = Reading::Kind;

struct Fixture {
  testing::Fixture fixture;
  ReadTool tool;
  testing::Pen pen{tool, fixture};

  StrokeId line(Point from, Point to) {
    return fixture.add(testing::straight_stroke(from, to, 1, 1));
  }
  [[nodiscard]] const Reading& reading() const { return *tool.reading(); }
  void touch(Point p) {
    pen.up(p);
    pen.down(p);
  }
  /// Returns the force at a point after the pen has rested there.
  [[nodiscard]] Force force_at(Point p) const {
    ForceMemory memory;
    PenSample sample;
    sample.position = {p.x, p.y, -1};
    const ForceModel model = tool.force(fixture.scene());
    Force force;
    for (int i = 0; i < 400; ++i) {
      memory.begin_tick(0.001);
      force = model(sample, memory);
    }
    return force;
  }
  /// Follows a path and returns the kinds of readings, each when it begins.
  std::vector<Kind> kinds_along(const std::vector<Point>& path) {
    std::vector<Kind> kinds;
    pen.up(path.front());
    std::uint32_t news = reading().news;
    for (const Point p : path) {
      pen.down(p);
      if (news == reading().news) continue;
      news = reading().news;
      kinds.push_back(reading().kind);
    }
    pen.up(path.back());
    return kinds;
  }
};

TEST(Read, ALineAttractsThePenAndNothingChanges) {
  Fixture f;
  f.line({0, 0}, {60, 0});
  const Document before = f.fixture.document;
  f.touch({30, 2});
  for (int i = 0; i < 200; ++i) f.pen.down({30, 2});
  const Force force = f.force_at({30, 2});
  EXPECT_NEAR(force.y, -0.42, 0.02) << "210 N/m";
  EXPECT_NEAR(force.x, 0.0, 0.01);
  EXPECT_EQ(f.force_at({30, 7}).y, 0.0) << "it lets go";
  f.pen.up({30, 2});
  EXPECT_EQ(f.pen.commits, 0);
  EXPECT_TRUE(f.fixture.document == before);
  EXPECT_EQ(f.force_at({30, 2}).y, 0.0) << "the pen is lifted";
  ASSERT_TRUE(f.tool.set_option("strength", 0.0));
  f.touch({30, 2});
  EXPECT_EQ(f.force_at({30, 2}).y, 0.0);
}

TEST(Read, SaysWhatIsUnderThePen) {
  Fixture f;
  const StrokeId line = f.line({0, 0}, {60, 0});
  f.touch({30, 2.5});
  EXPECT_EQ(f.reading().kind, Kind::kLine);
  EXPECT_EQ(f.reading().stroke, line);
  EXPECT_NEAR(f.reading().length_mm, 60.0, 0.01);
  EXPECT_NEAR(f.reading().distance_mm, 2.0, 0.01) << "from the edge of the ink";
  EXPECT_TRUE(f.reading().has_sound);
  f.pen.down({30, 12});
  EXPECT_EQ(f.reading().kind, Kind::kNothing);
  EXPECT_NEAR(f.reading().distance_mm, 11.5, 0.3);
  f.pen.down({30, 90});
  EXPECT_TRUE(std::isinf(f.reading().distance_mm));
  f.pen.up({30, 90});
  EXPECT_FALSE(f.reading().is_down);
  ASSERT_TRUE(f.tool.set_option("sound", false));
  EXPECT_FALSE(f.reading().has_sound);
}

TEST(Read, EndsAndCrossingsClickOnceEach) {
  Fixture f;
  f.line({0, 0}, {60, 0});
  f.line({30, -20}, {30, 20});  // crosses
  f.line({45, 0.4}, {45, 20});  // touches with its ink
  f.line({52, 3}, {52, 20});    // does not
  const std::vector<Kind> wanted{Kind::kEnd,      Kind::kLine, Kind::kCrossing, Kind::kLine,
                                 Kind::kCrossing, Kind::kLine, Kind::kEnd};
  EXPECT_EQ(f.kinds_along(testing::way({0, 0}, {60, 0})), wanted);
  EXPECT_EQ(f.reading().clicks, 4U);
  EXPECT_EQ(f.kinds_along(testing::way({60, 0}, {0, 0})), wanted) << "also backwards";
}

TEST(Read, CountsTheLinesOfACrossing) {
  Fixture f;
  f.line({0, 0}, {60, 0});
  f.line({30, -20}, {30, 20});
  f.line({10, -20}, {50, 20});
  f.touch({30, 0.5});
  EXPECT_EQ(f.reading().kind, Kind::kCrossing);
  EXPECT_EQ(f.reading().lines, 3U);
}

/// Two lines that begin at the same point are one corner, not an end.
TEST(Read, LinesThatMeetDoNotEnd) {
  Fixture f;
  f.line({0, 0}, {30, 0});
  f.line({30, 0}, {30, 40});
  f.touch({29.8, 0});
  EXPECT_EQ(f.reading().kind, Kind::kCrossing);
  EXPECT_EQ(f.reading().lines, 2U);
}

TEST(Read, ThePenGoesStraightOnAtACrossingUnlessItIsPushed) {
  Fixture f;
  const StrokeId along = f.line({0, 0}, {60, 0});
  const StrokeId across = f.line({30, -30}, {30, 30});
  f.pen.up({10, 0});
  f.pen.along(testing::way({10, 0}, {40, 0.4}));
  EXPECT_EQ(f.reading().stroke, along);
  f.pen.along(testing::way({40, 0.4}, {30, 0}));
  f.pen.along(testing::way({30, 0}, {30, 15}));
  EXPECT_EQ(f.reading().stroke, across);
}

TEST(Read, ReadsLockedLayersButNoHiddenOnes) {
  Fixture f;
  const StrokeId line = f.line({0, 0}, {60, 0});
  const auto change = [&](bool visible, bool locked) {
    const Layer& layer = f.fixture.document.layers().front();
    LayerState after = layer.state();
    after.visible = visible;
    after.locked = locked;
    f.fixture.apply({"Layer", {}, {{layer.id, layer.state(), after, 0, 0}}});
  };
  change(true, true);
  f.touch({30, 1});
  EXPECT_EQ(f.reading().stroke, line);
  f.pen.up({30, 1});
  change(false, false);
  f.touch({30, 1});
  EXPECT_EQ(f.reading().kind, Kind::kNothing);
}

TEST(Read, ReadsOnlyTheCurrentLayerIfChosen) {
  Fixture f;
  f.line({0, 0}, {60, 0});
  ASSERT_TRUE(f.tool.set_option("layers", std::string("current")));
  f.touch({30, 1});
  EXPECT_EQ(f.reading().kind, Kind::kLine);
  f.pen.up({30, 1});
  f.fixture.apply({"Layer", {}, {{LayerId{2}, std::nullopt, LayerState{"Over"}, 0, 1}}});
  f.fixture.layer = {2};
  f.touch({30, 1});
  EXPECT_EQ(f.reading().kind, Kind::kNothing);
}

TEST(Read, NamesTheHighestFill) {
  Fixture f;
  EditBuilder edit(f.fixture.document);
  FillLoop loop{{{0, 0}}, {}};
  for (const Point to : {Point{40, 0}, Point{40, 40}, Point{0, 40}, Point{0, 0}}) {
    loop.points.insert(loop.points.end(), {loop.points.back(), to, to});
  }
  edit.add_fill({1}, std::make_shared<const Fill>(Fill{{loop}, {}, 0.0}));
  const FillId high = edit.add_fill({1}, std::make_shared<const Fill>(Fill{{loop}, {}, 0.0}));
  f.fixture.apply(std::move(edit).build("Fill"));
  f.touch({20, 20});
  EXPECT_EQ(f.reading().kind, Kind::kFill);
  EXPECT_EQ(f.reading().fill, high);
  f.pen.down({50, 20});
  EXPECT_EQ(f.reading().kind, Kind::kNothing);
}

TEST(Read, TheStrokeThatIsReadMayVanish) {
  Fixture f;
  const StrokeId line = f.line({0, 0}, {60, 0});
  f.touch({30, 1});
  EditBuilder edit(f.fixture.document);
  edit.remove(line);
  f.fixture.apply(std::move(edit).build("Erase"));
  f.pen.down({30.1, 1});
  EXPECT_EQ(f.reading().kind, Kind::kNothing);
  f.tool.cancel();
  EXPECT_FALSE(f.reading().is_down);
}

}  // namespace
}  // namespace felt::read_tool_test
