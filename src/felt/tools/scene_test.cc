#include "felt/tools/scene.h"

#include <gtest/gtest.h>

namespace felt::scene_test {
namespace {

// A tool's strength also scales explicit pair frictions, because no other option sets how strongly
// the user feels the surface.
TEST(Scene, StrengthReachesEveryPairAndTheGrain) {
  for (const Medium& medium : media()) {
    for (const SurfaceMaterial& surface : surface_materials()) {
      for (const double strength : {0.0, 0.4, 1.0}) {
        const Medium felt = scaled_medium(medium, strength, 0.5 * strength);
        EXPECT_DOUBLE_EQ(friction_of(felt, surface), strength * friction_of(medium, surface))
            << medium.id << " on " << surface.id;
        EXPECT_DOUBLE_EQ(felt.grain, 0.5 * strength * medium.grain);
      }
    }
  }
}

}  // namespace
}  // namespace felt::scene_test
