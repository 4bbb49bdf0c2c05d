#include "felt/geometry/height_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "felt/base/constants.h"

namespace felt::height_picture_test {
namespace {

HeightPicture picture_of(int width, int height, const std::function<double(double, double)>& at) {
  HeightPicture picture{width, height, {}, 0.0};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.heights.push_back(static_cast<float>(at((x + 0.5) / width, (y + 0.5) / height)));
    }
  }
  return picture;
}

double steepest_across(const HeightField& field, double x, double step_mm) {
  double largest = 0.0;
  for (int i = 0; i < 400; ++i) {
    const double y = 0.1 * i;
    largest = std::max(largest, std::abs(field.at({x + step_mm, y}).height_mm -
                                         field.at({x - step_mm, y}).height_mm));
  }
  return largest;
}

TEST(HeightPicture, APictureThatRepeatsComesOutAsItIs) {
  for (const int side : {64, 256, 700}) {
    const auto field = height_field_of(picture_of(side, side,
                                                  [](double x, double y) {
                                                    return 0.5 + 0.25 * std::cos(kTau * 5.0 * x) +
                                                           0.25 * std::cos(kTau * 3.0 * y);
                                                  }),
                                       {.tile_mm = 40.0, .height_um = 50.0});
    ASSERT_TRUE(field) << field.error().message;
    EXPECT_DOUBLE_EQ(field->tile_mm(), 40.0);
    for (int i = 0; i < 500; ++i) {
      const Point p{0.37 * i, 0.73 * i};
      const double meant =
          0.0125 * (std::cos(kTau * 5.0 * p.x / 40.0) + std::cos(kTau * 3.0 * p.y / 40.0));
      // The first height is at the middle of the first pixel: half a step of 0.16 mm.
      EXPECT_NEAR(field->at(p).height_mm, meant, 0.0035) << side;
    }
  }
}

TEST(HeightPicture, WhatDoesNotRepeatGetsNoSeam) {
  // A slope from black to white, with hills. Its opposite edges differ as much as possible.
  const auto field = height_field_of(picture_of(300, 200, [](double x, double y) {
    return 0.7 * x + 0.15 + 0.15 * std::sin(40.0 * x) * std::sin(31.0 * y);
  }));
  ASSERT_TRUE(field) << field.error().message;
  double elsewhere = 0.0;
  for (int i = 1; i < 8; ++i) {
    elsewhere = std::max(elsewhere, steepest_across(*field, 5.0 * i, 0.2));
  }
  EXPECT_LT(steepest_across(*field, 0.0, 0.2), 1.5 * elsewhere);
  EXPECT_GT(elsewhere, 0.0);
  EXPECT_EQ(field->spec().character, HeightCharacter::kPicture);
}

TEST(HeightPicture, R48_NoiseOfSinglePixelsIsTakenAway) {
  unsigned state = 1;
  const auto noise = [&state](double, double) {
    state = 1664525u * state + 1013904223u;
    return (state >> 16) / 65536.0;
  };
  const auto field = height_field_of(picture_of(512, 512, noise), {.tile_mm = 32.0});
  ASSERT_TRUE(field) << field.error().message;
  const double wave = 6.283185307179586 / field->shortest_wavelength_mm();
  EXPECT_LT(field->max_curvature_per_mm(), field->max_height_mm() * wave * wave);
}

TEST(HeightPicture, SaysWhatIsWrong) {
  const auto hilly = picture_of(32, 32, [](double x, double y) { return x * y; });
  EXPECT_FALSE(height_field_of(hilly, {.tile_mm = 0.0}));
  EXPECT_FALSE(height_field_of(hilly, {.tile_mm = std::nan("")}));
  EXPECT_FALSE(height_field_of(hilly, {.height_um = 1e9}));
  EXPECT_FALSE(height_field_of({}));
  const auto flat = height_field_of(picture_of(9, 9, [](double, double) { return 0.5; }));
  ASSERT_FALSE(flat);
  EXPECT_NE(flat.error().message.find("too fine to feel"), std::string::npos);
  HeightPicture few = hilly;
  few.heights.pop_back();
  EXPECT_FALSE(height_field_of(few));
  HeightPicture bad = hilly;
  bad.heights[7] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(height_field_of(bad));
  EXPECT_TRUE(height_field_of(picture_of(1, 300, [](double, double y) { return y; })));
}

}  // namespace
}  // namespace felt::height_picture_test
