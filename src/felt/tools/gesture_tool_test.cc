#include "felt/tools/gesture_tool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::gesture_tool_test {
namespace {

constexpr OptionSpec kProbeOptions[] = {
    {"size_mm", "Size", "mm", OptionKind::kNumber, 0.1, 5.0, 1.0, {}, "Of something."}};
constexpr ToolInfo kInfo{.id = "told", .label = "Told", .help = "Tells.", .options = kProbeOptions};

/// Records the calls of the virtual functions as text: h for hover, b for begin, m for move, e for
/// end, d for drop, and the value of an option for take_options.
class Reported final : public GestureTool {
 public:
  Reported() : GestureTool(kInfo) {}
  [[nodiscard]] ForceModel force(const Scene&) const override { return {}; }
  void draw(Overlay&) const override {}
  std::string said;
  double size_mm = 0.0;
  using GestureTool::in_gesture;

 protected:
  ToolResult hover(const PenSample&, const Scene&) override { return say('h'); }
  ToolResult begin(const PenSample&, const Scene&) override { return say('b'); }
  ToolResult move(const PenSample&, const Scene&) override {
    say('m');
    return {.preview = Edit{"m", {}}};
  }
  ToolResult end(const Scene&) override { return say('e'); }
  void drop() override { say('d'); }
  void take_options(const OptionValues& options) override { size_mm = options.number(0); }

 private:
  ToolResult say(char c) {
    said += c;
    return {};
  }
};

struct Table {
  Reported tool;
  testing::Fixture fixture;
  testing::Pen pen{tool, fixture};
};

TEST(GestureTool, FromTouchToLiftIsOneGesture) {
  Table t;
  t.pen.up({0, 0});
  t.pen.along({{0, 0}, {1, 0}, {2, 0}});
  t.pen.up({2, 0});
  t.pen.up({2, 0});
  EXPECT_EQ(t.tool.said, "hbmmeh");
}

TEST(GestureTool, ABounceIsHeldBackAndThenTold) {
  Table t;
  t.pen.down({0, 0});
  const ToolResult in_gap = t.pen.at({0.5, 0, 0.1});
  EXPECT_TRUE(in_gap.same_preview);
  EXPECT_EQ(t.tool.said, "b");
  t.pen.down({1, 0});
  EXPECT_EQ(t.tool.said, "bmm");
}

TEST(GestureTool, CancelWaitsForTheLift) {
  Table t;
  t.pen.down({0, 0});
  t.tool.cancel();
  t.pen.along({{1, 0}, {2, 0}});
  EXPECT_EQ(t.tool.said, "bd");
  t.pen.up({2, 0});
  t.pen.down({2, 0});
  EXPECT_EQ(t.tool.said, "bdhb");
}

TEST(GestureTool, FinishEndsAsIfLiftedAndThenWaits) {
  Table t;
  t.pen.along({{0, 0}, {1, 0}});
  t.tool.finish(t.fixture.scene());
  t.pen.down({2, 0});
  EXPECT_EQ(t.tool.said, "bme");
}

/// A tool that commits the replacement of a stroke by another stroke, or by an equal copy if that
/// is null.
class Replaces final : public GestureTool {
 public:
  explicit Replaces(StrokePtr after) : GestureTool(kInfo), after_(std::move(after)) {}
  [[nodiscard]] ForceModel force(const Scene&) const override { return {}; }
  void draw(Overlay&) const override {}

 protected:
  ToolResult hover(const PenSample&, const Scene&) override { return {}; }
  ToolResult begin(const PenSample&, const Scene&) override { return {}; }
  ToolResult move(const PenSample&, const Scene&) override { return {}; }
  ToolResult end(const Scene& scene) override {
    const StrokeId id = scene.document.layers().front().strokes.front();
    EditBuilder edit(scene.document);
    edit.replace(id, after_ ? after_ : std::make_shared<const Stroke>(*scene.document.find(id)));
    return {.commit = std::move(edit).build("Replace")};
  }
  void drop() override {}
  void take_options(const OptionValues&) override {}

 private:
  StrokePtr after_;
};

TEST(GestureTool, StrokesThatCameOutAsTheyWereAreNoChange) {
  const auto line = [](double x) { return testing::straight_stroke({0, 0}, {x, 0}, 1, 1); };
  for (const bool same : {true, false}) {
    testing::Fixture fixture;
    fixture.add(line(10.0));
    Replaces tool(same ? nullptr : std::make_shared<const Stroke>(line(20.0)));
    testing::Pen pen(tool, fixture);
    pen.line({{0, 0}, {1, 0}});
    EXPECT_EQ(pen.commits, same ? 0 : 1);
  }
}

TEST(GestureTool, OptionsWaitForTheEndOfTheGesture) {
  Table t;
  t.pen.up({0, 0});
  EXPECT_EQ(t.tool.size_mm, 1.0);
  t.pen.down({0, 0});
  ASSERT_TRUE(t.tool.set_option("size_mm", 3.0));
  EXPECT_EQ(t.tool.size_mm, 1.0);
  EXPECT_EQ(std::get<double>(*t.tool.option("size_mm")), 3.0);
  t.pen.up({0, 0});
  t.pen.up({0, 0});
  EXPECT_EQ(t.tool.size_mm, 3.0);
  ASSERT_TRUE(t.tool.set_option("size_mm", 4.0));
  EXPECT_EQ(t.tool.size_mm, 4.0) << "in the air at once";
  EXPECT_FALSE(t.tool.set_option("size_mm", 9.0));
}

TEST(GestureTool, PlacesThatAreNoneAreIgnored) {
  Table t;
  const double nan = std::nan("");
  t.pen.at({nan, 0, -1});
  t.pen.at({0, std::numeric_limits<double>::infinity(), -1});
  t.pen.at({0, 0, -1e300});
  EXPECT_EQ(t.tool.said, "");
  EXPECT_FALSE(t.tool.in_gesture());
}

}  // namespace
}  // namespace felt::gesture_tool_test
