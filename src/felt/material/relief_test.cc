#include "felt/material/relief.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "felt/material/materials.h"

namespace felt::relief_test {
namespace {

TEST(Relief, R47_OneSurfaceHasOneReliefForAll) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    const HeightField* relief = surface_grain(surface);
    EXPECT_EQ(relief == nullptr, surface.grain_um == 0.0) << surface.id;
    EXPECT_EQ(relief, surface_grain(surface)) << surface.id;
    const SurfaceMaterial copy = surface;
    EXPECT_EQ(relief, surface_grain(copy)) << surface.id;
  }
}

// A relief is made outside the lock. Threads that request it at the same time must get the same
// object.
TEST(Relief, R47_ThreadsThatAskAtOnceGetOneObject) {
  SurfaceMaterial surface = *find_surface("rough-paper");
  for (std::uint32_t seed = 901; seed < 904; ++seed) {
    surface.grain_seed = seed;  // not requested before
    std::vector<const HeightField*> got(6, nullptr);
    std::vector<std::thread> threads;
    threads.reserve(got.size());
    for (auto& one : got) threads.emplace_back([&one, &surface] { one = surface_grain(surface); });
    for (std::thread& thread : threads) thread.join();
    ASSERT_NE(got.front(), nullptr);
    for (const HeightField* one : got) EXPECT_EQ(one, got.front());
  }
}

TEST(Relief, AnotherHeightAndWavelengthIsTheSameShapeInAnotherSize) {
  SurfaceMaterial surface = *find_surface("rough-paper");
  const HeightField& as_is = *surface_grain(surface);
  surface.grain_um *= 2.0;
  surface.grain_mm *= 3.0;
  const HeightField& larger = *surface_grain(surface);
  for (int i = 0; i < 109; ++i) {
    const double at = 0.37 * i;
    const HeightField::Sample a = as_is.at({at, 0.5 * at});
    const HeightField::Sample b = larger.at({3.0 * at, 1.5 * at});
    EXPECT_NEAR(b.height_mm, 2.0 * a.height_mm, 1e-9);
    EXPECT_NEAR(b.slope.x, 2.0 / 3.0 * a.slope.x, 1e-9);
  }
  EXPECT_NEAR(larger.max_height_mm(), 2.0 * as_is.max_height_mm(), 1e-12);
  EXPECT_NEAR(larger.max_curvature_per_mm(), 2.0 / 9.0 * as_is.max_curvature_per_mm(), 1e-12);
}

TEST(Relief, APersonsOwnPictureTakesTheSizeThatTheSurfaceSays) {
  SurfaceMaterial mine{.id = "mine", .label = "Mine", .grain_um = 5.0, .grain_mm = 1.5};
  mine.grain_character = HeightCharacter::kPicture;
  mine.picture = std::make_shared<const HeightField>(HeightFieldSpec{.wavelength_mm = 1.0});
  const HeightField* relief = surface_grain(mine);
  ASSERT_NE(relief, nullptr);
  EXPECT_EQ(relief->spec().rms_um, 5.0);
  EXPECT_EQ(relief->spec().wavelength_mm, 1.5);
  EXPECT_EQ(relief, surface_grain(mine));
}

}  // namespace
}  // namespace felt::relief_test
