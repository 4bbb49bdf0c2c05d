#include "felt/haptics/bricks/drawing_feel.h"

#include <gtest/gtest.h>

#include <numbers>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/bricks/stabiliser.h"
#include "felt/haptics/bricks/tether.h"
#include "felt/haptics/safety/safety_chain.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::drawing_feel_test {
namespace {

TEST(Material, R13_SurfacesAndToolsAreOrderedByTheirDrag) {
  const Medium& pencil = *find_medium("pencil");
  const auto mu = [&](const char* id) { return friction_of(pencil, *find_surface(id)); };
  EXPECT_DOUBLE_EQ(mu("paper"), 0.25);
  EXPECT_DOUBLE_EQ(mu("blackboard"), 0.45);
  EXPECT_LT(mu("glass"), mu("paper"));
  EXPECT_LT(mu("paper"), mu("felt"));
  EXPECT_LT(mu("felt"), mu("blackboard"));
  EXPECT_LT(find_surface("felt")->stiffness_n_per_m, find_surface("paper")->stiffness_n_per_m);
  EXPECT_LT(find_surface("paper")->stiffness_n_per_m,
            find_surface("blackboard")->stiffness_n_per_m);
  EXPECT_EQ(find_surface("marble"), nullptr);
  EXPECT_EQ(find_medium(""), nullptr);
  EXPECT_EQ(surface_materials().front().id, "paper");
  EXPECT_EQ(media().front().id, "pencil");
}

TEST(DrawingFeel, R68_TheViscosityMatchesTheMassOfTheDevice) {
  const auto viscosity = [](double mass_kg, double friction_n, double most = 30.0) {
    return matched_viscosity_n_s_per_m(
        {.max_damping_n_s_per_m = most, .friction_n = friction_n, .mass_kg = mass_kg});
  };
  EXPECT_NEAR(viscosity(0.1, 0.0), 1.8, 1e-12);
  EXPECT_NEAR(viscosity(0.1, 0.18), 1.8, 1e-12);
  EXPECT_NEAR(viscosity(0.1, 0.27), 0.9, 1e-12);
  EXPECT_EQ(viscosity(0.045, 0.26), 0.0);     // a Touch damps by itself
  EXPECT_EQ(viscosity(0.3, 0.05, 5.0), 2.5);  // half of what the device can render
  EXPECT_EQ(viscosity(0.0, 0.0), 0.0);        // unknown
  EXPECT_EQ(viscosity(0.3, 0.05, 0.0), 0.0);
}

TEST(DrawingFeel, R68_WhatDrawsGetsTheFrictionBeyondTheDeviceAndTheEraserAllOfIt) {
  const Capabilities device{
      .max_force_n = 3.0, .max_damping_n_s_per_m = 5.0, .friction_n = 0.05, .mass_kg = 0.1};
  for (Medium medium : media()) {
    for (const SurfaceMaterial& surface : surface_materials()) {
      const FrictionOptions friction = friction_for(medium, surface, device);
      EXPECT_EQ(friction.own_friction_n, medium.draws ? 0.05 : 0.0) << medium.id;
      EXPECT_EQ(friction.own_coefficient, 0.25);
      EXPECT_NEAR(friction.viscosity_n_s_per_m, 1.8 * std::min(1.0, friction.coefficient / 0.1),
                  1e-12);
    }
    medium.strength = 0.0;
    const FrictionOptions none = friction_for(medium, surface_materials()[0], device);
    EXPECT_EQ(none.viscosity_n_s_per_m, 0.0);
  }
}

TEST(DrawingFeel, R56_TheBudgetFollowsTheDelay) {
  const auto budget = [](std::int64_t period_us, int delay) {
    Capabilities device;
    device.period_ns = 1000 * period_us;
    device.delay_ticks = delay;
    return stiffness_budget_n_per_m(device);
  };
  EXPECT_DOUBLE_EQ(budget(1000, 0), 900.0);
  EXPECT_DOUBLE_EQ(budget(1000, 1), 900.0);
  EXPECT_DOUBLE_EQ(budget(1000, 2), 600.0);
  EXPECT_DOUBLE_EQ(budget(200, 2), 900.0);
  EXPECT_DOUBLE_EQ(budget(4000, 1), 225.0);
}

TEST(DrawingFeel, R55_APlaneKeepsToItsDevice) {
  Capabilities touch;
  touch.max_stiffness_n_per_m = 400.0;
  touch.max_damping_n_s_per_m = 1.5;
  const PlaneOptions plane = plane_for(*find_surface("glass"), touch);
  EXPECT_DOUBLE_EQ(plane.stiffness_n_per_m, 360.0);
  EXPECT_DOUBLE_EQ(plane.damping_n_s_per_m, 1.5);
  Capabilities slow;
  slow.delay_ticks = 2;
  EXPECT_DOUBLE_EQ(plane_for(*find_surface("glass"), slow).stiffness_n_per_m, 600.0);
  EXPECT_DOUBLE_EQ(plane_for(*find_surface("felt"), slow).stiffness_n_per_m, 300.0);
}

TEST(DrawingFeel, R13_SurfacesKeepTheOrderOfTheirHardnessOnEveryDevice) {
  for (const double cap : {0.0, 100.0, 400.0, 1000.0, 8000.0}) {
    for (const double step_mm : {0.0, 0.03, 0.055}) {
      for (const std::int64_t period_ns : {200'000, 1'000'000, 4'000'000}) {
        Capabilities device;
        device.max_stiffness_n_per_m = cap;
        device.position_step_mm = step_mm;
        device.period_ns = period_ns;
        double last = 0.0;
        for (const char* id : {"felt", "paper", "wood", "blackboard", "glass"}) {
          const SurfaceMaterial& surface = *find_surface(id);
          const double here = plane_for(surface, device).stiffness_n_per_m;
          EXPECT_GT(here, 1.05 * last) << id << ", cap " << cap << ", step " << step_mm;
          EXPECT_LE(here, surface.stiffness_n_per_m);
          EXPECT_LE(here, stiffness_budget_n_per_m(device));
          if (cap > 0.0) {
            EXPECT_LE(here, 0.9 * cap + 1e-9);
          }
          last = here;
        }
      }
    }
  }
}

TEST(DrawingFeel, ASlowLoopGetsTheSofterBristle) {
  const Medium& pencil = media()[0];
  const SurfaceMaterial& paper = surface_materials()[0];
  Capabilities device;
  const FrictionOptions fast = friction_for(pencil, paper, device);
  EXPECT_DOUBLE_EQ(fast.stiffness_n_per_m, 600.0);
  EXPECT_DOUBLE_EQ(fast.damping_n_s_per_m, 2.0);
  device.delay_ticks = 2;
  const FrictionOptions slow = friction_for(pencil, paper, device);
  EXPECT_DOUBLE_EQ(slow.stiffness_n_per_m, 300.0);
  EXPECT_DOUBLE_EQ(slow.damping_n_s_per_m, 1.0);
}

/// Returns the largest high-frequency force at rest, in slow circles and in strokes.
template <class Make>
double worst_hf(const rig::Setup& setup, const Make& make) {
  double worst = 0.0;
  for (const double hz : {0.0, 0.5, 1.0}) {
    const ForceModel model(make(setup));
    const double budget = stiffness_budget_n_per_m(setup.capabilities());
    rig::Bench bench(setup, model, {0, 0, 1});
    SafetyChain chain(limits_for(setup.capabilities()));
    const StiffnessScale scale = chain.budget(model.slopes());
    bench.memory().scale = scale;
    EXPECT_LE(scale.friction * model.slopes().friction_n_per_m +
                  scale.lateral * model.slopes().lateral_n_per_m,
              budget * (1 + 1e-12));
    EXPECT_LE(scale.normal * model.slopes().normal_n_per_m, budget);
    const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
    const auto target = [&](double time) -> Vec3 {
      const double x = std::min(time / 0.4, 1.0);
      const double t = std::max(0.0, time - 0.7);
      return {12 * std::sin(kTau * hz * t), 5 * std::sin(1.5 * kTau * hz * t),
              1 + (aim - 1) * x * x * (3 - 2 * x)};
    };
    bench.run(0.8, target);
    bench.begin_measuring();
    bench.run(0.8, target);
    worst = std::max(worst, bench.figures().hf_n);
  }
  return worst;
}

TEST(DrawingFeel, R56_WithAllEffectsOnTheSumKeepsToTheBudgetAndIsCalm) {
  const SurfaceMaterial& paper = surface_materials()[0];
  const auto everything = [&](const rig::Setup& setup) {
    return Compose(make_surface_force(paper, media()[0], setup.capabilities(), surface_grain(paper),
                                      TextureLaw::kGradient),
                   EditSpring({-3, 1}), SnapWells(Point{1, 1}), Tether::translation({1, 1}, 8),
                   Inertia());
  };
  const auto usual = [&](const rig::Setup& setup) {
    return Compose(
        make_surface_force(paper, media()[0], setup.capabilities(), surface_grain(paper)),
        EditSpring({-3, 1}), SnapWells(Point{1, 1}));
  };
  double worst = 0.0;
  for (const double period_s : {0.0002, 0.001}) {
    for (int delay = 0; delay <= 2; ++delay) {
      rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
        const double hf = std::max(worst_hf(setup, everything), worst_hf(setup, usual));
        EXPECT_LT(hf, 0.03) << setup.name();
        worst = std::max(worst, hf);
      });
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

TEST(DrawingFeel, R50_ASlowLoopIsCalmWithinItsBudget) {
  const SurfaceMaterial& paper = surface_materials()[0];
  for (int delay = 0; delay <= 1; ++delay) {
    rig::for_each_grip(0.004, delay, [&](const rig::Setup& setup) {
      const auto calm_with = [&](const char* what, const auto& brick) {
        const double hf = worst_hf(setup, [&](const rig::Setup& s) {
          return Compose(make_surface_force(paper, media()[0], s.capabilities()), brick);
        });
        EXPECT_LT(hf, 0.03) << setup.name() << ", " << what;
      };
      calm_with("edit", EditSpring({-3, 1}));
      calm_with("well", SnapWells(Point{1, 1}));
      calm_with("translation", Tether::translation({1, 1}, 8));
      calm_with("rotation", Tether::rotation({20, 0}, {1, 1}, 200.0, 1));
      calm_with("scale", Tether::scale({20, 0}, {1, 1}, 200.0));
    });
  }
}

}  // namespace
}  // namespace felt::drawing_feel_test
