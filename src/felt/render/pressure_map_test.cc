#include "felt/render/pressure_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "felt/base/hash.h"

namespace felt::pressure_map_test {
namespace {

/// Uses the generator's numbers directly, because distributions differ from library to library.
class Chance {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next_()) * 0x1p-32);
  }
  int whole(double low, double high) { return static_cast<int>(between(low, high)); }

 private:
  std::mt19937 next_{5};
};

/// Returns a random path that starts in the area and often leaves it; radii change if
/// `has_changing_width`.
std::vector<TipAt> random_way(Chance& chance, PixelRect area, bool has_changing_width) {
  TipAt tip{{chance.between(area.x0, area.x1), chance.between(area.y0, area.y1)},
            chance.between(0.1, 30.0)};
  std::vector<TipAt> way;
  for (int i = 0; i < 20; ++i) {
    tip.tone = chance.between(0.0, 1.0);
    way.push_back(tip);
    tip.center_px.x += chance.between(-20.0, 20.0);
    tip.center_px.y += chance.between(-20.0, 20.0);
    const double wider = chance.between(-3.0, 3.0);
    if (has_changing_width) tip.radius_px = std::max(0.05, tip.radius_px + wider);
  }
  return way;
}

// Compares with a known value, which all processors, with or without wide vectors (wide_vectors.h),
// and all compilers must compute. Otherwise a picture would depend on the machine (R47).
TEST(PressureMap, R47_IsTheSameOnEveryProcessor) {
  Chance chance;
  PressureMap map;
  Fnv1a all;
  for (int n = 0; n < 600; ++n) {
    PixelRect area{chance.whole(-50, 50), chance.whole(-50, 50), 0, 0};
    area.x1 = area.x0 + chance.whole(1, 300);
    area.y1 = area.y0 + chance.whole(1, 200);
    map.begin(area, chance.between(-0.2, 1.0));
    map.lay(random_way(chance, area, n % 2 == 1));
    for (int y = area.y0; y < area.y1; ++y) {
      for (int x = 0; x < area.width(); ++x) all.add_value(map.row(y)[x]);
    }
  }
  EXPECT_EQ(all.value(), 6280547046153087826U);
}

}  // namespace
}  // namespace felt::pressure_map_test
