#include "felt/geometry/height_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace felt::height_field_test {
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
  EXPECT_EQ(sum, 3217025270u) << "another field than the one that drawings were made on";
}

constexpr HeightCharacter kDrawn[] = {HeightCharacter::kRough, HeightCharacter::kWeave,
                                      HeightCharacter::kFibres, HeightCharacter::kWood};

TEST(HeightField, R47_EveryCharacterTilesIsSmoothAndKeepsToItsBounds) {
  for (const HeightCharacter character : kDrawn) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
      const HeightField field(
          {.wavelength_mm = 1.5, .rms_um = 10.0, .seed = seed, .character = character});
      constexpr double kH = 1e-5;
      double squares = 0.0;
      constexpr int kCount = 20'000;
      for (int i = 0; i < kCount; ++i) {
        const Point p{1.37 * i - 9e3, 2.71 * i - 2e4};
        const auto here = field.at(p);
        const auto there = field.at({p.x, p.y + kH});
        const auto tile = field.at({p.x - 2 * field.tile_mm(), p.y + field.tile_mm()});
        ASSERT_NEAR(here.height_mm, tile.height_mm, 1e-12);
        ASSERT_NEAR((there.height_mm - here.height_mm) / kH, here.slope.y, 1e-5);
        ASSERT_LE(std::abs(here.height_mm), field.max_height_mm());
        ASSERT_LE(norm(here.slope), field.max_slope());
        ASSERT_LE(norm(there.slope - here.slope) / kH, field.max_curvature_per_mm());
        squares += here.height_mm * here.height_mm;
      }
      EXPECT_NEAR(1e3 * std::sqrt(squares / kCount), 10.0, 0.5) << "seed " << seed;
      // Compares the stiffness of the steepest place with that of a single wave of the shortest
      // length.
      const double wave = 6.283185307179586 / field.shortest_wavelength_mm();
      EXPECT_LT(field.max_curvature_per_mm(), field.max_height_mm() * wave * wave);
    }
  }
}

TEST(HeightField, R48_NoCharacterHasWavesShorterThanItSays) {
  constexpr int kSide = HeightField::kSide;
  for (const HeightCharacter character : kDrawn) {
    const HeightField field(
        {.wavelength_mm = 1.0, .rms_um = 10.0, .seed = 4, .character = character});
    const double step = field.tile_mm() / kSide;
    std::vector<double> height;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) height.push_back(field.at({step * x, step * y}).height_mm);
    }
    std::vector<double> sine(kSide), cosine(kSide);
    for (int k = 0; k < kSide; ++k) {
      sine[static_cast<std::size_t>(k)] = std::sin(6.283185307179586 * k / kSide);
      cosine[static_cast<std::size_t>(k)] = std::cos(6.283185307179586 * k / kSide);
    }
    // Uses the definition of the Fourier transform, along some directions.
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {2, -1}, {-1, 3}}) {
      double within = 0.0, beyond = 0.0;
      for (int n = 1; n * std::max(std::abs(dx), std::abs(dy)) <= 100; ++n) {
        double re = 0.0, im = 0.0;
        for (int y = 0; y < kSide; ++y) {
          for (int x = 0; x < kSide; ++x) {
            const auto turn = static_cast<std::size_t>((n * (dx * x + dy * y)) & (kSide - 1));
            const double h = height[static_cast<std::size_t>(y * kSide + x)];
            re += h * cosine[turn];
            im += h * sine[turn];
          }
        }
        const bool is_long =
            n * std::hypot(dx, dy) < HeightField::kWavesPerTile * HeightField::kBand;
        (is_long ? within : beyond) += re * re + im * im;
      }
      EXPECT_GT(within, 0.0);
      EXPECT_LT(beyond, 1e-10 * within) << static_cast<int>(character) << " " << dx << " " << dy;
    }
  }
}

TEST(HeightField, R47_CharactersAreTheSameOnEveryMachine) {
  const std::uint32_t known[] = {2310910186u, 3695850301u, 1508433506u, 1062294258u};
  for (std::size_t i = 0; i < std::size(kDrawn); ++i) {
    const HeightField field(
        {.wavelength_mm = 2.0, .rms_um = 10.0, .seed = 5, .character = kDrawn[i]});
    std::uint32_t sum = 0;
    for (int j = 0; j < 4096; ++j) {
      const Point p{0.5 * (j % 64), 0.5 * (j / 64)};
      sum = 31 * sum + static_cast<std::uint32_t>(std::llround(1e9 * field.at(p).height_mm));
    }
    EXPECT_EQ(sum, known[i]) << "another field than the one that drawings were made on";
  }
}

TEST(HeightField, WoodRunsAlongXAndAWeaveInBothDirections) {
  // Mean square slope along y, divided by that along x.
  const auto across = [](HeightCharacter character) {
    const HeightField field(
        {.wavelength_mm = 1.5, .rms_um = 10.0, .seed = 2, .character = character});
    double x = 0.0, y = 0.0;
    for (int i = 0; i < 20'000; ++i) {
      const Vec slope = field.at({1.37 * i, 2.71 * i}).slope;
      x += slope.x * slope.x;
      y += slope.y * slope.y;
    }
    return y / x;
  };
  EXPECT_GT(across(HeightCharacter::kWood), 5.0);
  EXPECT_NEAR(across(HeightCharacter::kWeave), 1.0, 0.35);
  EXPECT_NEAR(across(HeightCharacter::kFibres), 1.0, 0.5);
}

TEST(HeightField, BadInputIsFlat) {
  const HeightField none({.wavelength_mm = 0.0, .rms_um = 3.0});
  EXPECT_EQ(none.at({1, 1}).height_mm, 0.0);
  EXPECT_EQ(HeightField({}, {1.0, 2.0}).at({1, 1}).height_mm, 0.0);
  const std::vector<double> bad(std::size_t{HeightField::kSide} * HeightField::kSide, std::nan(""));
  EXPECT_EQ(HeightField({}, bad).at({1, 1}).height_mm, 0.0);
  const HeightField field({});
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(field.at({inf, 1}).height_mm, 0.0);
  EXPECT_EQ(field.at({1, std::nan("")}).height_mm, 0.0);
  EXPECT_EQ(field.at({1, -1e300}).height_mm, 0.0);
}

}  // namespace
}  // namespace felt::height_field_test
