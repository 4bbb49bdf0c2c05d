#include "felt/geometry/height_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace felt {
namespace {

TEST(HeightField, R47_TilesWithoutASeamAndIsSmooth) {
  const HeightField field({.wavelength_mm = 1.0, .rms_um = 3.0, .seed = 7});
  constexpr double kH = 1e-5;
  double squares = 0.0;
  int count = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Point p{1.37 * i - 9e3, 2.71 * i - 2e4};
    const auto here = field.at(p);
    const auto there = field.at({p.x + kH, p.y});
    const auto tile = field.at({p.x + field.tile_mm(), p.y - 3 * field.tile_mm()});
    ASSERT_NEAR(here.height_mm, tile.height_mm, 1e-12);
    ASSERT_NEAR((there.height_mm - here.height_mm) / kH, here.slope.x, 1e-5);
    ASSERT_LE(std::abs(here.height_mm), field.max_height_mm());
    ASSERT_LE(norm(here.slope), field.max_slope());
    ASSERT_LE(norm(there.slope - here.slope) / kH, field.max_curvature_per_mm());
    squares += here.height_mm * here.height_mm;
    ++count;
  }
  EXPECT_NEAR(1e3 * std::sqrt(squares / count), 3.0, 0.1);
}

TEST(HeightField, R47_TheSameSeedIsTheSameFieldOnEveryMachine) {
  const HeightField a({.wavelength_mm = 2.0, .rms_um = 10.0, .seed = 5});
  const HeightField b({.wavelength_mm = 2.0, .rms_um = 10.0, .seed = 5});
  const HeightField c({.wavelength_mm = 2.0, .rms_um = 10.0, .seed = 6});
  double difference = 0.0;
  std::uint32_t sum = 0;
  for (int i = 0; i < 4096; ++i) {
    const Point p{0.5 * (i % 64), 0.5 * (i / 64)};
    ASSERT_EQ(a.at(p).height_mm, b.at(p).height_mm);
    difference = std::max(difference, std::abs(a.at(p).height_mm - c.at(p).height_mm));
    sum = 31 * sum + static_cast<std::uint32_t>(std::llround(1e9 * a.at(p).height_mm));
  }
  EXPECT_GT(difference, 0.01);
  EXPECT_EQ(sum, 943771449u) << "another field than the one that drawings were made on";
}

TEST(HeightField, BadInputIsFlat) {
  const HeightField none({.wavelength_mm = 0.0, .rms_um = 3.0});
  EXPECT_EQ(none.at({1, 1}).height_mm, 0.0);
  const HeightField field({});
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(field.at({inf, 1}).height_mm, 0.0);
  EXPECT_EQ(field.at({1, std::nan("")}).height_mm, 0.0);
  EXPECT_EQ(field.at({1, -1e300}).height_mm, 0.0);
}

}  // namespace
}  // namespace felt
