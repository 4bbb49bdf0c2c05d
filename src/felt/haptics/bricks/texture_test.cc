#include "felt/haptics/bricks/texture.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/haptics/testing/feel_rig.h"

namespace felt::texture_test {
namespace {

TEST(Texture, R48_TheLimitIsThatOfTheLoop) {
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.001), 400.0);
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.0002), 800.0);
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.004), 100.0);
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.0), 800.0);
}

/// Returns the largest stiffness of a texture, from differences along a path of slow motion.
double measured_stiffness(const SurfaceForce& feel, const PlaneOptions& plane, double push_n,
                          bool sliding) {
  const ForceModel model(feel);
  ForceMemory memory;
  double stiffest = 0.0;
  constexpr double kStep = 1e-3;
  Force last;
  const double z = -1e3 * push_n / plane.stiffness_n_per_m;
  for (int i = 0; i < 12'000; ++i) {
    memory.begin_tick(0.001);
    Force texture;
    model(rig::pen_at({kStep * i, 0.37 * kStep * i, z}, {1, 0.37, 0}, 0.001 * i), memory);
    for (const auto& term : memory.terms) {
      if (std::string_view(term.name) == "texture") texture = term.force;
    }
    if (i > (sliding ? 3000 : 10)) {
      stiffest = std::max(stiffest, norm(texture - last) / (kStep * std::sqrt(1 + 0.37 * 0.37)));
    }
    last = texture;
  }
  return 1e3 * stiffest;
}

void keeps_every_preset_to_the_bound(double period_s) {
  const double limit = texture_stiffness_limit_n_per_m(period_s);
  rig::Setup setup;
  setup.period_s = period_s;
  for (const SurfaceMaterial& surface : surface_materials()) {
    const HeightField* grain = surface_grain(surface);
    if (surface.grain_um == 0.0) {
      EXPECT_EQ(grain, nullptr);
      continue;
    }
    // The bound of docs/design/forces.md#texture for the field's RMS wave and the counted push.
    const double wave = kTau / surface.grain_mm;
    EXPECT_LE(Texture::kMaxCountedN * surface.grain_um * std::sqrt(2.0) * wave * wave, 400.0)
        << surface.id;
    for (const Medium& tool : media()) {
      for (const TextureLaw law : {TextureLaw::kFriction, TextureLaw::kGradient}) {
        const Texture texture(grain, {.law = law,
                                      .strength = tool.grain,
                                      .friction = friction_of(tool, surface),
                                      .period_s = period_s});
        EXPECT_GT(texture.stiffness_n_per_m(), 0.0);
        EXPECT_LE(texture.stiffness_n_per_m(), limit * (1 + 1e-12)) << surface.id << tool.id;
        for (const double push_n : {0.3, 1.0, 2.5}) {
          const PlaneOptions plane = plane_for(surface, setup.capabilities());
          const SurfaceForce feel =
              make_surface_force(surface, tool, setup.capabilities(), grain, law);
          EXPECT_LE(measured_stiffness(feel, plane, push_n, law == TextureLaw::kFriction),
                    limit * 1.01)
              << surface.id << " " << tool.id << " T " << period_s << " push " << push_n;
        }
      }
    }
  }
}

TEST(Texture, R48_EveryPresetKeepsToTheBound) {
  keeps_every_preset_to_the_bound(0.001);
}

TEST(Texture, R48_EveryPresetKeepsToTheBoundOfAFastLoop) {
  keeps_every_preset_to_the_bound(0.0002);
}

TEST(Texture, R48_EveryPresetKeepsToTheBoundOfASlowLoop) {
  keeps_every_preset_to_the_bound(0.004);
}

TEST(Texture, R48_FallsToNothingWhereTheLoopCannotFollow) {
  const HeightField field({.wavelength_mm = 1.0, .rms_um = 3.0});
  const Texture texture(&field);
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    const double limit = field.shortest_wavelength_mm() / (4.0 * period_s);
    EXPECT_EQ(texture.share_at(0.0, period_s), 1.0);
    EXPECT_EQ(texture.share_at(0.5 * limit, period_s), 1.0);
    EXPECT_EQ(texture.share_at(limit, period_s), 0.0);
    EXPECT_EQ(texture.share_at(10 * limit, period_s), 0.0);
    double last = 1.0;
    for (double v = 0.0; v < 1.1 * limit; v += 0.001 * limit) {
      const double share = texture.share_at(v, period_s);
      EXPECT_LE(share, last);
      EXPECT_LE(last - share, 0.0031);
      last = share;
    }
  }
}

TEST(Texture, R48_IsQuietAtRest) {
  double worst = 0.0;
  const SurfaceMaterial& paper = surface_materials()[0];
  for (const TextureLaw law : {TextureLaw::kFriction, TextureLaw::kGradient}) {
    for (const double period_s : {0.0002, 0.001}) {
      for (int delay = 0; delay <= 2; ++delay) {
        rig::for_each_grip(period_s, delay, [&](const rig::Setup& setup) {
          const SurfaceForce feel = make_surface_force(paper, media()[0], setup.capabilities(),
                                                       surface_grain(paper), law);
          rig::Bench bench(setup, ForceModel(feel), {0.3, 0.2, 1});
          const double aim = rig::aim_z_mm(setup.hand, 1.0, 500.0);
          const auto target = [&](double time) -> Vec3 {
            const double x = std::min(time / 0.4, 1.0);
            return {0.3, 0.2, 1 + (aim - 1) * x * x * (3 - 2 * x)};
          };
          bench.run(0.8, target);
          bench.begin_measuring();
          bench.run(0.8, target);
          EXPECT_LT(bench.figures().hf_n, 0.04) << setup.name();
          worst = std::max(worst, bench.figures().hf_n);
        });
      }
    }
  }
  RecordProperty("worst_hf_n", std::to_string(worst));
}

TEST(Texture, TheFrictionLawOnlyTakesEnergy) {
  // Slow circles within the grain show why the friction law is the default.
  const SurfaceMaterial& board = *find_surface("blackboard");
  const SurfaceForce feel =
      make_surface_force(board, media()[0], rig::Setup{}.capabilities(), surface_grain(board));
  for (const double radius : {0.2, 0.7, 3.0}) {
    const ForceModel model(feel);
    ForceMemory memory;
    double energy = 0.0;
    Vec3 last{radius, 0, -1.25};
    for (int i = 1; i <= 40'000; ++i) {
      const double a = kTau * i / 10'000;
      const Vec3 now{radius * std::cos(a), radius * std::sin(a), -1.25};
      memory.begin_tick(0.001);
      const Force force = model(rig::pen_at(now, 1000 * (now - last), 0.001 * i), memory);
      energy += work_mj(force, now - last);
      last = now;
    }
    EXPECT_LT(energy, 0.0) << radius;
  }
}

TEST(Texture, CanBeFelt) {
  // When sliding over paper the friction varies by more than a tenth (Weber fraction 0.08-0.13).
  const SurfaceMaterial& paper = surface_materials()[0];
  const ForceModel model(
      make_surface_force(paper, media()[0], rig::Setup{}.capabilities(), surface_grain(paper)));
  ForceMemory memory;
  double smallest = 1e9;
  double largest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    memory.begin_tick(0.001);
    const Force force = model(rig::pen_at({0.02 * i, 0, -2}, {20, 0, 0}, 0.001 * i), memory);
    if (i < 200) continue;
    smallest = std::min(smallest, -force.x);
    largest = std::max(largest, -force.x);
  }
  EXPECT_GT(largest, 1.2 * smallest);
  EXPECT_GT(smallest, 0.0);
}

/// Returns the smallest and the largest friction of a pencil that slides over 60 mm of the surface
/// with a push of 0.8 N, N, without that of the device, which is `own_n`.
std::pair<double, double> frictions_on(const SurfaceMaterial& surface, double own_n) {
  Capabilities device = rig::Setup{}.capabilities();
  device.friction_n = own_n;
  const ForceModel model(make_surface_force(surface, media()[0], device, surface_grain(surface)));
  ForceMemory memory;
  double smallest = 1e9, largest = 0.0;
  const double depth_mm = 800.0 / plane_for(surface, device).stiffness_n_per_m;
  for (int i = 0; i < 3000; ++i) {
    memory.begin_tick(0.001);
    const Force force = model(rig::pen_at({0.02 * i, 0, -depth_mm}, {20, 0, 0}, 0.001 * i), memory);
    if (i < 200) continue;
    smallest = std::min(smallest, -force.x);
    largest = std::max(largest, -force.x);
  }
  return {smallest, largest};
}

TEST(Texture, R68_AReliefIsFeltOnADeviceWithMoreFrictionThanTheSurface) {
  for (const char* id : {"rough-paper", "watercolour", "canvas", "blackboard", "wood"}) {
    const SurfaceMaterial& surface = *find_surface(id);
    const auto [smallest, largest] = frictions_on(surface, 1.0);
    EXPECT_GT(largest - smallest, 0.08) << id;
    const auto [least, most] = frictions_on(surface, 0.0);
    EXPECT_LE(largest, most + 1e-12) << id;
    EXPECT_LE(largest - smallest, most - least + 1e-12) << id;
  }
  // What cannot be felt is not rendered, because it would only be more friction.
  for (const char* id : {"paper", "felt", "glass"}) {
    const auto [smallest, largest] = frictions_on(*find_surface(id), 1.0);
    EXPECT_NEAR(smallest, largest, 1e-12) << id;
  }
  EXPECT_NEAR(frictions_on(*find_surface("paper"), 1.0).second, 0.0, 1e-12);
}

/// An arbitrary relief under an arbitrary medium in an arbitrary loop, within the ranges of
/// user-defined files.
struct AnyTexture {
  HeightField field;
  TextureOptions options;
};

AnyTexture any_texture(TextureLaw law) {
  const auto share = [] { return 0.01 * *rc::gen::inRange(0, 101); };
  const auto character = static_cast<HeightCharacter>(*rc::gen::inRange(0, 5));
  // Uses few tiles and many sizes, because a tile takes 20 to 60 ms.
  static std::map<HeightCharacter, HeightField> tiles;
  auto tile = tiles.find(character);
  if (tile == tiles.end()) {
    tile = tiles.emplace(character, HeightField({1.0, 5.0, 77, character})).first;
  }
  const double wavelength_mm = 0.5 + 0.01 * *rc::gen::inRange(0, 800);
  const double rms_um = 0.1 * *rc::gen::inRange(1, 2000);
  return {tile->second.scaled(wavelength_mm, rms_um),
          {.law = law,
           .strength = share(),
           .wear = share(),
           .firm_push_n = 0.2 + 1.8 * share(),
           .friction = 0.02 + 1.3 * share(),
           .period_s = *rc::gen::element(0.0002, 0.001, 0.004)}};
}

/// The texture's force at a position of a pen that slides along +x, and the factor that caused it.
struct Felt {
  Force force;
  double factor = 1.0;
};
Felt force_at(const Texture& texture, const TextureOptions& options, Point p, double push_n) {
  ForceMemory memory;
  memory.begin_tick(options.period_s);
  memory.period_s = options.period_s;
  memory.normal_force_n = push_n;
  Felt felt;
  felt.force = texture(rig::pen_at({p.x, p.y, -1.0}, {1.0, 0.0, 0.0}), memory);
  felt.factor = memory.friction_factor;
  if (options.law == TextureLaw::kFriction) {
    felt.force.x -= options.friction * push_n * (felt.factor - 1.0);
  }
  return felt;
}

/// R48: the derivatives of the force by position and by push are within the promised bounds
/// everywhere.
void holds_everywhere(TextureLaw law) {
  const AnyTexture any = any_texture(law);
  const Texture texture(&any.field, any.options);
  const double limit = texture_stiffness_limit_n_per_m(any.options.period_s);
  RC_ASSERT(texture.stiffness_n_per_m() <= limit * (1 + 1e-12));
  for (int i = 0; i < 200; ++i) {
    const Point p{0.01 * *rc::gen::inRange(-4000, 4000), 0.01 * *rc::gen::inRange(-4000, 4000)};
    const double push_n = 1e-3 * *rc::gen::inRange(1, 4000);
    const double angle = 0.01 * *rc::gen::inRange(0, 629);
    constexpr double kStepMm = 1e-4, kStepN = 1e-4;
    const Felt here = force_at(texture, any.options, p, push_n);
    const Felt beside =
        force_at(texture, any.options, p + kStepMm * Vec{std::cos(angle), std::sin(angle)}, push_n);
    const Felt harder = force_at(texture, any.options, p, push_n + kStepN);
    const double along_n_per_m = 1e3 * norm(beside.force - here.force) / kStepMm;
    RC_ASSERT(along_n_per_m <= texture.stiffness_n_per_m() * 1.001 + 1e-6);
    // In the friction law, nothing changes with the push faster than friction does.
    if (law == TextureLaw::kFriction) {
      const double by_push = norm(harder.force - here.force) / kStepN;
      RC_ASSERT(by_push <= 0.8 * any.options.friction * (1 + 1e-6) + 1e-9);
      RC_ASSERT(here.factor >= 0.2 - 1e-12);  // positive, so it only removes energy
      RC_ASSERT(here.factor <= 1.8 + 1e-12);
    }
  }
}

RC_GTEST_PROP(Texture, R48_FrictionHoldsToTheBoundAtEveryPlaceAndPush, ()) {
  holds_everywhere(TextureLaw::kFriction);
}

RC_GTEST_PROP(Texture, R48_GradientHoldsToTheBoundAtEveryPlaceAndPush, ()) {
  holds_everywhere(TextureLaw::kGradient);
}

RC_GTEST_PROP(Texture, R68_TheGrainIsAPartOfTheFriction, ()) {
  const AnyTexture any = any_texture(TextureLaw::kFriction);
  const Texture texture(&any.field, any.options);
  ForceMemory memory;
  for (int i = 0; i < 50; ++i) {
    memory.begin_tick(0.001);
    memory.normal_force_n = 0.01 * *rc::gen::inRange(1, 200);
    const Vec3 at{0.1 * *rc::gen::inRange(0, 1000), 0.1 * *rc::gen::inRange(0, 1000), -1};
    texture(rig::pen_at(at, {1.0 * *rc::gen::inRange(0, 300), 0, 0}), memory);
    RC_ASSERT(memory.friction_grain >= 0.0);
    RC_ASSERT(memory.friction_grain <= memory.friction_factor + 1e-12);
  }
}

RC_GTEST_PROP(Texture, R47_APushWearsTheReliefAsItDoesForTheEye, ()) {
  const AnyTexture any = any_texture(TextureLaw::kFriction);
  TextureOptions unworn = any.options;
  unworn.wear = 0.0;
  const Texture texture(&any.field, any.options), whole(&any.field, unworn);
  const Point p{0.01 * *rc::gen::inRange(0, 4000), 0.01 * *rc::gen::inRange(0, 4000)};
  double last_left = 1.0, last_counted = 0.0;
  for (double push_n = 0.01; push_n < 3.0; push_n += 0.01) {
    const double firmness = push_n / any.options.firm_push_n;
    const double left = relief_left(any.options.wear, firmness);
    const double full = force_at(whole, unworn, p, push_n).factor - 1.0;
    const double worn = force_at(texture, any.options, p, push_n).factor - 1.0;
    RC_ASSERT(std::abs(worn - left * full) <= 1e-12);
    // The share of the relief decreases with the push, without jumps, to 1 - wear and no farther.
    RC_ASSERT(left <= last_left);
    RC_ASSERT(last_left - left <= 0.01 / any.options.firm_push_n + 1e-12);
    RC_ASSERT(left >= 1.0 - any.options.wear - 1e-12);
    const double counted = texture.counted_push_n(push_n);
    RC_ASSERT(counted >= 0.0);
    RC_ASSERT(counted <= std::min(push_n, Texture::kMaxCountedN));
    RC_ASSERT(std::abs(counted - last_counted) <= 0.01 + 1e-12);
    last_left = left;
    last_counted = counted;
  }
}

RC_GTEST_PROP(Texture, AWornTextureOnlyTakesEnergyOnAnyClosedWay, ()) {
  // The paths are closed, with arbitrary pushes, within the grain and across it.
  const AnyTexture any = any_texture(TextureLaw::kFriction);
  const double radius_mm = 0.05 + 0.05 * *rc::gen::inRange(0, 100);
  const double wobble = 0.01 * *rc::gen::inRange(0, 100);
  const int hills = *rc::gen::inRange(1, 9);
  const ForceModel model(
      Compose(Plane({.stiffness_n_per_m = 500.0, .damping_n_s_per_m = 0.0}),
              Texture(&any.field, any.options),
              Friction({.coefficient = any.options.friction, .stiffness_n_per_m = 600.0})));
  ForceMemory memory;
  double energy_mj = 0.0;
  Vec3 last{radius_mm, 0.0, -2.0};
  constexpr int kTicks = 8000, kAround = 2000;
  for (int i = 1; i <= kTicks; ++i) {
    const double a = kTau * i / kAround;
    const double depth = 2.0 + 1.5 * wobble * std::sin(hills * a);
    const Vec3 now{radius_mm * std::cos(a), radius_mm * std::sin(2.0 * a), -depth};
    memory.begin_tick(0.001);
    const Force force = model(rig::pen_at(now, 1000 * (now - last), 0.001 * i), memory);
    // The surface's plane returns the energy that it stores, so only forces along the surface
    // count.
    if (i > kAround) energy_mj += force.x * (now.x - last.x) + force.y * (now.y - last.y);
    last = now;
  }
  RC_ASSERT(energy_mj <= 1e-9);
}

}  // namespace
}  // namespace felt::texture_test
