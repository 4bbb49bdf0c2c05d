#include "felt/tools/guide_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "felt/base/constants.h"

namespace felt::guide_track_test {
namespace {

PenSample pen_at(Point p, double z = -1.0, std::int64_t time_ns = 0) {
  return {.time_ns = time_ns, .position = {p.x, p.y, z}, .velocity = {}, .pressure = {}};
}

/// Returns the point of the piece at the position of the pen.
Point place_of(const GuideTrack& track) {
  const GuidePiece& piece = track.guide().piece();
  const double at = piece.at_mm / piece.spacing_mm;
  const auto i = static_cast<std::size_t>(at);
  return lerp(piece.points[i], piece.points[i + 1], at - std::floor(at));
}

GuideLine circle(double radius_mm) {
  GuideLine line{.kind = GuideKind::kGroove, .is_closed = true};
  for (int i = 0; i < 200; ++i) {
    const double angle = kTau * i / 200;
    line.points.push_back({radius_mm * std::cos(angle), radius_mm * std::sin(angle)});
  }
  return line;
}

/// Returns a figure of eight that crosses itself at the origin.
Point eight(double t) {
  return {30.0 * std::sin(kTau * t), 15.0 * std::sin(2.0 * kTau * t)};
}

TEST(GuideTrack, FollowsThePenRoundAClosedPath) {
  GuideTrack track(circle(30.0), 1);
  for (int i = 0; i <= 3000; ++i) {
    const double angle = 3.0 * kTau * i / 3000;
    const Vec out{std::cos(angle), std::sin(angle)};
    track.update(pen_at(Point{} + 31.0 * out));
    ASSERT_LT(distance(place_of(track), Point{} + 30.0 * out), 0.05) << i;
    ASSERT_EQ(track.guide().piece().gain, 1.0);
    ASSERT_NEAR(track.guide().distance_mm(Point{} + 31.0 * out), 1.0, 0.02);
  }
  EXPECT_EQ(track.hold(), 1U) << "never another part of the path";
}

TEST(GuideTrack, KeepsItsBranchWhereThePathCrossesItself) {
  GuideLine line{.kind = GuideKind::kGroove, .is_closed = true};
  for (int i = 0; i < 400; ++i) line.points.push_back(eight(i / 400.0));
  GuideTrack track(line, 1);
  track.update(pen_at(eight(0.1), 5.0));
  const std::uint32_t hold = track.hold();
  for (int i = 0; i <= 4000; ++i) {
    // Off the path by 1 mm, so that the other branch is nearer at times.
    const double t = 0.1 + i / 4000.0;
    const Vec along = normalized(eight(t + 1e-4) - eight(t));
    track.update(pen_at(eight(t) + 1.0 * perp(along)));
    ASSERT_LT(distance(place_of(track), eight(t)), 1.5) << i;
  }
  EXPECT_EQ(track.hold(), hold);
  // A pen that leaves the path and comes back finds the nearest position again.
  track.update(pen_at({30.0, 60.0}));
  track.update(pen_at(eight(0.75)));
  EXPECT_LT(distance(place_of(track), eight(0.75)), 0.1);
  EXPECT_GT(track.hold(), hold);
}

TEST(GuideTrack, EndsWithAnOpenPath) {
  GuideTrack track({.kind = GuideKind::kGroove, .points = {{0.0, 0.0}, {20.0, 0.0}}}, 1);
  const auto gain_at = [&](double x) {
    track.update(pen_at({x, 1.0}, 1.0));
    return track.guide().piece().gain;
  };
  EXPECT_EQ(gain_at(0.0), 1.0);
  EXPECT_EQ(gain_at(20.0), 1.0);
  EXPECT_NEAR(gain_at(22.5), 0.5, 1e-9);
  EXPECT_EQ(gain_at(25.0), 0.0);
  EXPECT_NEAR(gain_at(-2.5), 0.5, 1e-9);
  EXPECT_EQ(gain_at(-100.0), 0.0);
}

TEST(GuideTrack, KnowsHowFastTheTeacherWas) {
  GuideLine line{.kind = GuideKind::kTeacher};
  for (int i = 0; i <= 100; ++i) {
    line.points.push_back({0.5 * i, 0.0});
    line.times_ms.push_back(i <= 50 ? 10.0 * i : 500.0 + 20.0 * (i - 50));
  }
  GuideTrack track(line, 1);
  const auto speed_at = [&](double x) {
    track.update(pen_at({x, 0.0}, 1.0));
    const GuidePiece& piece = track.guide().piece();
    return piece.speeds_mm_per_s[static_cast<std::size_t>(piece.at_mm / piece.spacing_mm + 0.25)];
  };
  EXPECT_NEAR(speed_at(10.0), 50.0, 1e-3);
  EXPECT_NEAR(speed_at(40.0), 25.0, 1e-3);
  EXPECT_EQ(speed_at(50.0), 0.0F) << "the end";
  EXPECT_EQ(speed_at(54.0), 0.0F);
}

TEST(GuideTrack, AnyPathGivesNumbers) {
  for (const GuideLine& line :
       {GuideLine{.kind = GuideKind::kGroove, .points = {{0, 0}, {1, 0}}},
        GuideLine{.kind = GuideKind::kGroove, .points = {{0, 0}, {1, 0}}, .is_closed = true},
        GuideLine{.kind = GuideKind::kTeacher,
        .points = {{0, 0}, {0, 0}, {5, 0}, {5, 0}},
        .times_ms = {0, 0, 0, 7}},
        GuideLine{.kind = GuideKind::kErrorAmplifying, .points = {{1e9, 1e9}, {1e9, 1e9 - 9}}}}) {
    ASSERT_TRUE(check_guide(line));
    GuideTrack track(line, 1);
    ForceMemory memory;
    for (const Point p : {line.points[0], line.points[0] + Vec{1.0, 2.0}, Point{-1e9, 1e9}}) {
      track.update(pen_at(p));
      for (int i = 0; i < 10; ++i) {
        memory.begin_tick(0.001);
        const Force force = track.guide()(pen_at(p), memory);
        EXPECT_TRUE(norm(force) <= 1.0) << p.x;
      }
    }
  }
}

TEST(GuideLine, NamesTheKeyThatIsWrong) {
  const auto message = [](const GuideLine& line) {
    const Result<void> checked = check_guide(line);
    return checked ? std::string() : checked.error().message;
  };
  const GuideLine good{
      .kind = GuideKind::kTeacher, .points = {{0, 0}, {9, 0}}, .times_ms = {0, 10}};
  EXPECT_EQ(message(good), "");
  EXPECT_EQ(message({}), "");
  GuideLine bad = good;
  bad.strength = 1.5;
  EXPECT_EQ(message(bad), "strength: is not from 0 to 1");
  bad = good;
  bad.times_ms = {10, 0};
  EXPECT_EQ(message(bad), "times_ms[1]: is before the time of the previous point");
  bad.times_ms = {10};
  EXPECT_EQ(message(bad), "times_ms: has 1 times for 2 points");
  bad = good;
  bad.is_closed = true;
  EXPECT_EQ(message(bad), "closed: the path of a teacher is not closed");
  bad = good;
  bad.points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message(bad), "points[1]: a coordinate exceeds 1e9 mm");
  bad.points[1].x = 30'000.0;
  EXPECT_EQ(message(bad), "points: the length of the path is not from 1 mm to 20 m");
  bad.points.pop_back();
  EXPECT_EQ(message(bad), "points: a guide has 2 to 20000 points, but there are 1");
  bad.kind = GuideKind::kNone;
  EXPECT_EQ(message(bad), "points: a guide of the kind \"none\" has no points");
}

TEST(AsNeededGain, GrowsWithTheErrorAndFades) {
  AsNeededGain gain;
  EXPECT_EQ(gain.gain(), 0.0);
  for (int i = 0; i < 20'000; ++i) gain.update(0.25, 0.001);
  EXPECT_NEAR(gain.gain(), 0.5, 1e-3);
  for (int i = 0; i < 20'000; ++i) gain.update(9.0, 0.001);
  EXPECT_EQ(gain.gain(), 1.0);
  for (int i = 0; i < 2'000; ++i) gain.update(0.0, 0.001);
  EXPECT_NEAR(gain.gain(), std::exp(-1.0), 1e-3);
  const double before = gain.gain();
  gain.update(std::numeric_limits<double>::quiet_NaN(), 0.001);
  gain.update(1.0, -1.0);
  EXPECT_EQ(gain.gain(), before);
}

TEST(GuideTrack, HelpsAsNeeded) {
  GuideLine line{.kind = GuideKind::kAsNeeded, .points = {{0.0, 0.0}, {50.0, 0.0}}};
  GuideTrack track(line, 1);
  std::int64_t track_ns = 0;
  const auto draw = [&](double off_mm, double z) {
    for (int i = 0; i < 4000; ++i) {
      track.update(pen_at({25.0, off_mm}, z, track_ns += 1'000'000));
    }
    return track.guide().piece().gain;
  };
  EXPECT_EQ(draw(1.0, 1.0), 0.0) << "a pen in the air makes no error";
  const double help = draw(0.4, -1.0);
  EXPECT_GT(help, 0.6);
  EXPECT_LT(draw(0.0, -1.0), 0.2 * help);
}

}  // namespace
}  // namespace felt::guide_track_test
