#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/haptics/testing/feel_rig.h"
#include "felt/tools/smooth/smooth_force.h"
#include "felt/tools/smooth/smooth_tool.h"
#include "felt/tools/smooth/testing/jitter_ink.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::smooth_test {
namespace {

using testing::Fixture;
using testing::jittery;
using testing::Pen;
using testing::rms_from;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

struct Smooth {
  Fixture fixture;
  SmoothTool tool;
  Pen pen{tool, fixture};

  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  [[nodiscard]] const Stroke& stroke() const { return *fixture.strokes().at(0); }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
};

/// Returns points along the wave of jitter_ink.h, forwards or backwards.
std::vector<Point> along_wave(double from, double to, int steps = 1000) {
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i)
    points.push_back(testing::wave()(from + (to - from) * i / steps));
  return points;
}

TEST(SmoothTool, RubbingIronsJitterOutAsOneStepOfUndo) {
  Smooth s;
  s.fixture.add(jittery(testing::wave(), {0.2, 4.0}, 1));
  const Stroke before = s.stroke();
  s.pen.line(along_wave(0, 1) + along_wave(1, 0));
  ASSERT_EQ(s.pen.commits, 1);
  EXPECT_EQ(s.fixture.history.undo_label(), "Smooth");
  EXPECT_LT(rms_from(s.stroke(), testing::wave(), 0.05, 0.95),
            0.7 * rms_from(before, testing::wave(), 0.05, 0.95));
  EXPECT_LT(s.stroke().segment_count(), before.segment_count());
  s.fixture.undo();
  EXPECT_EQ(s.stroke(), before);
}

TEST(SmoothTool, PressingHarderAndStayingLongerIronMore) {
  const auto left = [](double pressure, double amount, int passes) {
    Smooth s;
    s.set("amount", amount);
    s.fixture.add(jittery(testing::wave(), {0.2, 5.0}, 1));
    s.pen.pressure = pressure;
    std::vector<Point> points;
    for (int i = 0; i < passes; ++i) points = points + along_wave(i % 2, 1 - i % 2);
    s.pen.line(points);
    return rms_from(s.stroke(), testing::wave(), 0.1, 0.9);
  };
  EXPECT_LT(left(1.0, 0.5, 1), left(0.2, 0.5, 1));
  EXPECT_LT(left(0.5, 1.0, 1), left(0.5, 0.2, 1));
  EXPECT_LT(left(0.5, 0.5, 3), left(0.5, 0.5, 1));
}

TEST(SmoothTool, TheResultDoesNotDependOnTheRateOfTheSamples) {
  std::vector<Stroke> results;
  for (const double hz : {60.0, 250.0, 1000.0}) {
    Smooth s;
    s.fixture.add(jittery(testing::wave(), {}, 2));
    const double seconds = 1.5;
    const int n = static_cast<int>(std::lround(seconds * hz));
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      const Point p = testing::wave()(0.5 - 0.4 * std::cos(6.28 * t));
      s.pen.give({.time_ns = std::llround(1e9 * seconds * t),
                  .position = {p.x, p.y, -1.0},
                  .velocity = {},
                  .pressure = 0.5 + 0.3 * std::sin(5 * t),
                  .buttons = 0});
    }
    s.pen.now_ns = 10'000'000'000;
    s.pen.up({50, 50});
    results.push_back(s.stroke());
  }
  std::vector<Point> line;
  for (int i = 0; i <= 20000; ++i) {
    line.push_back(results[2].position(i / 20000.0 * results[2].segment_count()));
  }
  for (std::size_t r = 0; r < 2; ++r) {
    for (int i = 0; i <= 500; ++i) {
      const Point p = results[r].position(i / 500.0 * results[r].segment_count());
      // The tolerance is 0.02 mm, plus 0.05 mm because both lines were fitted within 0.05 mm.
      EXPECT_LE(std::sqrt(nearest_on_polyline(line, p).distance_squared), 0.07);
    }
  }
}

TEST(SmoothTool, SmoothInkIsLeftAloneAndIsNoStepOfUndo) {
  Smooth s;
  s.fixture.add(straight_stroke({0, 50}, {100, 50}, 1, 2));
  const Stroke before = s.stroke();
  s.pen.line(way({0, 50}, {100, 50}));
  EXPECT_EQ(s.pen.commits, 0);
  EXPECT_EQ(s.stroke(), before);
}

TEST(SmoothTool, R20_FarAndLockedLinesAreLeftAloneAndCancelLeavesNothing) {
  Smooth s;
  s.fixture.add(jittery(testing::wave(), {}, 1));
  const Stroke before = s.stroke();
  s.pen.line(way({0, 80}, {100, 80}));
  EXPECT_EQ(s.pen.commits, 0);
  s.pen.along(along_wave(0, 0.5));
  s.tool.cancel();
  EXPECT_TRUE(s.overlay().rings.empty());
  s.pen.along(along_wave(0.5, 1));
  s.pen.up({100, 50});
  EXPECT_EQ(s.pen.commits, 0);
  const Layer* layer = s.fixture.document.layer(s.fixture.layer);
  LayerState locked = layer->state();
  locked.locked = true;
  s.fixture.apply({"Lock", {}, {{s.fixture.layer, layer->state(), locked, 0, 0}}});
  s.pen.line(along_wave(0, 1));
  EXPECT_EQ(s.pen.commits, 0);
  EXPECT_EQ(s.stroke(), before);
}

TEST(SmoothTool, ALineOfKilometresIsLeftAsItIs) {
  Smooth s;
  const double km = 1e6;
  s.fixture.add(testing::straight_stroke({0, 0}, {30 * km, 0}, 200, 1.0));
  const Stroke before = s.stroke();
  s.pen.line({{0, 0}, {km, 0}, {20 * km, 0}, {5, 0}});
  EXPECT_EQ(s.pen.commits, 0);
  EXPECT_EQ(s.stroke(), before);
}

TEST(SmoothTool, HoverShowsRingAndSpan) {
  Smooth s;
  s.fixture.add(straight_stroke({0, 0}, {100, 0}, 1, 2));
  s.pen.up({50, 3});
  const Overlay o = s.overlay();
  ASSERT_EQ(o.rings.size(), 1u);
  EXPECT_EQ(o.rings[0].radius_mm, 10.0);
  ASSERT_EQ(o.spans.size(), 1u);
  EXPECT_NEAR(o.spans[0].curve.p[0].x, 40.0, 1e-3);
  EXPECT_NEAR(o.spans[0].curve.p[3].x, 60.0, 1e-3);
}

/// Returns the mean friction on a pen that slides at 50 mm/s and is pressed with a given force.
double friction_n(const ForceModel& model, double push_n) {
  ForceMemory memory;
  Force last;
  for (int i = 0; i < 400; ++i) {
    memory.begin_tick(0.001);
    last = model(rig::pen_at({0.05 * i, 0, -push_n / 0.5}, {50, 0, 0}, 0.001 * i), memory);
  }
  return -last.x;
}

Fixture grainless() {
  Fixture fixture;
  fixture.surface.id = "smooth";
  fixture.surface.grain_um = 0.0;
  return fixture;
}

TEST(SmoothForce, FrictionTellsTheRoughnessAndIsTheSurfacesOnSmoothInk) {
  const Fixture fixture = grainless();
  for (const double push : {0.2, 0.5, 1.0, 2.0, 4.0}) {
    const double plain = friction_n(make_smooth_force(fixture.scene(), 0.0, 1.0), push);
    EXPECT_NEAR(plain, 0.25 * push, 1e-6);
    double last = plain;
    for (const double rough : {0.01, 0.05, 0.1, 0.2, 0.5, 2.0, 100.0}) {
      const double now = friction_n(make_smooth_force(fixture.scene(), rough, 1.0), push);
      EXPECT_GE(now, last - 1e-12);
      EXPECT_LE(now - plain, 0.4 + 1e-9);
      last = now;
    }
    EXPECT_GT(last, plain + 0.3 * std::min(push, 1.0));
    EXPECT_NEAR(friction_n(make_smooth_force(fixture.scene(), 1.0, 0.0), push), 0.0, 1e-12);
  }
}

TEST(SmoothForce, R41_IsCalmInEveryHandAndOnlyTakesEnergy) {
  for (const int delay : {0, 1}) {
    rig::for_each_grip(0.001, delay, [&](const rig::Setup& setup) {
      SCOPED_TRACE(setup.name());
      Fixture fixture = grainless();
      fixture.device = setup.capabilities();
      const double z = rig::aim_z_mm(setup.hand, 1.0, 500.0);
      rig::Bench bench(setup, make_smooth_force(fixture.scene(), 0.2, 1.0));
      int tick = 0;
      const auto aim = [&](double t) {
        return Vec3{t < 1.0 ? 0.0 : 8.0 * std::sin(6.0 * (t - 1.0)), 0.0,
                    t < 0.3 ? 2.0 + (z - 2.0) * t / 0.3 : z};
      };
      bench.run(0.6, aim);
      bench.begin_measuring();
      // The pen rests and rubs slowly, while the roughness falls as under the iron.
      bench.run(2.4, aim, [&](rig::Bench& b) {
        if (++tick % 12 == 0) {
          b.set_model(make_smooth_force(fixture.scene(), 0.2 * std::exp(-0.001 * tick), 1.0));
        }
      });
      EXPECT_LT(bench.figures().hf_n, 0.03);
      EXPECT_LE(bench.figures().energy_mj, 1.0);
    });
  }
}

TEST(SmoothForce, TheHandFeelsTheLineGetSmootherUnderTheSameFeel) {
  Smooth s;
  s.fixture.surface = grainless().surface;
  s.fixture.add(jittery(testing::wave(), {0.2, 4.0}, 1));
  s.pen.up(testing::wave()(0.3));
  const std::uint32_t id = s.tool.force(s.fixture.scene()).fade_id();
  s.pen.along(along_wave(0.3, 0.4, 100));
  const double first = friction_n(s.tool.force(s.fixture.scene()), 1.0);
  for (int i = 0; i < 8; ++i) s.pen.along(along_wave(0.4, 0.3, 100) + along_wave(0.3, 0.4, 100));
  const double last = friction_n(s.tool.force(s.fixture.scene()), 1.0);
  EXPECT_EQ(s.tool.force(s.fixture.scene()).fade_id(), id);
  EXPECT_GT(first, 0.35);
  EXPECT_LT(last, 0.32);
  s.pen.up({50, 50});
}

}  // namespace
}  // namespace felt::smooth_test
