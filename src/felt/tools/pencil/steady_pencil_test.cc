// The pencil with the steady hand.
#include <gtest/gtest.h>

#include <cmath>

#include "felt/base/constants.h"
#include "felt/tools/pencil/as_drawn.h"
#include "felt/tools/pencil/pencil_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::steady_pencil_test {
namespace {

using testing::Fixture;
using testing::Pen;

constexpr double kHz = 5.0, kMm = 1.0;

/// A pencil whose pen draws along x at 40 mm/s and shakes along y.
struct SteadyPencil {
  Fixture fixture;
  PencilTool tool;
  Pen pen{tool, fixture};

  explicit SteadyPencil(bool steady) {
    set("steady", steady);
    set("steady_hz", kHz);
    set("steady_mm", kMm);
    set("steady_axis_deg", 90.0);
  }
  void set(std::string_view id, const OptionValue& value) {
    ASSERT_TRUE(tool.set_option(id, value));
  }
  static Point at(double s) { return {20.0 + 40.0 * s, 50.0 + kMm * std::sin(kTau * kHz * s)}; }
  void draw_to(double end_s) {
    for (double s = 0.0; s < end_s; s += 0.005) pen.down(at(s));
  }
  ToolResult draw(double end_s) {
    pen.step_ns = 5'000'000;
    pen.up(at(0.0));
    draw_to(end_s);
    Vec3 lift{at(end_s).x, at(end_s).y, 10.0};
    return pen.at(lift);
  }
  [[nodiscard]] const Stroke& stroke() const { return *fixture.strokes().back(); }
};

/// Returns the largest distance of the stroke from the line that was meant.
double largest_error(const Stroke& stroke, double from_x = 0.0) {
  double worst = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    for (int k = 0; k <= 20; ++k) {
      const Point p = evaluate(stroke.segment(i), 0.05 * k);
      if (p.x >= from_x) worst = std::max(worst, std::fabs(p.y - 50.0));
    }
  }
  return worst;
}

TEST(SteadyPencil, DrawsWhatWasMeant) {
  SteadyPencil shaken(false), steady(true);
  EXPECT_FALSE(shaken.draw(2.0).as_drawn);
  EXPECT_TRUE(steady.draw(2.0).as_drawn);
  EXPECT_GT(largest_error(shaken.stroke()), 0.8 * kMm);
  EXPECT_LT(largest_error(steady.stroke(), 25.0), 0.35 * kMm);
  EXPECT_LT(steady.stroke().segment_count(), shaken.stroke().segment_count());
}

TEST(SteadyPencil, AsDrawnIsTheLineWithoutTheSteadyHand) {
  SteadyPencil shaken(false), steady(true);
  shaken.draw(2.0);
  const ToolResult result = steady.draw(2.0);
  ASSERT_TRUE(result.as_drawn);
  EXPECT_EQ(result.as_drawn->label, "As drawn");
  steady.fixture.apply(*result.as_drawn);
  EXPECT_EQ(steady.stroke(), shaken.stroke());
  steady.fixture.undo();
  EXPECT_LT(largest_error(steady.stroke(), 25.0), 0.35 * kMm);
  steady.fixture.undo();
  EXPECT_TRUE(steady.fixture.strokes().empty());
}

TEST(SteadyPencil, WetInkReachesThePenAndOnlyItsTailChanges) {
  SteadyPencil steady(true);
  steady.pen.step_ns = 5'000'000;
  std::vector<Overlay::InkSegment> before;
  for (double s = 0.0; s < 4.0; s += 0.005) {
    // With bends, because a straight line is one segment, which is not stable before its end.
    const Point at = SteadyPencil::at(s) + Vec{0.0, 20.0 * std::sin(4.0 * s)};
    steady.pen.down(at);
    Overlay overlay;
    steady.tool.draw(overlay);
    const auto end = overlay.ink.begin() + static_cast<std::ptrdiff_t>(overlay.ink_stable);
    std::vector<Overlay::InkSegment> stable(overlay.ink.begin(), end);
    ASSERT_GE(stable.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) ASSERT_EQ(stable[i].curve.p, before[i].curve.p);
    before = std::move(stable);
    ASSERT_FALSE(overlay.ink.empty());
    EXPECT_LT(distance(overlay.ink.back().curve.p[3], at), 2.0 * kMm + 1e-9);
  }
  EXPECT_FALSE(before.empty());
}

TEST(SteadyPencil, ADotAndACancelledLineAreFine) {
  SteadyPencil steady(true);
  steady.pen.line({{30, 30}});
  ASSERT_EQ(steady.fixture.strokes().size(), 1u);
  steady.draw_to(0.5);
  steady.tool.cancel();
  steady.pen.up({90, 90});
  EXPECT_EQ(steady.fixture.strokes().size(), 1u);
  steady.draw(1.0);
  EXPECT_EQ(steady.fixture.strokes().size(), 2u);
}

TEST(SteadyPencil, AStraightLineHasNothingToRestore) {
  SteadyPencil steady(true);
  steady.pen.buttons = kFirstModifier;
  EXPECT_FALSE(steady.draw(2.0).as_drawn);
}

TEST(SteadyPencil, TheHandFeelsTheDampingOnlyIfItIsOn) {
  const auto force = [](bool steady_on) {
    SteadyPencil p(steady_on);
    p.pen.line({{30, 30}, {31, 30}});  // a gesture takes the options
    const ForceModel model = p.tool.force(p.fixture.scene());
    ForceMemory memory;
    double damping = 0.0;
    for (int i = 0; i < 1000; ++i) {
      memory.begin_tick(0.001);
      PenSample sample;
      sample.position = {30, 30, -1};
      sample.velocity = {60.0 * std::cos(kTau * kHz * 0.001 * i), 0, 0};
      model(sample, memory);
      for (const ForceTerms::Term& term : memory.terms) {
        if (std::string_view(term.name) == "band damping") {
          damping = std::max(damping, norm(term.force));
        }
      }
    }
    return damping;
  };
  EXPECT_EQ(force(false), 0.0);
  EXPECT_GT(force(true), 0.05);
  EXPECT_LE(force(true), 0.5);
}

TEST(ReplacedLine, RefusesEditsThatDifferInMoreThanTheLine) {
  SteadyPencil a(false), b(false);
  a.draw(1.0);
  b.draw(2.0);
  const auto edit_of = [](const SteadyPencil& p) {
    Edit edit{.label = "Draw", .changes = {}};
    edit.changes.push_back({StrokeId{7}, nullptr, p.fixture.strokes()[0], {}, {LayerId{1}, 0}});
    return edit;
  };
  const Edit one = edit_of(a);
  Edit other = edit_of(b);
  ASSERT_TRUE(replaced_line(one, other));
  EXPECT_EQ(replaced_line(one, other)->changes[0].after, other.changes[0].after);
  EXPECT_FALSE(replaced_line(one, one)) << "nothing changes";
  other.changes[0].after_place.index = 1;
  EXPECT_FALSE(replaced_line(one, other));
  other.changes.clear();
  EXPECT_FALSE(replaced_line(one, other));
}

}  // namespace
}  // namespace felt::steady_pencil_test
