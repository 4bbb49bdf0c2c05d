#include "felt/solid/extrude_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "felt/solid/body_parts.h"
#include "felt/solid/surface_hit.h"
#include "felt/solid/testing/random_bodies.h"
#include "felt/solid/testing/surface.h"
#include "felt/solid/view_frame.h"

namespace felt::extrude_body_test {
namespace {

constexpr Vec3 kFromFront{0.0, 0.0, -1.0};

std::vector<Vec3> circle(const ViewFrame& frame, Point centre, double radius) {
  std::vector<Vec3> path;
  for (int i = 0; i < 40; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 40;
    path.push_back(frame.to_solid(centre + radius * Vec{std::cos(a), std::sin(a)}, 0.0));
  }
  return path;
}

/// A horn that rises from the plane z = `foot`, in the plane y = 0.
std::vector<Vec3> horn(double half_width, double foot, double height) {
  std::vector<Vec3> path;
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 20.0 - 1.0;  // -1..1
    path.push_back({half_width * t, 0.0, foot + height * (1.0 - t * t)});
  }
  return path;
}

void expect_sound(const SolidBody& body) {
  const testing::SurfaceReport report = testing::examine(testing::surface_of(body));
  EXPECT_EQ(report.fault, "");
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.euler, 2 - 2 * body.holes);
}

TEST(ExtrudeBody, AHornHasTheHeightOfItsProfile) {
  const SolidBody ball = testing::ball(20.0);
  const auto path = circle(view_frame(kFromFront), {0, 0}, 5.0);
  const Result<SolidBody> body = extrude_body(ball, path, horn(5.0, 19.4, 15.0), kFromFront);
  ASSERT_TRUE(body) << body.error().message;
  expect_sound(*body);
  double top = 0.0;
  for (const Vec3& p : body->points) top = std::max(top, p.z);
  EXPECT_NEAR(top, 19.4 + 15.0, 0.3);
  // A paraboloid on the ring, less the cap of the ball inside it.
  const double cap = std::numbers::pi * 0.635 * 0.635 * (20.0 - 0.635 / 3.0);
  EXPECT_NEAR(volume_mm3(*body) - volume_mm3(ball), 0.5 * std::numbers::pi * 25 * 15 - cap, 35.0);
  EXPECT_EQ(body->stroke, ball.stroke);
}

TEST(ExtrudeBody, TheProfileIsFittedToTheRing) {
  const SolidBody ball = testing::ball(20.0);
  const auto path = circle(view_frame(kFromFront), {0, 0}, 5.0);
  std::vector<Vec3> beside =
      horn(10.0, 0.0, 30.0);  // twice the size, elsewhere, the other way round
  for (Vec3& p : beside) p = p + Vec3{40, 0, 7};
  std::reverse(beside.begin(), beside.end());
  const Result<SolidBody> body = extrude_body(ball, path, beside, kFromFront);
  ASSERT_TRUE(body) << body.error().message;
  double top = 0.0;
  for (const Vec3& p : body->points) top = std::max(top, p.z);
  EXPECT_NEAR(top, 19.4 + 15.0, 0.3);
}

TEST(ExtrudeBody, RefusesWithASentence) {
  const SolidBody ball = testing::ball(20.0);
  const ViewFrame front = view_frame(kFromFront);
  const auto error = [&](const std::vector<Vec3>& path, const std::vector<Vec3>& profile) {
    const Result<SolidBody> result = extrude_body(ball, path, profile, kFromFront);
    return result ? std::string() : result.error().message;
  };
  const auto ring = circle(front, {0, 0}, 5.0);
  EXPECT_EQ(error(circle(front, {18, 0}, 5.0), horn(5, 20, 10)),
            "the closed line is not wholly on the body");
  EXPECT_EQ(error(ring, horn(5, 20, -10)), "the profile leads into the body");
  EXPECT_EQ(error(ring, horn(5, 20, 0.1)), "the profile is too flat");
  EXPECT_EQ(error({{0, 0, 0}, {1, 0, 0}}, horn(5, 20, 10)), "the closed line has too few points");
  EXPECT_EQ(error({{-5, -5, 0}, {5, 5, 0}, {5, -5, 0}, {-5, 5, 0}}, horn(5, 20, 10)),
            "the closed line crosses itself");
  EXPECT_EQ(error(ring, {{0, 0, 20}, {0, 0, 40}, {0, 0, 20}}),
            "the profile begins and ends at the same point");
}

// Rings at random points of random bodies, seen from random directions, with bent horns.
TEST(ExtrudeBody, R60_AddsVolumeAndKeepsOneBody) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const SolidBody body = testing::random_body(random, 1500);
    const Vec3 view = testing::random_direction(random);
    const ViewFrame frame = view_frame(view);
    const Point at = frame.to_picture(random.between(0.0, 0.5) *
                                      body.points[static_cast<std::size_t>(random.between(
                                          0, 0.999 * static_cast<double>(body.points.size())))]);
    const auto path = circle(frame, at, random.between(1.5, 4.0));
    const auto hit = hit_from_eye(body, frame.to_solid(at, 0.0), view);
    const double slant = random.between(-1.0, 1.0), height = random.between(2.0, 20.0);
    std::vector<Vec3> profile;
    for (int i = 0; i <= 40 && hit; ++i) {
      const double t = i / 20.0 - 1.0, rise = 1.0 - t * t;
      profile.push_back(hit->point + (3.0 * t + slant * height * rise * rise) * frame.right +
                        height * rise * hit->normal);
    }
    const Result<SolidBody> result = extrude_body(body, path, profile, view);
    if (!result) {
      ++refused;
      std::printf("seed %d: %s\n", static_cast<int>(seed), result.error().message.c_str());
      continue;
    }
    expect_sound(*result);
    EXPECT_GT(volume_mm3(*result), volume_mm3(body)) << "seed " << seed;
    EXPECT_EQ(result->holes, body.holes) << "seed " << seed;
    const Result<SolidBody> again = extrude_body(body, path, profile, view);
    EXPECT_TRUE(again && again->points == result->points && again->triangles == result->triangles)
        << "seed " << seed;
  }
  EXPECT_LE(refused, 4);
}

}  // namespace
}  // namespace felt::extrude_body_test
