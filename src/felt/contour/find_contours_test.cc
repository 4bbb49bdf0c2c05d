#include "felt/contour/find_contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "felt/base/constants.h"
#include "felt/geometry/polyline.h"

namespace felt::find_contours_test {
namespace {

using Contours = std::vector<std::vector<Point>>;

constexpr double kMmPerPx = 0.1;

/// Returns a picture of 60 mm by 60 mm: `grey` is the value at a position in mm. Noise is added.
GreyPicture picture_of(const std::function<double(Point)>& grey, double noise = 6.0) {
  constexpr int kSide = 600;
  GreyPicture picture{kSide, kSide, {}};
  std::mt19937 random(7);
  std::normal_distribution<double> error(0.0, noise);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double value = grey({kMmPerPx * (x + 0.5), kMmPerPx * (y + 0.5)}) + error(random);
      picture.grey.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))));
    }
  }
  return picture;
}

/// Returns the contours in mm.
Contours found_in(const GreyPicture& picture) {
  Contours contours = find_contours(picture, {.mm_per_px = kMmPerPx}).value();
  for (auto& contour : contours) {
    for (Point& p : contour) p = {kMmPerPx * p.x, kMmPerPx * p.y};
  }
  return contours;
}

double length_of(const std::vector<Point>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

constexpr Point kMiddle{30, 30};
constexpr double kRadiusMm = 20.0;

/// Expects one contour, the circle, closed.
void expect_circle(const Contours& contours) {
  ASSERT_EQ(contours.size(), 1u);
  const std::vector<Point>& circle = contours.front();
  EXPECT_NEAR(length_of(circle), kTau * kRadiusMm, 0.5);
  EXPECT_EQ(circle.front(), circle.back());
  for (const Point& p : circle) EXPECT_NEAR(distance(p, kMiddle), kRadiusMm, 0.12);
}

TEST(FindContours, R74_TheEdgeOfADiskIsOneClosedLine) {
  for (const double inside : {60.0, 150.0, 255.0}) {
    SCOPED_TRACE(inside);
    expect_circle(found_in(
        picture_of([&](Point p) { return distance(p, kMiddle) < kRadiusMm ? inside : 205.0; })));
  }
}

TEST(FindContours, R74_ALineIsOneContourInItsMiddleDarkOrLight) {
  for (const double width_mm : {0.3, 0.6, 1.0, 1.4}) {
    for (const bool is_dark : {true, false}) {
      SCOPED_TRACE(width_mm);
      expect_circle(found_in(picture_of([&](Point p) {
        const bool is_line = std::fabs(distance(p, kMiddle) - kRadiusMm) < 0.5 * width_mm;
        return is_line == is_dark ? 90.0 : 200.0;
      })));
    }
  }
}

TEST(FindContours, R74_NoiseAndShadingHaveNone) {
  for (const double noise : {0.0, 5.0, 20.0}) {
    EXPECT_TRUE(found_in(picture_of([](Point) { return 128.0; }, noise)).empty()) << noise;
    EXPECT_TRUE(found_in(picture_of([](Point p) { return 2.0 * (p.x + p.y); }, noise)).empty());
  }
}

TEST(FindContours, SmallAndWrongPictures) {
  for (const int side : {1, 2, 3, 5}) {
    const auto count = static_cast<std::size_t>(side * side);
    EXPECT_TRUE(find_contours({side, side, std::vector<std::uint8_t>(count)}, {}).value().empty());
  }
  EXPECT_FALSE(find_contours({}, {}));
  EXPECT_FALSE(find_contours({2, 2, {1, 2, 3}}, {}));
  EXPECT_FALSE(find_contours({-1, -1, {1}}, {}));
  const GreyPicture one{1, 1, {0}};
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_FALSE(find_contours(one, {.mm_per_px = bad}));
  }
  EXPECT_FALSE(find_contours(one, {.contrast = 0.0}));
  EXPECT_FALSE(find_contours(one, {.min_mm = std::nan("")}));
}

TEST(FindContours, TheLongestAreKeptWithinTheLimits) {
  const GreyPicture stripes = picture_of(
      [](Point p) { return std::fmod(p.y, 10.0) < 0.5 && p.x < 12.0 + p.y ? 50.0 : 200.0; });
  const auto all = find_contours(stripes, {.mm_per_px = kMmPerPx}).value();
  const auto some = find_contours(stripes, {.mm_per_px = kMmPerPx, .max_contours = 2}).value();
  ASSERT_GT(all.size(), 3u);
  EXPECT_EQ(some, Contours(all.begin(), all.begin() + 2));
  EXPECT_TRUE(find_contours(stripes, {.mm_per_px = kMmPerPx, .max_points = 1}).value().empty());
}

}  // namespace
}  // namespace felt::find_contours_test
