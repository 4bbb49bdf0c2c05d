#include "felt/haptics/bricks/solid_surface.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/geometry/testing/ball.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::solid_surface_test {
namespace {

constexpr double kTop_mm = 20.0;

// A ball of 20 mm, whose fronts are 20 mm above the page, with facets of about 0.6 mm.
const TriangleTree& ball() {
  static const TriangleTree tree(testing::ball({}, {kTop_mm, kTop_mm, kTop_mm}, 200, 100));
  return tree;
}
// A flat top, 60 mm wide, at a height.
TriangleTree plate(double z) {
  const std::vector<Triangle3> two{{{-30, -30, z}, {30, -30, z}, {30, 30, z}},
                                   {{-30, -30, z}, {30, 30, z}, {-30, 30, z}}};
  return TriangleTree(two);
}

SolidSurfaceOptions options_without_damping(double mu = 0.0, std::uint32_t number = 1) {
  return {.plane = {.stiffness_n_per_m = 500.0, .damping_n_s_per_m = 0.0},
          .friction = {.coefficient = mu, .stiffness_n_per_m = 500.0, .damping_n_s_per_m = 0.0},
          .max_force_n = 3.0,
          .number = number};
}

Force feel(const SolidSurface& surface, ForceMemory& memory, const Vec3& pen) {
  memory.begin_tick(0.001);
  return surface(rig::pen_at(pen), memory);
}
// Moves the pen in a straight line with 0.1 mm a tick and returns the last force.
Force feel_along(const SolidSurface& surface, ForceMemory& memory, const Vec3& from,
                 const Vec3& to) {
  Force force;
  const int ticks = 1 + static_cast<int>(norm(to - from) / 0.1);
  for (int i = 0; i <= ticks; ++i) force = feel(surface, memory, lerp(from, to, 1.0 * i / ticks));
  return force;
}
Vec3 vec(const Force& f) {
  return {f.x, f.y, f.z};
}

TEST(SolidSurface, R11_PushesOutOfTheBodyInProportionToTheDepth) {
  for (const Vec3& out :
       {Vec3{0, 0, 1}, Vec3{0.6, 0, 0.8}, Vec3{-0.48, 0.6, 0.64}, Vec3{0, 1, 0}}) {
    const SolidSurface surface(ball(), options_without_damping());
    ForceMemory memory;
    const Force force = feel_along(surface, memory, (kTop_mm + 3.0) * out, (kTop_mm - 2.0) * out);
    EXPECT_NEAR(norm(force), 0.5 * 2.0, 0.01);
    EXPECT_NEAR(dot(vec(force), out) / norm(force), 1.0, 1e-3) << "across the surface";
    EXPECT_DOUBLE_EQ(memory.normal_force_n, memory.spring_force_n);
    EXPECT_NEAR(memory.normal_force_n, norm(force), 1e-9);
  }
}

TEST(SolidSurface, R49_NeverExceedsTheForceOfTheDevice) {
  const SolidSurface surface(ball(), options_without_damping());
  ForceMemory memory;
  EXPECT_NEAR(norm(feel_along(surface, memory, {0, 0, 23}, {0, 0, 5})), 3.0, 1e-9);
}

TEST(SolidSurface, R11_BrakesAPenThatGoesInAndNeverPullsOneThatGoesOut) {
  SolidSurfaceOptions options = options_without_damping();
  options.plane.damping_n_s_per_m = 2.0;
  const SolidSurface surface(ball(), options);
  const auto at_19_mm = [&](double from_mm, double mm_per_tick) {
    ForceMemory memory;
    feel_along(surface, memory, {0, 0, 21}, {0, 0, from_mm});
    Force force;
    for (int i = 0; i < 20; ++i) feel(surface, memory, {0, 0, from_mm});
    const int ticks = static_cast<int>(std::lround((19.0 - from_mm) / mm_per_tick));
    for (int i = 1; i <= ticks; ++i)
      force = feel(surface, memory, {0, 0, from_mm + mm_per_tick * i});
    return force;
  };
  EXPECT_NEAR(at_19_mm(21, -0.1).z, 0.5 + 0.2, 0.01);
  EXPECT_NEAR(at_19_mm(17, 0.1).z, 0.5 - 0.2, 0.01);
  EXPECT_EQ(at_19_mm(17, 0.4), Force{});
}

// A pen that goes into a plate at 200 mm/s, and a loop and a device at 1 kHz.
struct FallingPen {
  const TriangleTree body = plate(0.0);
  SolidSurfaceOptions options = options_without_damping();
  ForceMemory memory;

  FallingPen() { options.plane.damping_n_s_per_m = 2.0; }
  // The force at a tick of `dt_s` with the sample of `at_ms`.
  double force_at(int at_ms, double dt_s = 0.001) {
    memory.begin_tick(dt_s);
    const PenSample sample = rig::pen_at({0, 0, 4.0 - 0.2 * at_ms}, {}, 0.001 * at_ms);
    return SolidSurface(body, options)(sample, memory).z;
  }
  // The part of the damper, 0.4 N when steady.
  [[nodiscard]] double brake_n() const { return memory.normal_force_n - memory.spring_force_n; }
};

TEST(SolidSurface, R11_R12_TheBrakeStaysWhileTheDeviceRepeatsItsSample) {
  FallingPen pen;
  for (int ms = 0; ms <= 22; ++ms) pen.force_at(ms);
  ASSERT_NEAR(pen.brake_n(), 0.4, 0.01);
  const double steady_n = pen.force_at(22);
  for (int i = 0; i < 10; ++i) {
    EXPECT_NEAR(pen.force_at(22), steady_n, 1e-9) << i;
    EXPECT_NEAR(pen.brake_n(), 0.4, 0.01) << i;
  }
  pen.force_at(33);
  EXPECT_NEAR(pen.brake_n(), 0.4, 0.01) << "11 ms of motion are not that of one tick";
  for (int i = 0; i < 21; ++i) pen.force_at(33);
  EXPECT_EQ(pen.brake_n(), 0.0) << "nobody knows the speed any more";
  EXPECT_GT(pen.memory.spring_force_n, 1.0);
}

TEST(SolidSurface, R11_R12_AStallOfTheLoopIsNoSpeed) {
  FallingPen pen;
  for (int ms = 0; ms <= 22; ++ms) pen.force_at(ms);
  pen.force_at(37, 0.005);  // the loop clamps 15 ms to 5 ms
  EXPECT_NEAR(pen.brake_n(), 0.4, 0.01);
  for (int i = 0; i < 300; ++i) {
    pen.memory.begin_tick(0.001);
    const auto rest = rig::pen_at({0, 0, -3.4}, {}, 0.038 + 0.001 * i);
    SolidSurface(pen.body, pen.options)(rest, pen.memory);
  }
  EXPECT_NEAR(pen.brake_n(), 0.0, 1e-6) << "new samples at the same place are a pen at rest";
}

TEST(SolidSurface, R11_R12_TheSpeedBeginsAnewAfterAGap) {
  FallingPen pen;
  pen.memory.begin_tick(0.001);
  SolidSurface(pen.body, pen.options)(rig::pen_at({0, 0, 30}, {}, -1.0), pen.memory);
  EXPECT_EQ(pen.force_at(19), 0.0) << "above the surface";
  pen.force_at(21);
  EXPECT_GT(pen.memory.spring_force_n, 0.09);
  EXPECT_LT(pen.brake_n(), 0.3) << "30 mm in a second are not 30 mm in a tick";
}

TEST(SolidSurface, R13_SlidesWithTheFrictionOfThePlane) {
  const TriangleTree body = plate(0.0);
  for (const double bristle : {300.0, 500.0, 900.0}) {
    SolidSurfaceOptions options = options_without_damping(0.4);
    options.friction.stiffness_n_per_m = bristle;
    const SolidSurface surface(body, options);
    ForceMemory memory;
    const Force force = feel_along(surface, memory, {0, 0, -1}, {0, 0, -1});
    EXPECT_EQ(force, Force{}) << "the pen began below the plate";
    feel_along(surface, memory, {0, 0, 1}, {0, 0, -2});
    const Force sticks = feel_along(surface, memory, {0, 0, -2}, {0.1, 0, -2});
    EXPECT_NEAR(sticks.x, -1e-3 * bristle * 0.1, 1e-3);
    const Force slides = feel_along(surface, memory, {0.1, 0, -2}, {10, 0, -2});
    EXPECT_NEAR(slides.x, -0.4 * slides.z, 1e-3);
    EXPECT_NEAR(slides.z, 1.0, 1e-3);
  }
}

TEST(SolidSurface, R12_BeginsWhenThePenHasBeenInFrontOfTheBody) {
  const SolidSurface surface(ball(), options_without_damping());
  for (const Vec3& inside : {Vec3{0, 0, 0}, Vec3{5, -5, 12}, Vec3{0, 0, -25}}) {
    ForceMemory memory;
    for (int i = 0; i < 100; ++i) EXPECT_EQ(feel(surface, memory, inside), Force{}) << inside.z;
    EXPECT_EQ(feel_along(surface, memory, inside, {0, 0, 19.9}), Force{});
    feel_along(surface, memory, {0, 0, 19.9}, {0, 0, 21});
    EXPECT_GT(feel_along(surface, memory, {0, 0, 21}, {0, 0, 19}).z, 0.45);
  }
}

TEST(SolidSurface, EndsWithAGapInTheSamples) {
  const SolidSurface surface(ball(), options_without_damping());
  ForceMemory memory;
  feel_along(surface, memory, {0, 0, 30}, {0, 0, 21});
  for (int i = 0; i < 100; ++i) EXPECT_EQ(feel(surface, memory, {0, 0, -21}), Force{});
  feel_along(surface, memory, {25, 0, -21}, {25, 0, 21});
  feel_along(surface, memory, {25, 0, 21}, {0, 0, 21});
  EXPECT_GT(feel_along(surface, memory, {0, 0, 21}, {0, 0, 19}).z, 0.45);
  EXPECT_EQ(feel(surface, memory, {0, 0, 14}), Force{}) << "while it touches";
  feel_along(surface, memory, {0, 0, 14}, {0, 0, 21});
  EXPECT_GT(feel_along(surface, memory, {0, 0, 21}, {0, 0, 19}).z, 0.45);
  memory.begin_tick(0.001);
  EXPECT_EQ(surface(rig::pen_at({0, 0, 19}, {}, 0.021), memory), Force{}) << "another force was on";
}

TEST(SolidSurface, FollowsABodyThatChangesALittle) {
  const auto after_change = [](double rise_mm) {
    const TriangleTree before = plate(0.0), after = plate(rise_mm);
    ForceMemory memory;
    feel_along(SolidSurface(before, options_without_damping()), memory, {0, 0, 1}, {0, 0, -1});
    return feel(SolidSurface(after, options_without_damping(0.0, 2)), memory, {0, 0, -1}).z;
  };
  EXPECT_NEAR(after_change(0.0), 0.5, 1e-3);
  EXPECT_NEAR(after_change(0.9), 0.5 * 1.9, 1e-3) << "lifted";
  EXPECT_NEAR(after_change(-0.4), 0.5 * 0.6, 1e-3);
  EXPECT_EQ(after_change(1.1), 0.0) << "too far";
  EXPECT_EQ(after_change(-2.0), 0.0) << "the pen is above it now";
}

TEST(SolidSurface, R55_R56_UsesTheShareOfTheBudgetAndTheCapOfTheDevice) {
  const SolidSurface surface(ball(), options_without_damping());
  ForceMemory memory;
  memory.scale = {.normal = 0.5, .friction = 1.0, .lateral = 0.8};
  EXPECT_NEAR(feel_along(surface, memory, {0, 0, 21}, {0, 0, 19}).z, 0.25, 0.01);
  memory.scale = {};
  memory.material_cap_n_per_m = 100.0;
  EXPECT_NEAR(feel(surface, memory, {0, 0, 19}).z, 0.1, 0.01);
  const Slopes slopes = surface.slopes();
  EXPECT_EQ(slopes.normal_n_per_m, 500.0);
  EXPECT_EQ(slopes.lateral_n_per_m + slopes.friction_n_per_m, 500.0);
}

// No speed and no force carries the pen through, and the pen feels the way back.
TEST(SolidSurface, LetsNothingFallThroughWithTheForceOn) {
  for (const double mu : {0.0, 0.3, 0.9}) {
    Random random(7);
    const SolidSurface surface(ball(), options_without_damping(mu));
    ForceMemory memory;
    Vec3 pen{0, 0, 25}, heading{0, 0, -1};
    int touching = 0;
    for (int i = 0; i < 100'000; ++i) {
      heading += 0.15 * Vec3{random.normal(), random.normal(), random.normal()};
      heading = (1.0 / norm(heading)) * heading;
      const Vec3 next = pen + 0.5 * heading;  // 0.5 m/s
      if (norm(next) > 28.0) {
        heading = -1.0 * heading;
      } else {
        pen = next;
      }
      const Force force = feel(surface, memory, pen);
      if (!memory.solid.is_outside) continue;
      // The middle of a facet is up to 0.01 mm nearer than its corners.
      ASSERT_GE(norm(memory.solid.proxy.place()), kTop_mm - 0.02) << i;
      ASSERT_LE(norm(force), 3.0 * std::sqrt(1.0 + mu * mu) + 1e-9);
      touching += force != Force{} ? 1 : 0;
    }
    EXPECT_GT(touching, 20'000);
  }
}

// On any closed path of a pen that is moved at will, the spring gives back at most what it got. The
// force between two ticks is that of the first one.
RC_GTEST_PROP(SolidSurface, R12_IsPassiveOnAnyClosedPath, (std::uint64_t seed)) {
  Random random(seed);
  SolidSurfaceOptions options = options_without_damping(random.between(0.0, 0.8));
  options.plane.damping_n_s_per_m = 2.0;
  options.friction.damping_n_s_per_m = 2.0;
  const SolidSurface surface(ball(), options);
  ForceMemory memory;
  Vec3 pen{0, 0, 24};
  double work = 0.0;
  Force held = feel(surface, memory, pen);
  const auto move = [&](const Vec3& to, double mm_per_s) {
    const Vec3 step = (1e-3 * mm_per_s / norm(to - pen)) * (to - pen);
    for (int i = static_cast<int>(norm(to - pen) / norm(step)); i >= 0; --i) {
      const Vec3 next = i == 0 ? to : pen + step;
      work += work_mj(held, next - pen);
      pen = next;
      held = feel(surface, memory, pen);
    }
  };
  for (int i = 0; i < 20; ++i) {
    const double depth = random.between(-3.0, 3.0), a = random.between(0, kTau);
    const double tilt = random.between(0.0, 1.2);
    const Vec3 out{std::sin(tilt) * std::cos(a), std::sin(tilt) * std::sin(a), std::cos(tilt)};
    move((kTop_mm - depth) * out, random.between(5.0, 100.0));
  }
  move(1.3 * pen, 50.0);
  RC_ASSERT(work <= 0.05);
}

RC_GTEST_PROP(SolidSurface, R49_IsFiniteAndBoundedWhateverTheSamplesSay, (std::uint64_t seed)) {
  Random random(seed);
  SolidSurfaceOptions options = options_without_damping(random.between(0.0, 1.5));
  options.plane.damping_n_s_per_m = random.between(0.0, 5.0);
  options.friction.damping_n_s_per_m = random.between(0.0, 5.0);
  ForceMemory memory;
  const auto number = [&random] {
    const double kind = random.between(0.0, 20.0);
    if (kind < 1.0) return std::nan("");
    if (kind < 2.0) return kind < 1.5 ? 1e308 : -HUGE_VAL;
    return kind < 6.0 ? random.between(-1e4, 1e4) : random.between(-22.0, 22.0);
  };
  Vec3 pen{0, 0, 22};
  for (int i = 0; i < 300; ++i) {
    options.number = 1 + static_cast<std::uint32_t>(i / 50);
    const SolidSurface surface(ball(), options);
    memory.begin_tick(random.between(0.0002, 0.005));
    memory.scale = {random.between(0, 1), random.between(0, 1), random.between(0, 1)};
    if (random.between(0.0, 1.0) < 0.1) {
      pen = {number(), number(), number()};
    } else {
      pen += Vec3{random.normal(), random.normal(), random.normal() - 0.2};
    }
    // Servo and safety chain drop velocities that are not finite.
    const Vec3 velocity{1e4 * random.normal(), 1e4 * random.normal(), 1e4 * random.normal()};
    const Force force = surface(rig::pen_at(pen, velocity, 0.001 * i), memory);
    RC_ASSERT(is_finite(force));
    RC_ASSERT(norm(force) <= 3.0 * std::sqrt(1.0 + 1.5 * 1.5) + 1e-9);
  }
}

// Where a hand aims that lands on the ball and then draws along a meridian, down a flank.
auto path_over_ball(const rig::Hand& hand) {
  const double depth = -rig::aim_z_mm(hand, 0.5, 500.0);
  return [depth](double t) -> Vec3 {
    const double tilt = t < 1.0 ? 0.0 : std::min(0.6 * (t - 1.0), 0.9);
    const double land = std::min(t / 0.5, 1.0);
    const double r = kTop_mm + 2 - (2 + depth) * land * land * (3 - 2 * land);
    return {r * std::sin(tilt), 0, r * std::cos(tilt)};
  };
}

TEST(SolidSurface, R12_R56_IsCalmAndPassiveInEveryGrip) {
  const SurfaceMaterial& paper = surface_materials()[0];
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        const ForceModel model(
            make_solid_surface(ball(), paper, media()[0], setup.capabilities(), 1));
        rig::Bench bench(setup, model, {0, 0, kTop_mm + 2});
        const auto target = path_over_ball(setup.hand);
        bench.run(0.8, target);
        bench.begin_measuring();
        bench.run(2.0, target);
        EXPECT_LT(bench.figures().hf_n, 0.03) << setup.name();
        EXPECT_LT(bench.figures().energy_mj, 1.0) << setup.name();
        EXPECT_GT(bench.figures().mean_size_n, 0.1) << setup.name();
      });
    }
  }
}

// A device that reports a wrong velocity.
struct WrongVelocity {
  SolidSurface surface;
  double factor = 1.0;
  Vec3 added{};

  Force operator()(PenSample sample, ForceMemory& memory) const noexcept {
    sample.velocity = factor * sample.velocity + added;
    return surface(sample, memory);
  }
  [[nodiscard]] Slopes slopes() const noexcept { return surface.slopes(); }
};

TEST(SolidSurface, R12_R49_AWrongVelocityOfTheDeviceDoesNotMakeTheSurfaceActive) {
  const auto felt = [](const rig::Setup& setup, double factor, const Vec3& added) {
    const auto body =
        make_solid_surface(ball(), surface_materials()[0], media()[0], setup.capabilities(), 1);
    rig::Bench bench(setup, ForceModel(WrongVelocity{body, factor, added}), {0, 0, kTop_mm + 2});
    const auto target = path_over_ball(setup.hand);
    bench.run(0.8, target);
    bench.begin_measuring();
    bench.run(2.0, target);
    return bench.figures();
  };
  rig::for_each_grip(0.001, 1, [&](const rig::Setup& setup) {
    const rig::Figures right = felt(setup, 1.0, {});
    EXPECT_LT(right.hf_n, 0.03) << setup.name();
    EXPECT_LT(right.energy_mj, 1.0) << setup.name();
    for (const auto& [name, factor, added] : {std::tuple{"none", 0.0, Vec3{}},
                                              {"wrong sign", -1.0, Vec3{}},
                                              {"tenfold", 10.0, Vec3{}},
                                              {"frozen", 0.0, Vec3{30, 0, -80}}}) {
      const rig::Figures wrong = felt(setup, factor, added);
      EXPECT_EQ(wrong.hf_n, right.hf_n) << setup.name() << ", " << name;
      EXPECT_EQ(wrong.energy_mj, right.energy_mj) << setup.name() << ", " << name;
    }
  });
}

}  // namespace
}  // namespace felt::solid_surface_test
