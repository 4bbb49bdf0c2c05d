#include "felt/tools/scene.h"

#include <gtest/gtest.h>

namespace felt::scene_test {
namespace {

// Pairs that somebody spoke of keep to a tool's strength as those by the rule do: nothing else says
// how strongly a person wants to feel the sheet.
TEST(Scene, StrengthReachesEveryPairAndTheGrain) {
  for (const Medium& medium : media()) {
    for (const SurfaceMaterial& sheet : surface_materials()) {
      for (const double strength : {0.0, 0.4, 1.0}) {
        const Medium felt = felt_with(medium, strength, 0.5 * strength);
        EXPECT_DOUBLE_EQ(friction_of(felt, sheet), strength * friction_of(medium, sheet))
            << medium.id << " on " << sheet.id;
        EXPECT_DOUBLE_EQ(felt.grain, 0.5 * strength * medium.grain);
      }
    }
  }
}

}  // namespace
}  // namespace felt::scene_test
