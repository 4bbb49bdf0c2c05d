#include "felt/devices/pantograph/board.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace felt::pantograph::board_test {
namespace {

template <std::size_t Size>
std::array<int, Size> numbers(const std::array<std::byte, Size>& frame) {
  std::array<int, Size> said{};
  for (std::size_t i = 0; i < Size; ++i) said[i] = std::to_integer<int>(frame[i]);
  return said;
}

std::array<std::byte, kReplyBytes> reply(float first, float second) {
  std::array<std::byte, kReplyBytes> bytes{static_cast<std::byte>(kDeviceId)};
  std::size_t at = 1;
  for (const float value : {first, second}) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (std::size_t i = 0; i < 4; ++i) bytes[at++] = static_cast<std::byte>(bits >> (8 * i));
  }
  return bytes;
}

// Compares each byte with the frame in docs/design/devices.md#pantograph-board: type 1, device 5;
// motors on ports 1 and 2 (mask 3), all clockwise; encoders the same; no sensors, no PWM; offsets
// of 180 and 0 degrees, 13824 counts.
TEST(Board, TheFirstMakeIsSetUpAsItsExampleDoes) {
  EXPECT_EQ(numbers(setup_frame(*find_board_model("v1"))),
            (std::array<int, 26>{1,    5, 3, 0,    0,    3, 0, 0, 0, 0, 0, 0,    0x34,
                                 0x43, 0, 0, 0x58, 0x46, 0, 0, 0, 0, 0, 0, 0x58, 0x46}));
  EXPECT_EQ(numbers(reset_frame()), (std::array<int, 2>{0, 0}));
}

// Floats are sent and received in port sequence. Motor 1 of the later board versions is on port 2.
TEST(Board, TorquesAndAnglesGoByPort) {
  const BoardModel& later = *find_board_model("v2");
  EXPECT_EQ(numbers(torque_frame(later, {1.0, -2.0})),
            (std::array<int, 10>{2, 5, 0, 0, 0, 0xC0, 0, 0, 0x80, 0x3F}));
  std::array<double, 2> angles{};
  ASSERT_TRUE(read_angles(later, reply(-61.0F, 241.0F), angles));
  EXPECT_NEAR(angles[0], 241.0 * M_PI / 180.0, 1e-6);
  EXPECT_NEAR(angles[1], -61.0 * M_PI / 180.0, 1e-6);
  const BoardModel& first = *find_board_model("v1");
  EXPECT_EQ(numbers(torque_frame(first, {10.0, 0.0})),
            (std::array<int, 10>{2, 5, 0, 0, 0x80, 0x3F, 0, 0, 0, 0}))
      << "with the gain of 0.1";
}

TEST(Board, WhatIsNoAngleIsRefused) {
  const BoardModel& model = *find_board_model("v1");
  std::array<double, 2> angles{};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinity, -infinity, 1e30F, 5000.0F}) {
    EXPECT_FALSE(read_angles(model, reply(bad, 0.0F), angles));
    EXPECT_FALSE(read_angles(model, reply(0.0F, bad), angles));
  }
}

// The forces of a board are not reduced within its listed reach.
TEST(Board, WhereAMakeReachesItPushes) {
  for (const BoardModel& model : board_models()) {
    for (double x = model.reach_min.x; x <= model.reach_max.x; x += 5.0) {
      for (double y = model.reach_min.y; y <= model.reach_max.y; y += 5.0) {
        const auto angles = angles_for(model.size, {x, y, 0});
        ASSERT_TRUE(angles.has_value()) << model.id << " " << x << " " << y;
        const auto bar = FiveBar::at(model.size, *angles);
        ASSERT_TRUE(bar.has_value()) << model.id << " " << x << " " << y;
        EXPECT_NEAR(norm(bar->place() - Vec3{x, y, 0}), 0.0, 1e-6);
        EXPECT_EQ(bar->authority(), 1.0) << model.id << " " << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace felt::pantograph::board_test
