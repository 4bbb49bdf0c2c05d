#include "felt/haptics/texture.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "felt/haptics/drawing_feel.h"
#include "felt/haptics/feel_rig.h"

namespace felt {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;

TEST(Texture, R48_TheLimitIsThatOfTheLoop) {
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.001), 400.0);
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.0002), 800.0);
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.004), 100.0);
  EXPECT_DOUBLE_EQ(texture_stiffness_limit_n_per_m(0.0), 800.0);
}

/// The stiffest place of a texture as it acts, by differences along a path of slow motion.
double measured_stiffness(const SheetForce& feel, const PlaneOptions& plane, double push_n,
                          bool sliding) {
  const ForceModel model(feel);
  ForceMemory memory;
  double stiffest = 0.0;
  constexpr double kStep = 1e-3;
  Force last;
  const double z = -1e3 * push_n / plane.stiffness_n_per_m;
  for (int i = 0; i < 40'000; ++i) {
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

TEST(Texture, R48_EveryPresetKeepsToTheBound) {
  for (const double period_s : {0.0002, 0.001, 0.004}) {
    const double limit = texture_stiffness_limit_n_per_m(period_s);
    rig::Setup setup;
    setup.period_s = period_s;
    for (const SurfaceMaterial& surface : surface_materials()) {
      const HeightField* grain = surface_grain(surface);
      if (surface.grain_um == 0.0) {
        EXPECT_EQ(grain, nullptr);
        continue;
      }
      // The bound of the specification, for the field's rms wave.
      const double wave = kTau / surface.grain_mm;
      EXPECT_LE(1e3 * 1e-3 * surface.grain_um * std::sqrt(2.0) * wave * wave, 400.0) << surface.id;
      for (const ToolMaterial& tool : tool_materials()) {
        for (const TextureLaw law : {TextureLaw::kFriction, TextureLaw::kGradient}) {
          const Texture texture(grain, {.law = law,
                                        .strength = tool.grain,
                                        .friction = friction_of(tool, surface),
                                        .period_s = period_s});
          EXPECT_GT(texture.stiffness_n_per_m(), 0.0);
          EXPECT_LE(texture.stiffness_n_per_m(), limit * (1 + 1e-12)) << surface.id << tool.id;
          for (const double push_n : {0.3, 1.0, 2.5}) {
            const PlaneOptions plane = plane_for(surface, setup.capabilities());
            const SheetForce feel =
                make_sheet_force(surface, tool, setup.capabilities(), grain, law);
            EXPECT_LE(measured_stiffness(feel, plane, push_n, law == TextureLaw::kFriction),
                      limit * 1.01)
                << surface.id << " " << tool.id << " T " << period_s << " push " << push_n;
          }
        }
      }
    }
  }
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
          const SheetForce feel = make_sheet_force(paper, tool_materials()[0], setup.capabilities(),
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
  // Slow circles within the grain: the reason why it is the default.
  const SurfaceMaterial& board = *find_surface("blackboard");
  const SheetForce feel = make_sheet_force(board, tool_materials()[0], rig::Setup{}.capabilities(),
                                           surface_grain(board));
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
  // Sliding over paper the friction varies by more than a tenth (Weber fraction 0.08-0.13).
  const SurfaceMaterial& paper = surface_materials()[0];
  const ForceModel model(make_sheet_force(paper, tool_materials()[0], rig::Setup{}.capabilities(),
                                          surface_grain(paper)));
  ForceMemory memory;
  double least = 1e9;
  double most = 0.0;
  for (int i = 0; i < 3000; ++i) {
    memory.begin_tick(0.001);
    const Force force = model(rig::pen_at({0.02 * i, 0, -2}, {20, 0, 0}, 0.001 * i), memory);
    if (i < 200) continue;
    least = std::min(least, -force.x);
    most = std::max(most, -force.x);
  }
  EXPECT_GT(most, 1.2 * least);
  EXPECT_GT(least, 0.0);
}

}  // namespace
}  // namespace felt
