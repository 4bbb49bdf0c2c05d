#include "felt/session/pose_track.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <vector>

#include "felt/base/constants.h"

namespace felt::pose_track_test {
namespace {

Event pen(std::int64_t ms, Vec3 at, std::optional<double> pressure = {},
          std::uint32_t buttons = 0) {
  return {ms * kMs, PenEvent{at, pressure, buttons}};
}
Event hand(std::int64_t ms, Vec3 at) {
  return {ms * kMs, HandEvent{at, {}, 0}};
}

/// Returns the poses of a script at each ms from `from` to `to`.
std::vector<ScriptPose> poses(const std::vector<Event>& events, std::int64_t from_ms,
                              std::int64_t to_ms) {
  PoseTrack track(events);
  std::vector<ScriptPose> all;
  for (std::int64_t ms = from_ms; ms <= to_ms; ++ms) all.push_back(track.at(ms * kMs));
  return all;
}

bool touches(const ScriptPose& pose) {
  return pose.position.z < 0.0 || pose.pressure.value_or(0.0) > 0.0;
}

/// Expects that no step is longer than a pen moves at this speed, in mm per ms.
void expect_no_jump(const std::vector<ScriptPose>& all, double mm_per_ms) {
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LE(norm(all[i].position - all[i - 1].position), mm_per_ms) << "at step " << i;
  }
}

TEST(PoseTrack, InterpolatesLinearlyAndIsExactAtTheEvents) {
  const auto all =
      poses({pen(0, {0, 0, 0.1}), pen(10, {1, 2, 0.3}), pen(20, {0.1, 0.7, 5})}, 0, 20);
  EXPECT_EQ(all[0].position, (Vec3{0, 0, 0.1}));
  EXPECT_DOUBLE_EQ(all[5].position.x, 0.5);
  EXPECT_DOUBLE_EQ(all[5].position.y, 1.0);
  EXPECT_DOUBLE_EQ(all[5].position.z, 0.2);
  EXPECT_EQ(all[10].position, (Vec3{1, 2, 0.3}));
  EXPECT_EQ(all[20].position, (Vec3{0.1, 0.7, 5}));
  for (const ScriptPose& pose : all) EXPECT_FALSE(pose.by_hand);
}

TEST(PoseTrack, TiltIsInterpolatedAndNotMadeUp) {
  const auto tilts = [](std::optional<double> a, std::optional<double> b) {
    std::vector<Event> events{pen(0, {0, 0, -1}), pen(10, {1, 0, -1})};
    std::get<PenEvent>(events[0].what).tilt_deg = a;
    std::get<PenEvent>(events[1].what).tilt_deg = b;
    std::vector<std::optional<double>> all;
    for (const ScriptPose& pose : poses(events, 0, 11)) all.push_back(pose.tilt_deg);
    return all;
  };
  const auto both = tilts(20.0, 60.0);
  EXPECT_EQ(both[0], 20.0);
  EXPECT_DOUBLE_EQ(both[5].value(), 40.0);
  EXPECT_EQ(both[10], 60.0);
  EXPECT_EQ(both[11], 60.0) << "while it is lifted, too";
  const auto first = tilts(20.0, std::nullopt), second = tilts(std::nullopt, 60.0);
  EXPECT_EQ(first[9], 20.0);
  EXPECT_EQ(first[10], std::nullopt);
  EXPECT_EQ(second[9], std::nullopt);
  EXPECT_EQ(second[10], 60.0);
  for (const auto& tilt : tilts({}, {})) EXPECT_EQ(tilt, std::nullopt);
}

TEST(PoseTrack, HandsTiltToo) {
  Event at = hand(0, {0, 0, 5});
  std::get<HandEvent>(at.what).tilt_deg = 33.0;
  const auto all = poses({at, hand(10, {0, 0, 5})}, 0, 5);
  EXPECT_EQ(all[5].tilt_deg, 33.0);
  EXPECT_TRUE(all[5].by_hand);
}

TEST(PoseTrack, ShortGapsAreStraightAlsoAcrossThePage) {
  const auto all = poses({pen(0, {0, 0, 5}), pen(60, {6, 0, -1}), pen(61, {6, 0, 1})}, 0, 61);
  EXPECT_DOUBLE_EQ(all[30].position.z, 2.0);
  EXPECT_DOUBLE_EQ(all[30].position.x, 3.0);
  EXPECT_FALSE(touches(all[49]));
  EXPECT_TRUE(touches(all[51]));
}

TEST(PoseTrack, TwoPosesInContactAreJoinedHoweverLongTheGap) {
  const auto all = poses({pen(0, {0, 0, -1}), pen(5000, {50, 0, -1})}, 0, 5000);
  for (const ScriptPose& pose : all) EXPECT_TRUE(touches(pose));
  EXPECT_DOUBLE_EQ(all[2500].position.x, 25.0);
}

TEST(PoseTrack, TwoPosesInTheAirAreNot) {
  const auto all = poses({pen(0, {0, 0, 0}), pen(5000, {50, 0, 3})}, 0, 5000);
  for (const ScriptPose& pose : all) EXPECT_FALSE(touches(pose));
}

TEST(PoseTrack, InALongGapThePenLandsAndLiftsUpright) {
  const auto all = poses(
      {pen(0, {0, 0, 50}), pen(1000, {40, 30, -2}), pen(1500, {50, 30, -2}), pen(2500, {0, 0, 80})},
      0, 2500);
  expect_no_jump(all, 0.25);
  for (std::size_t ms = 0; ms <= 2500; ++ms) {
    if (!touches(all[ms])) continue;
    EXPECT_NEAR(all[ms].position.y, 30.0, 1e-12) << ms;
    EXPECT_GE(all[ms].position.x, 40.0 - 1e-12) << ms;
    EXPECT_GT(ms, 950U);
    EXPECT_LT(ms, 1550U);
  }
  EXPECT_EQ(all[1000].position, (Vec3{40, 30, -2}));
  EXPECT_EQ(all[2500].position, (Vec3{0, 0, 80}));
}

TEST(PoseTrack, PressureDrawsNothingOnTheWayToWhereThePenIsPutDown) {
  const auto all = poses({pen(0, {0, 0, 0}, 0.0), pen(100, {10, 0, 0}, 0.5),
                          pen(200, {20, 0, 0}, 1.0), pen(300, {90, 0, 0}, 0.0)},
                         0, 300);
  for (std::size_t ms = 0; ms <= 300; ++ms) {
    EXPECT_EQ(touches(all[ms]), ms >= 100 && ms <= 200) << ms;
  }
  EXPECT_DOUBLE_EQ(*all[150].pressure, 0.75);
  EXPECT_EQ(*all[100].pressure, 0.5);
  EXPECT_EQ(*all[200].pressure, 1.0);
}

TEST(PoseTrack, APressureThatComesOrGoesIsNotMadeUp) {
  const auto all =
      poses({pen(0, {0, 0, -1}), pen(10, {1, 0, -1}, 0.5), pen(20, {2, 0, -1})}, 0, 20);
  EXPECT_FALSE(all[5].pressure);
  EXPECT_EQ(all[10].pressure, 0.5);
  EXPECT_FALSE(all[15].pressure);
}

TEST(PoseTrack, ButtonsChangeAtTheEvent) {
  const auto all = poses({pen(0, {0, 0, 1}, {}, 1), pen(10, {1, 0, 1}, {}, 2)}, 0, 12);
  EXPECT_EQ(all[9].buttons, 1U);
  EXPECT_EQ(all[10].buttons, 2U);
  EXPECT_EQ(all[12].buttons, 2U);
}

TEST(PoseTrack, FromPenToHandThePenStays) {
  const auto all = poses({pen(0, {0, 0, 1}), hand(10, {5, 0, 1}), hand(20, {6, 0, 1})}, 0, 20);
  EXPECT_EQ(all[9].position, (Vec3{0, 0, 1}));
  EXPECT_FALSE(all[9].by_hand);
  EXPECT_TRUE(all[10].by_hand);
  EXPECT_DOUBLE_EQ(all[15].position.x, 5.5);
}

TEST(PoseTrack, BeforeTheFirstPoseThePenIsAboveIt) {
  const Event tool{0, SelectTool{"pencil"}};
  const auto down = poses({tool, pen(1000, {7, 8, -1}), pen(1001, {7, 8, -1})}, 0, 1000);
  expect_no_jump(down, 0.2);
  EXPECT_EQ(down[0].position, (Vec3{7, 8, 5}));
  for (std::size_t ms = 0; ms <= 940; ++ms) EXPECT_FALSE(touches(down[ms])) << ms;
  EXPECT_TRUE(touches(down[1000]));

  const auto soon = poses({tool, pen(10, {7, 8, -0.5}), pen(11, {7, 8, -0.5})}, 0, 10);
  expect_no_jump(soon, 0.2);
  EXPECT_FALSE(touches(soon[0]));

  const auto pressing = poses({tool, pen(100, {7, 8, 0}, 0.5)}, 0, 100);
  for (std::size_t ms = 0; ms < 100; ++ms) EXPECT_FALSE(touches(pressing[ms])) << ms;
  EXPECT_TRUE(touches(pressing[100]));

  const auto above = poses({tool, pen(100, {7, 8, 1})}, 0, 100);
  EXPECT_EQ(above[0].position, (Vec3{7, 8, 1}));
}

TEST(PoseTrack, AfterTheLastPoseItStaysUntilTheLastEventAndIsLifted) {
  const auto all = poses(
      {pen(0, {0, 0, -1}, 0.5), pen(100, {10, 0, -1}, 0.5), {300 * kMs, UndoEvent{}}}, 0, 500);
  expect_no_jump(all, 0.2);
  for (std::size_t ms = 100; ms <= 300; ++ms) {
    EXPECT_EQ(all[ms].position, (Vec3{10, 0, -1})) << ms;
    EXPECT_EQ(all[ms].pressure, 0.5) << ms;
  }
  EXPECT_EQ(all[301].pressure, 0.0);
  EXPECT_FALSE(touches(all[350]));
  EXPECT_EQ(all[500].position, (Vec3{10, 0, 5}));
}

TEST(PoseTrack, AScriptWithoutPosesLeavesThePenInTheAir) {
  const auto all = poses({{0, UndoEvent{}}}, 0, 10);
  for (const ScriptPose& pose : all) EXPECT_FALSE(touches(pose));
  PoseTrack empty({});
  EXPECT_FALSE(empty.has_poses());
  EXPECT_FALSE(touches(empty.at(0)));
}

// For any script, the track is exact at each event that is the last of its time, and all numbers
// are finite. Between two events the pen is in contact only if that is allowed.
RC_GTEST_PROP(PoseTrackProperty, IsExactAtEventsAndInventsNoContact, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 12);
  std::vector<Event> events;
  std::int64_t ms = 0;
  for (std::size_t i = 0; i < count; ++i) {
    ms += *rc::gen::element<std::int64_t>(1, 2, 7, 40, 199, 201, 600);
    const double x = *rc::gen::inRange(-50, 50), z = *rc::gen::inRange(-3, 4);
    std::optional<double> pressure;
    if (*rc::gen::arbitrary<bool>()) pressure = *rc::gen::inRange(0, 3) / 2.0;
    events.push_back(pen(ms, {x, 0, z}, pressure));
  }
  PoseTrack track(events);
  std::size_t next = 0;
  for (std::int64_t now = 0; now <= ms + 600; ++now) {
    const ScriptPose pose = track.at(now * kMs);
    RC_ASSERT(is_finite(pose.position));
    if (next < count && events[next].time_ns == now * kMs) {
      const auto& event = std::get<PenEvent>(events[next].what);
      RC_ASSERT(pose.position == event.position);
      RC_ASSERT(pose.pressure == event.pressure);
      ++next;
    } else if (next > 0 && next < count) {
      const auto& a = std::get<PenEvent>(events[next - 1].what);
      const auto& b = std::get<PenEvent>(events[next].what);
      const bool pressed = a.pressure.value_or(0) > 0 && b.pressure.value_or(0) > 0;
      const bool deep = a.position.z < 0 || b.position.z < 0;
      RC_ASSERT(pressed || deep || !touches(pose));
      if (a.position.z < 0 && b.position.z < 0) RC_ASSERT(touches(pose));
    }
  }
  RC_ASSERT(!touches(track.at((ms + 600) * kMs)));
}

}  // namespace
}  // namespace felt::pose_track_test
