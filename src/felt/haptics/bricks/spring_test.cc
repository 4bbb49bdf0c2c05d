#include "felt/haptics/bricks/spring.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::spring_test {
namespace {

RC_GTEST_PROP(EditSpring, R29_PointsBackAndKeepsToItsBounds, ()) {
  const Point origin{0.1 * *rc::gen::inRange(-999, 999), 0.1 * *rc::gen::inRange(-999, 999)};
  const Vec away{1e-3 * *rc::gen::inRange(-99'999, 99'999), 1e-3 * *rc::gen::inRange(-999, 999)};
  RC_PRE(norm(away) > 0.0);
  const Point pen = origin + away;
  ForceMemory memory;
  const Force force = EditSpring(origin)(rig::pen_at({pen.x, pen.y, -1}), memory);
  const Vec v = pen - origin;
  RC_ASSERT(dot(force, {v.x, v.y, 0}) < 0.0);
  RC_ASSERT(norm(force) < 1.0);
  if (norm(v) >= 0.667) RC_ASSERT(norm(force) >= 0.2 - 1e-12);
  RC_ASSERT(force.z == 0.0);
}

TEST(EditSpring, R29_NothingWhereItBegan) {
  ForceMemory memory;
  EXPECT_EQ(EditSpring({3, 4})(rig::pen_at({3, 4, -1}), memory), Force{});
  EXPECT_EQ(norm(EditSpring({3, 4})(rig::pen_at({3 + 1e-300, 4, -1}), memory)), 0.0);
}

TEST(EditSpring, R29_TheSlopeInTwoDimensionsIsBoundedToo) {
  const EditSpring spring({0, 0});
  for (int i = 0; i < 20'000; ++i) {
    const double r = 0.01 * (i % 400);
    const double angle = 0.7 * i;
    const double h = 1e-4;
    ForceMemory memory;
    const Vec3 p{r * std::cos(angle), r * std::sin(angle), -1};
    const Vec3 q{p.x + h * std::cos(3.1 * i), p.y + h * std::sin(3.1 * i), -1};
    const Force change = spring(rig::pen_at(q), memory) - spring(rig::pen_at(p), memory);
    ASSERT_LE(norm(change), 0.3 * h * (1 + 1e-9));
  }
}

/// Expects surface and spring to be calm at rest, in slow and fast loops.
template <class Make>
void expect_calm(const Make& make, double& worst) {
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {  // R30 asks for up to 1
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        for (const double mm : {0.0, 12.0}) {
          rig::Bench bench(setup, ForceModel(make(setup)), {0, 0, 1});
          const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
          const auto target = [&](double time) -> Vec3 {
            const double x = std::min(time / 0.4, 1.0);
            const double t = std::max(0.0, time - 0.7);
            return {mm * std::sin(kTau * t), 0.4 * mm * std::sin(1.5 * kTau * t),
                    1 + (aim - 1) * x * x * (3 - 2 * x)};
          };
          bench.run(0.8, target);
          bench.begin_measuring();
          bench.run(1.0, target);
          const double hf = bench.figures().hf_n;
          EXPECT_LT(hf, 0.03) << setup.name() << ", " << mm << " mm";
          worst = std::max(worst, hf);
        }
      });
    }
  }
}

SurfaceForce pencil_on_paper(const rig::Setup& setup) {
  return make_surface_force(surface_materials()[0], media()[0], setup.capabilities());
}

TEST(EditSpring, R30_IsCalmOnTheSurface) {
  double worst = 0.0;
  expect_calm(
      [](const rig::Setup& s) {
        return Compose(pencil_on_paper(s), EditSpring({-3, 1}));
      },
      worst);
  RecordProperty("worst_hf_n", std::to_string(worst));
}

/// A straight line across y that yields to a pen as in a sweep, published every 4 ms.
class GivingLine {
 public:
  static constexpr double kTauS = 0.050;

  /// Returns the curve to publish at this sample.
  CurveNear at(const PenSample& pen) {
    const Point now = on_page(pen.position);
    if (!is_set_) near_ = {.pen = now, .curve = {now.x, now.y}, .normal = {0, 1}};
    is_set_ = true;
    const double passed = 1e-9 * static_cast<double>(pen.time_ns - near_.time_ns);
    if (passed >= 0.004) {
      // Integrates in steps that are short compared to tau.
      double y = near_.curve.y;
      for (int k = 1; k <= 40; ++k) {
        const double there = lerp(near_.pen, now, (k - 0.5) / 40.0).y;
        y += (1.0 - std::exp(-passed / 40.0 / kTauS)) * (there - y);
      }
      near_.curve = {now.x, y};
      near_.pen = now;
      near_.time_ns = pen.time_ns;
    }
    return near_;
  }
  Force operator()(const PenSample& pen, ForceMemory& memory) {
    return SweepSpring(at(pen), options, kTauS)(pen, memory);
  }

  EditOptions options;

 private:
  CurveNear near_;
  bool is_set_ = false;
};

TEST(SweepSpring, R29_IsTheLawOfTheDistanceToTheCurve) {
  for (const double mm : {0.0, 0.3, 6.0, 40.0}) {
    const CurveNear curve{.pen = {5, mm}, .curve = {5, 0}, .normal = {0, -1}};
    ForceMemory memory;
    const Force force = SweepSpring(curve)(rig::pen_at({5, mm, -1}), memory);
    EXPECT_NEAR(force.y, -kEditLaw.force_n(mm), 1e-12);
    EXPECT_EQ(force.x, 0.0);
  }
  // Along the curve there is no force, not even from the damper, until the tool publishes another
  // curve.
  ForceMemory memory;
  EXPECT_EQ(norm(SweepSpring({.normal = {0, 1}})(rig::pen_at({9, 0, -1}, {300, 0, 0}), memory)),
            0.0);
  // Near an end it pulls from any direction.
  const CurveNear end{.pen = {3, 4}, .curve = {0, 0}, .is_end = true};
  const Force force = SweepSpring(end)(rig::pen_at({3, 4, -1}), memory);
  EXPECT_NEAR(force.x, -0.6 * kEditLaw.force_n(5.0), 1e-12);
  EXPECT_NEAR(force.y, -0.8 * kEditLaw.force_n(5.0), 1e-12);
}

TEST(SweepSpring, R30_IsCalmOnTheSurface) {
  double worst = 0.0;
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        const SurfaceForce surface = pencil_on_paper(setup);
        GivingLine line;
        const auto model = [&](const PenSample& pen) {
          return ForceModel(Compose(surface, SweepSpring(line.at(pen))));
        };
        rig::Bench bench(setup, model(rig::pen_at({0, 0, 1})), {0, 0, 1});
        const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
        const auto target = [&](double time) -> Vec3 {
          const double x = std::min(time / 0.4, 1.0);
          const double t = std::max(0.0, time - 0.7);
          return {12 * std::sin(kTau * t), 5 * std::sin(1.5 * kTau * t),
                  1 + (aim - 1) * x * x * (3 - 2 * x)};
        };
        const auto publish = [&](rig::Bench& b) { b.set_model(model(b.sample())); };
        bench.run(0.8, target, publish);
        bench.begin_measuring();
        bench.run(1.0, target, publish);
        const double hf = bench.figures().hf_n;
        EXPECT_LT(hf, 0.03) << setup.name();
        worst = std::max(worst, hf);
      });
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

/// Returns the mean force of a sweep on a pen that moves back and forth freely for 1.2 s.
double mean_sweep_force(double period_s) {
  GivingLine line;
  ForceMemory memory;
  VelocityFilter filter;
  double sum = 0.0;
  const auto ticks = std::llround(1.2 / period_s);
  for (std::int64_t i = 0; i < ticks; ++i) {
    const double t = static_cast<double>(i) * period_s;
    PenSample sample =
        rig::pen_at({30 * std::sin(kTau * t / 1.2), 8 * std::sin(kTau * t / 0.6), -1}, {}, t);
    sample.velocity = filter.update(sample.position, period_s);
    memory.begin_tick(period_s);
    sum += norm(line(sample, memory));
  }
  return sum / static_cast<double>(ticks);
}

TEST(SweepSpring, R30_R50_TheMeanForceDoesNotDependOnTheRate) {
  const double at_1_khz = mean_sweep_force(0.001);
  EXPECT_GT(at_1_khz, 0.2);
  for (const double period_s : {0.0002, 0.0005, 0.002, 0.004}) {
    EXPECT_NEAR(mean_sweep_force(period_s) / at_1_khz, 1.0, 0.05) << period_s;
    RecordProperty("mean_n_at_us_" + std::to_string(std::lround(1e6 * period_s)),
                   std::to_string(mean_sweep_force(period_s)));
  }
}

TEST(SweepSpring, R30_LagsBySpeedTimesTauAndComesToRest) {
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    GivingLine line;
    line.options.damping_n_s_per_m = 0.0;
    ForceMemory memory;
    Force force;
    const auto pen = [&](int i, double y) { return rig::pen_at({0, y, -1}, {}, i * period_s); };
    const int n = static_cast<int>(std::lround(1.0 / period_s));
    for (int i = 0; i <= n; ++i) force = line(pen(i, 100.0 * i * period_s), memory);
    EXPECT_NEAR(-force.y, kEditLaw.force_n(5.0), 0.002);  // 100 mm/s x 50 ms
    const int later = n + static_cast<int>(std::lround(0.1 / period_s));
    for (int i = n + 1; i <= later; ++i) force = line(pen(i, 100.0), memory);
    EXPECT_NEAR(-force.y, kEditLaw.force_n(5.0 * std::exp(-0.1 / 0.050)), 0.01);
  }
}

TEST(PushSpring, R29_HoldsAtTheLawOfTheDisplacementAndLetsGoOfTheNib) {
  ForceMemory memory;
  for (const double d : {0.1, 0.5, 2.0, 6.0, 30.0}) {
    const LineUnderNib line{.pen = {7, 3}, .normal = {0, 1}, .displacement_mm = d};
    const auto at = [&](double y) { return PushSpring(line)(rig::pen_at({7, y, -1}), memory).y; };
    EXPECT_NEAR(at(3.0), kEditLaw.force_n(d), 1e-12);        // rests against the line
    EXPECT_NEAR(at(2.0), kEditLaw.force_n(d + 1.0), 1e-12);  // pushes it farther
    double last = at(0.0);
    for (double y = 0.0; y < 9.0; y += 0.01) {
      EXPECT_LE(at(y), last + 1e-12);
      EXPECT_LE(last - at(y), 0.3 * 0.01 * (1 + 1e-9));
      EXPECT_GE(at(y), 0.0);
      last = at(y);
    }
    EXPECT_EQ(at(3.0 + 1e3 * kEditLaw.force_n(d) / 300.0 + 1e-9), 0.0);
  }
  // No line is near, or the line has not been pushed yet.
  EXPECT_EQ(norm(PushSpring({})(rig::pen_at({1, 1, -1}, {50, 50, 0}), memory)), 0.0);
  EXPECT_EQ(norm(PushSpring({.normal = {0, 1}})(rig::pen_at({0, 0, -1}, {0, -90, 0}), memory)),
            0.0);
}

/// Returns the work of the force on the pen over one closed cycle of free motion, mJ. The force of
/// a tick acts during the next tick, as on a device.
template <class Brick>
double energy_of_cycle(Brick brick, double period_s, int delay) {
  ForceMemory memory;
  VelocityFilter filter;
  std::vector<Force> late(static_cast<std::size_t>(delay) + 1);
  double energy = 0.0;
  const auto ticks = std::llround(1.0 / period_s);
  const auto at = [&](std::int64_t i) -> Vec3 {
    const double t = static_cast<double>(i) * period_s;
    return {15 * std::sin(kTau * t), 6 * std::sin(2 * kTau * t), -1};
  };
  for (std::int64_t i = 0; i < 3 * ticks; ++i) {
    if (i == 2 * ticks) energy = 0.0;  // measures the third cycle only
    PenSample sample = rig::pen_at(at(i), {}, static_cast<double>(i) * period_s);
    sample.velocity = filter.update(sample.position, period_s);
    memory.begin_tick(period_s);
    late[static_cast<std::size_t>(i) % late.size()] = brick(sample, memory);
    const Force acting = late[static_cast<std::size_t>(i + 1) % late.size()];
    energy += work_mj(acting, at(i + 1) - at(i));
  }
  return energy;
}

TEST(Springs, R30_ReturnNoEnergyOverAClosedCycle) {
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    for (int delay = 0; delay <= 2; ++delay) {
      const double edit = energy_of_cycle(EditSpring({1, 1}), period_s, delay);
      const double sweep = energy_of_cycle(GivingLine{}, period_s, delay);
      EXPECT_LE(edit, 1.0) << period_s << " " << delay;
      EXPECT_LE(sweep, 0.0) << period_s << " " << delay;
    }
  }
}

TEST(Springs, R30_R56_ASmallerShareOfTheBudgetLeavesTheLevelOfTheLaw) {
  ForceMemory memory;
  memory.scale.lateral = 0.75;
  for (double d = 0.01; d < 60.0; d *= 1.1) {
    const double n = -EditSpring({0, 0})(rig::pen_at({d, 0, -1}), memory).x;
    EXPECT_DOUBLE_EQ(n, std::min(kEditLaw.level_n(d), 0.225 * d));
  }
}

TEST(Springs, R30_GiveAHandOnTheSurfaceNoEnergy) {
  for (int delay = 0; delay <= 1; ++delay) {
    rig::for_each_grip(0.001, delay, [&](const rig::Setup& setup) {
      rig::Bench bench(setup, ForceModel(Compose(pencil_on_paper(setup), EditSpring({0, 0}))),
                       {0, 0, 0});
      const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
      const auto target = [&](double t) -> Vec3 {
        return {15 * std::sin(kTau * t), 6 * std::sin(2 * kTau * t), aim};
      };
      bench.run(2.0, target);
      bench.begin_measuring();
      bench.run(2.0, target);
      EXPECT_LE(bench.figures().energy_mj, 1.0) << setup.name();
    });
  }
}

}  // namespace
}  // namespace felt::spring_test
