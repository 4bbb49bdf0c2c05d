#include "felt/haptics/force_model.h"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "felt/haptics/bricks/damping.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/bricks/snap_well.h"
#include "felt/haptics/bricks/spring.h"
#include "felt/haptics/bricks/stabiliser.h"
#include "felt/haptics/bricks/tether.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::force_model_test {
namespace {

static_assert(ForceFunctor<Plane> && ForceFunctor<Friction> && ForceFunctor<Texture>);
static_assert(ForceFunctor<EditSpring> && ForceFunctor<SweepSpring> && ForceFunctor<PushSpring>);
static_assert(ForceFunctor<SnapWells> && ForceFunctor<Tether> && ForceFunctor<Damping> &&
              ForceFunctor<Towed>);
static_assert(ForceFunctor<Inertia> && ForceFunctor<SurfaceForce>);
static_assert(ForceFunctor<ForceModel> == false, "a model is no brick: it would be 2 KiB in 2 KiB");
static_assert(std::is_trivially_copyable_v<ForceModel>);

/// A model of all bricks.
auto all_bricks(const Capabilities& device = {}) {
  const SurfaceMaterial& paper = surface_materials()[0];
  return Compose(make_surface_force(paper, media()[0], device, surface_grain(paper)),
                 EditSpring({-3, 1}), SweepSpring({.pen = {0, 1}, .normal = {0, 1}}),
                 SnapWells(Point{1, 1}), Tether::translation({2, 0}, 3),
                 Damping({.where = DampingWhere::kEverywhere}));
}

/// A pen on some path, for comparisons.
PenSample pen_on_its_way(int i) {
  const double t = 0.001 * i;
  return rig::pen_at({9 * std::sin(7 * t), 5 * std::sin(11 * t), std::sin(3 * t) - 0.5},
                     {63 * std::cos(7 * t), 55 * std::cos(11 * t), 3 * std::cos(3 * t)}, t);
}

TEST(ForceModel, AnEmptyOneIsNoForce) {
  const ForceModel none;
  ForceMemory memory;
  EXPECT_FALSE(none);
  EXPECT_EQ(none(rig::pen_at({1, 2, -3}), memory), Force{});
  EXPECT_EQ(none.slopes(), Slopes{});
}

TEST(ForceModel, ForwardsToItsFunctorAlsoWhenCopied) {
  const auto functor = all_bricks();
  const ForceModel model(functor);
  ForceModel copy;
  copy = model;
  ForceMemory a, b, c;
  EXPECT_EQ(model.slopes(), functor.slopes());
  for (int i = 0; i < 2000; ++i) {
    a.begin_tick(0.001);
    b.begin_tick(0.001);
    c.begin_tick(0.001);
    const Force direct = functor(pen_on_its_way(i), a);
    ASSERT_EQ(model(pen_on_its_way(i), b), direct);
    ASSERT_EQ(copy(pen_on_its_way(i), c), direct);
  }
}

TEST(ForceModel, AnAddedForceIsEvaluatedAfterTheOthers) {
  const SurfaceMaterial& paper = surface_materials()[0];
  const SurfaceForce surface = make_surface_force(paper, media()[0], {}, surface_grain(paper));
  const SnapWells well(Point{1, 1});
  const ForceModel whole(Compose(surface, well));
  ForceModel model(surface);
  ASSERT_TRUE(model.add(well));
  EXPECT_EQ(model.slopes(), whole.slopes());
  ForceMemory a, b;
  for (int i = 0; i < 2000; ++i) {
    a.begin_tick(0.001);
    b.begin_tick(0.001);
    const PenSample pen = pen_on_its_way(i);
    ASSERT_EQ(model(pen, a), whole(pen, b)) << i;
  }
  EXPECT_FALSE(model.add(well)) << "only one";
  struct Large {
    std::array<char, kForceFunctorBytes - 100> bytes{};
    Force operator()(const PenSample&, ForceMemory&) const noexcept { return {}; }
    [[nodiscard]] Slopes slopes() const noexcept { return {1.0, 1.0}; }
  };
  ForceModel other(surface);
  EXPECT_FALSE(other.add(Large{})) << "not enough space";
  EXPECT_EQ(other.slopes(), surface.slopes());
  ForceModel empty;
  EXPECT_TRUE(empty.add(well));
  EXPECT_EQ(empty.slopes(), well.slopes());
}

TEST(ForceModel, HoldsOneGuideBecauseGuidesShareTheirMemory) {
  const Guide guide(GuideLaw::groove(1.0), {});
  ForceModel alone(guide), none{Damping()};
  ForceModel among{Compose(Damping{}, Compose(guide))};
  EXPECT_FALSE(alone.add(guide));
  EXPECT_FALSE(among.add(guide));
  EXPECT_TRUE(among.add(Damping{})) << "another force";
  EXPECT_TRUE(none.add(guide));
}

TEST(ForceModel, TheTermsSumToTheForce) {
  const ForceModel model(all_bricks());
  ForceMemory memory;
  for (int i = 0; i < 3000; ++i) {
    memory.begin_tick(0.001);
    const Force force = model(pen_on_its_way(i), memory);
    Force sum;
    for (const ForceTerms::Term& term : memory.terms) sum += term.force;
    ASSERT_NEAR(norm(force - sum), 0.0, 1e-12);
  }
  memory.begin_tick(0.001);
  model(pen_on_its_way(1800), memory);
  std::string names;
  for (const ForceTerms::Term& term : memory.terms) names += std::string(term.name) + " ";
  EXPECT_EQ(names, "plane friction texture edit edit snap tether damping ");
}

TEST(ForceModel, WhatDoesNotFitIsSummedUp) {
  ForceTerms terms;
  for (int i = 1; i <= 12; ++i) terms.add("one", {1.0 * i, 0, 0});
  EXPECT_EQ(terms.size(), ForceTerms::kMax);
  double sum = 0.0;
  for (const ForceTerms::Term& term : terms) sum += term.force.x;
  EXPECT_EQ(sum, 78.0);
  EXPECT_EQ(std::string_view(terms[ForceTerms::kMax - 1].name), "other");
}

TEST(Compose, SlopesAddAndOrderIsThatOfWriting) {
  const Compose sum(Plane{}, Friction{}, EditSpring({0, 0}), SnapWells(Point{0, 0}));
  EXPECT_EQ(sum.slopes(), (Slopes{500.0, 600.0, 600.0}));
  // The friction uses the push of the plane of the same tick.
  ForceMemory memory;
  memory.begin_tick(0.001);
  const Compose surface(Plane{}, Friction{});
  surface(rig::pen_at({0, 0, -2}), memory);
  memory.begin_tick(0.001);
  EXPECT_DOUBLE_EQ(surface(rig::pen_at({5, 0, -2}, {}, 0.001), memory).x, -0.25);
  EXPECT_EQ(Compose<>().slopes(), Slopes{});
}

TEST(ForceModel, NothingSticksWhenTheLastPlaneIsGone) {
  ForceMemory memory;
  memory.begin_tick(0.001);
  Plane{}(rig::pen_at({0, 0, -2}), memory);
  memory.begin_tick(0.001);
  EXPECT_EQ(Friction{}(rig::pen_at({5, 0, -2}), memory), Force{});
}

TEST(Damping, BrakesWhereItShould) {
  ForceMemory memory;
  const Damping air({.damping_n_s_per_m = 1.0, .max_force_n = 0.3});
  EXPECT_EQ(air(rig::pen_at({0, 0, 5}, {100, 0, 50}), memory), (Force{-0.1, 0, -0.05}));
  EXPECT_EQ(air(rig::pen_at({0, 0, -5}, {100, 0, 50}), memory), Force{});
  EXPECT_NEAR(norm(air(rig::pen_at({0, 0, 5}, {900, 100, 50}), memory)), 0.3, 1e-12);
  const Damping surface({.damping_n_s_per_m = 1.0, .where = DampingWhere::kOnSurface});
  EXPECT_EQ(surface(rig::pen_at({0, 0, -5}, {100, 0, 50}), memory), (Force{-0.1, 0, 0}));
  EXPECT_EQ(surface(rig::pen_at({0, 0, 5}, {100, 0, 50}), memory), Force{});
}

}  // namespace
}  // namespace felt::force_model_test
