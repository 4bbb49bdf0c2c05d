#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/geometry/nearest.h"
#include "felt/haptics/testing/feel_rig.h"
#include "felt/stroke/testing/stroke_probe.h"
#include "felt/tools/pull/pull_force.h"
#include "felt/tools/pull/pull_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::pull_test {
namespace {

using testing::distance_to;
using testing::Fixture;
using testing::Pen;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

struct Pull {
  Fixture fixture;
  PullTool tool;
  Pen pen{tool, fixture};
  StrokeId line = fixture.add(straight_stroke({20, 50}, {120, 50}, 1.0, 2.0));
  StrokeId other = fixture.add(straight_stroke({20, 90}, {120, 90}, 1.0, 1.0));

  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  void choose(std::string_view id, const char* value) { set(id, std::string(value)); }
  [[nodiscard]] StrokePtr stroke() const { return fixture.document.find(line); }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
  /// Returns the force at a point, with the pen at rest there.
  [[nodiscard]] Force force_at(Point p) const {
    ForceMemory memory;
    return tool.force(fixture.scene())(rig::pen_at({p.x, p.y, -1}), memory);
  }
};

TEST(Pull, OneGestureIsOneUndoStepThatRestoresTheBytes) {
  Pull p;
  const Document before = p.fixture.document;
  const StrokePtr was = p.stroke();
  const auto steps = p.fixture.history.undo_count();
  p.pen.line(way({70, 50}, {75, 62}));
  EXPECT_EQ(p.pen.commits, 1);
  EXPECT_EQ(p.fixture.history.undo_count(), steps + 1);
  EXPECT_EQ(p.fixture.history.undo_label(), "Pull");
  EXPECT_LE(distance_to(*p.stroke(), {75, 62}), 1e-9);
  const Document after = p.fixture.document;
  p.fixture.undo();
  EXPECT_EQ(p.fixture.document, before);
  EXPECT_EQ(p.stroke(), was);
  p.fixture.redo();
  EXPECT_EQ(p.fixture.document, after);
}

TEST(Pull, R21_WhatIsUnderThePenFollowsItInEverySample) {
  Pull p;
  p.pen.up({70, 53});
  p.pen.down({70, 53});  // 3 mm next to the line
  double worst = 0.0;
  for (const Point q : way({70, 53}, {80, 75}, 0.37)) {
    const ToolResult r = p.pen.at({q.x, q.y, -1});
    if (!r.preview || distance(q, {70, 53}) < 3.0) continue;
    ASSERT_EQ(r.preview->changes.size(), 1u);
    worst = std::max(worst, distance_to(*r.preview->changes[0].after, q));
  }
  EXPECT_LE(worst, 1e-9);
}

/// Measures the distance of a preview's curve from the pen, after a touch 5 mm next to the line.
struct BesideALine : Pull {
  explicit BesideALine(const char* mode) {
    choose("mode", mode);
    pen.up(touch);
    pen.down(touch);
  }
  [[nodiscard]] double gap_at(Point q) {
    const ToolResult r = pen.at({q.x, q.y, -1});
    return distance_to(r.preview ? *r.preview->changes[0].after : *stroke(), q);
  }
  static constexpr Point touch{70, 55};
};

TEST(Pull, R21_ALineTouchedFromBesideComesToThePenWithoutAJump) {
  for (const char* mode : {"brush", "grab"}) {
    SCOPED_TRACE(mode);
    BesideALine p(mode);
    EXPECT_NEAR(p.gap_at(p.touch), 5.0, 1e-9);
    double last = 5.0;
    for (double d = 0.05; d <= 60.0; d += 0.05) {
      const double gap = p.gap_at(p.touch + Vec{0.6 * d, 0.8 * d});
      EXPECT_LE(gap, last + 1e-9) << d;
      EXPECT_LE(last - gap, 1.5 * 0.05 * 1.01) << d;  // plus the part of the offset that S removes
      if (d >= 5.0) {
        EXPECT_LE(gap, 1e-9) << d;
      }
      last = gap;
    }
    // When the pen is back at the start, nothing has changed.
    EXPECT_NEAR(p.gap_at(p.touch), 5.0, 1e-9);
    p.pen.up(p.touch);
    EXPECT_EQ(p.pen.commits, 0);
  }
}

TEST(Pull, KeepsTheDistanceOfTheTouchIfAskedTo) {
  for (const char* mode : {"brush", "grab"}) {
    Pull p;
    p.choose("mode", mode);
    p.set("keep_offset", true);
    p.pen.line(way({70, 53}, {70, 75}));
    EXPECT_LE(distance_to(*p.stroke(), {70, 72}), 0.05) << mode;
  }
}

TEST(Pull, R20_FarFromEveryLineNothingHappens) {
  Pull p;
  const Document before = p.fixture.document;
  p.pen.up({70, 58.1});
  EXPECT_TRUE(p.overlay().spans.empty());
  p.pen.line(way({70, 58.1}, {70, 40}));
  EXPECT_EQ(p.pen.commits, 0);
  EXPECT_EQ(p.fixture.document, before);
  p.pen.down({70, 58.1});
  p.pen.down({70, 50});  // now the pen is on the line, unlike at the touch
  const Force force = p.force_at({70, 50});
  EXPECT_EQ(force.x, 0.0);
  EXPECT_EQ(force.y, 0.0);
  p.pen.up({70, 50});
  // The radius is an option.
  p.set("grab_radius_mm", 9.0);
  p.pen.line(way({70, 58.1}, {70, 40}));
  EXPECT_EQ(p.pen.commits, 1);
}

TEST(Pull, R23_BackHomeNothingIsCommittedAndRatesDoNotMatter) {
  Pull p;
  const Document before = p.fixture.document;
  p.pen.line(way({70, 50}, {90, 80}) + way({90, 80}, {60, 20}) + way({60, 20}, {70, 50}));
  EXPECT_EQ(p.pen.commits, 0);
  EXPECT_EQ(p.fixture.document, before);
  // The pen moves along the same path at 1 kHz and at 60 Hz.
  Pull quick, slow;
  const std::vector<Point> all = way({70, 50}, {90, 80}, 0.02);
  quick.pen.line(all);
  std::vector<Point> few;
  for (std::size_t i = 0; i < all.size(); i += 16) few.push_back(all[i]);
  few.push_back(all.back());
  slow.pen.step_ns = 16'666'667;
  slow.pen.line(few);
  EXPECT_EQ(*quick.stroke(), *slow.stroke());
}

TEST(Pull, CancelLeavesNothing) {
  Pull p;
  const Document before = p.fixture.document;
  p.pen.down({70, 50});
  p.pen.down({70, 60});
  p.tool.cancel();
  p.pen.up({70, 60});
  EXPECT_EQ(p.pen.commits, 0);
  EXPECT_EQ(p.fixture.document, before);
  EXPECT_EQ(norm(p.force_at({70, 60}) - p.force_at({0, 0})), 0.0);
}

TEST(Pull, OtherStrokesKeepTheirBytesAndLockedLayersAreLeftAlone) {
  Pull p;
  const StrokePtr other = p.fixture.document.find(p.other);
  p.pen.line(way({70, 50}, {70, 60}));
  EXPECT_EQ(p.fixture.document.find(p.other), other);
  const LayerId id = p.fixture.layer;
  LayerState locked = p.fixture.document.layer(id)->state();
  locked.locked = true;
  p.fixture.apply({"Lock", {}, {{id, p.fixture.document.layer(id)->state(), locked, 0, 0}}});
  const int commits = p.pen.commits;
  p.pen.line(way({70, 60}, {70, 70}));
  EXPECT_EQ(p.pen.commits, commits);
}

TEST(Pull, ShowsWhatItWillActOnBeforeTheTouch) {
  Pull p;
  p.pen.up({70, 52});
  Overlay o = p.overlay();
  ASSERT_EQ(o.rings.size(), 1u);
  EXPECT_EQ(o.rings[0].radius_mm, 20.0);
  EXPECT_LE(distance(o.rings[0].center, {70, 50}), 1e-9);
  ASSERT_EQ(o.spans.size(), 1u);
  EXPECT_NEAR(o.spans[0].curve.p[0].x, 50.0, 0.01);
  EXPECT_NEAR(o.spans[0].curve.p[3].x, 90.0, 0.01);
  EXPECT_EQ(o.dots.size(), 1u);
  p.pen.down({70, 52});
  p.pen.down({70, 62});
  o = p.overlay();
  ASSERT_EQ(o.lines.size(), 1u);
  EXPECT_EQ(o.lines[0].role, Overlay::Role::kVector);
  EXPECT_LE(distance(o.lines[0].from, {70, 50}), 1e-9);
  EXPECT_LE(distance(o.lines[0].to, {70, 62}), 1e-9);
  EXPECT_FALSE(o.spans.empty());
  EXPECT_EQ(o.rings.size(), 1u);
  p.tool.cancel();
}

TEST(Pull, R26_TheModifierFreesEndsAndCorners) {
  for (const bool is_option : {false, true}) {
    for (const bool is_pressed : {false, true}) {
      Pull p;
      p.set("free_ends", is_option);
      p.set("radius_mm", 60.0);
      const Point end = p.stroke()->data().points.front();
      PenSample s;
      s.buttons = is_pressed ? kFirstModifier : 0;
      for (int i = 0; i <= 20; ++i) {
        s.time_ns += 1'000'000;
        s.position = {40, 50.0 + 0.5 * i, -1};
        p.pen.give(s);
      }
      p.pen.now_ns = s.time_ns;
      p.pen.up({40, 60});
      const bool moved = p.stroke()->data().points.front() != end;
      EXPECT_EQ(moved, is_option != is_pressed);
    }
  }
}

TEST(Pull, EachModeMakesItsOwnGesture) {
  for (const std::string_view mode : kPullModes) {
    SCOPED_TRACE(mode);
    Pull p;
    p.choose("mode", std::string(mode).c_str());
    const StrokePtr was = p.stroke();
    p.pen.line(way({70, 47}, {70, 58}));
    EXPECT_EQ(p.pen.commits, 1);
    EXPECT_NE(p.stroke(), was);
    EXPECT_TRUE(check_invariants(p.stroke()->data()));
    p.fixture.undo();
    EXPECT_EQ(p.stroke(), was);
  }
}

TEST(PullForce, R29_PointsBackAndGrowsFromAFifthToOneNewton) {
  Pull p;
  p.set("yield_s", 0.0);
  p.pen.down({70, 50});
  double before = 0.0;
  for (int i = 0; i <= 10'000; ++i) {
    const double d = 1e-6 * std::pow(1e10, i / 10'000.0);
    const Force f = p.force_at({70 + 0.6 * d, 50 + 0.8 * d});
    const double along = f.x * 0.6 + f.y * 0.8;
    EXPECT_LT(along, 0.0);
    EXPECT_NEAR(f.x * 0.8 - f.y * 0.6, 0.0, 1e-9);
    if (d >= 0.667) {
      EXPECT_GE(-along, 0.2 - 1e-6);
    }
    EXPECT_LT(-along, 1.0);
    EXPECT_GT(-along, before);
    before = -along;
  }
  EXPECT_EQ(p.force_at({70, 50}).x, 0.0);
  EXPECT_EQ(p.force_at({70, 50}).y, 0.0);
  // Moving the pen does not change the fade_id, so that nothing is cross-faded.
  const auto id = p.tool.force(p.fixture.scene()).fade_id();
  p.pen.down({80, 70});
  EXPECT_EQ(p.tool.force(p.fixture.scene()).fade_id(), id);
  p.pen.up({80, 70});
  EXPECT_NE(p.tool.force(p.fixture.scene()).fade_id(), id);
}

TEST(PullForce, R29_StrengthScalesItAndItsSlopeIsBounded) {
  Pull p;
  p.set("yield_s", 0.0);
  p.pen.down({70, 50});
  const double whole = -p.force_at({80, 50}).x;
  for (double d = 0.0; d < 40.0; d += 0.01) {
    const double slope = (p.force_at({70 + d, 50}).x - p.force_at({70 + d + 0.01, 50}).x) / 0.01;
    EXPECT_LE(slope, 0.3 * (1 + 1e-9));  // N/mm
  }
  p.pen.up({70, 50});
  p.set("strength", 0.5);
  p.pen.down({70, 50});
  EXPECT_NEAR(-p.force_at({80, 50}).x, 0.5 * whole, 1e-12);
  p.pen.up({70, 50});
  p.set("strength", 0.0);
  p.pen.down({70, 50});
  EXPECT_EQ(p.force_at({80, 50}).x, 0.0);
}

/// The force model of a pull that grabbed at (0, 0), for a device.
ForceModel held(const rig::Setup& setup, double yield_s = 0.0) {
  Fixture fixture;
  fixture.device = setup.capabilities();
  PullSettings settings;
  settings.yield_s = yield_s;
  return make_pull_force(settings, fixture.scene(), {.kind = PullFeel::Kind::kSpring});
}

TEST(PullForce, R73_TheForceOfAPullEndsWhenThePenRests) {
  for (const char* mode : {"brush", "grab", "bulge", "pinch"}) {
    for (const bool is_paper : {false, true}) {
      Pull p;
      p.choose("mode", mode);
      ForceMemory memory;
      double time_s = 1.0, moving_n = 0.0;
      const auto edit_n = [&](Point at) {
        p.pen.down(at);
        Scene scene = p.fixture.scene();
        if (is_paper) scene.law = LawForm::kPaper;
        const ForceModel model = p.tool.force(scene);
        memory.begin_tick(0.001);
        (void)model(rig::pen_at({at.x, at.y, -1}, {}, time_s += 0.001), memory);
        double n = 0.0;
        for (const auto& term : memory.terms) {
          if (std::string_view(term.name) == "edit") n = norm(term.force);
        }
        return n;
      };
      for (int i = 0; i <= 200; ++i) moving_n = edit_n({70, 50 + 0.05 * i});
      double resting_n = 0.0;
      for (int i = 0; i <= 100; ++i) resting_n = edit_n({70, 60});
      if (is_paper) {
        EXPECT_DOUBLE_EQ(moving_n, kEditLaw.level_n(10.0)) << mode;
        EXPECT_DOUBLE_EQ(resting_n, kEditLaw.level_n(10.0)) << mode;
      } else {
        EXPECT_GT(moving_n, 0.08) << mode;
        EXPECT_LT(resting_n, 1e-4) << mode;
      }
    }
  }
}

TEST(PullForce, R30_IsCalmAndGivesNoEnergy) {
  double worst = 0.0, max_energy = -1e9;
  for (int i = 0; i < 4; ++i) {
    const double yield_s = i < 2 ? 0.0 : 0.01;
    rig::for_each_grip(0.001, i % 2, [&](const rig::Setup& setup) {
      rig::Bench bench(setup, held(setup, yield_s), {0, 0, 1});
      const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
      const auto target = [&](double t) -> Vec3 {
        const double x = std::min(t / 0.4, 1.0), s = std::max(0.0, t - 0.7);
        return {12 * std::sin(kTau * s), 5 * std::sin(2 * kTau * s), 1 + (aim - 1) * x};
      };
      bench.run(1.7, target);
      bench.begin_measuring();
      bench.run(1.0, target);
      worst = std::max(worst, bench.figures().hf_n);
      max_energy = std::max(max_energy, bench.figures().energy_mj);
      EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name();
      EXPECT_LE(bench.figures().energy_mj, 1.0) << setup.name();
      EXPECT_LT(bench.figures().max_size_n, 8.0);
    });
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
  RecordProperty("most_energy_mj", std::to_string(max_energy));
}

TEST(PullForce, R30_DependsOnTheTotalDisplacementAlone) {
  // This holds for any path and any sample rate.
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    rig::Setup setup;
    setup.period_s = period_s;
    const ForceModel model = held(setup);
    ForceMemory memory;
    const auto ticks = std::llround(0.5 / period_s);
    Force force;
    for (std::int64_t i = 0; i <= ticks; ++i) {
      memory.begin_tick(period_s);
      const double t = static_cast<double>(i) / static_cast<double>(ticks);
      // The pen is above the surface, so that friction does not make the force depend on the path.
      force = model(rig::pen_at({9 * t, 30 * std::sin(kTau * t), 0.1}), memory);
    }
    EXPECT_NEAR(force.x, -kEditLaw.force_n(9.0), 1e-9);
    EXPECT_NEAR(force.y, 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace felt::pull_test
