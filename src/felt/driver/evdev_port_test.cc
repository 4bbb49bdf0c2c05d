#include "felt/driver/evdev_port.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "felt/driver/hidraw_port.h"

namespace felt::evdev_port_test {
namespace {

static_assert(evdev::kSyn == EV_SYN && evdev::kKey == EV_KEY && evdev::kAbs == EV_ABS);
static_assert(evdev::kFf == EV_FF && evdev::kSynReport == SYN_REPORT);
static_assert(evdev::kSynDropped == SYN_DROPPED);
static_assert(evdev::kAbsX == ABS_X && evdev::kAbsY == ABS_Y && evdev::kAbsZ == ABS_Z);
static_assert(evdev::kAbsRz == ABS_RZ && evdev::kAbsThrottle == ABS_THROTTLE);
static_assert(evdev::kAbsWheel == ABS_WHEEL && evdev::kAbsGas == ABS_GAS);
static_assert(evdev::kAbsBrake == ABS_BRAKE);
static_assert(evdev::kButtonTrigger == BTN_TRIGGER && evdev::kButtonSouth == BTN_SOUTH);
static_assert(evdev::kButtonGearDown == BTN_GEAR_DOWN && evdev::kButtonGearUp == BTN_GEAR_UP);
static_assert(evdev::kButtonTouch == BTN_TOUCH);
static_assert(evdev::kFfRumble == FF_RUMBLE && evdev::kFfPeriodic == FF_PERIODIC);
static_assert(evdev::kFfConstant == FF_CONSTANT && evdev::kFfSpring == FF_SPRING);
static_assert(evdev::kFfFriction == FF_FRICTION && evdev::kFfDamper == FF_DAMPER);
static_assert(evdev::kFfGain == FF_GAIN && evdev::kFfAutocenter == FF_AUTOCENTER);
static_assert(evdev::kAxisCount == ABS_CNT && evdev::kKeyCount == KEY_CNT);
static_assert(evdev::kFfCount == FF_CNT);
#ifdef FF_HAPTIC
static_assert(evdev::kFfHaptic == FF_HAPTIC);
#endif

ff_effect unpacked(const EvdevEffect& effect) {
  const auto bytes = packed(effect);
  ff_effect out;
  std::memcpy(&out, bytes.data(), sizeof out);
  return out;
}

TEST(EvdevEffect, IsPackedAsTheKernelReadsIt) {
  EvdevEffect effect;
  effect.type = evdev::kFfSpring;
  effect.id = 3;
  effect.length_ms = 100;
  effect.conditions[1] = {1, 2, 3, -4, 5, -6};
  const ff_effect spring = unpacked(effect);
  EXPECT_EQ(spring.type, FF_SPRING);
  EXPECT_EQ(spring.id, 3);
  EXPECT_EQ(spring.replay.length, 100);
  EXPECT_EQ(spring.u.condition[1].right_saturation, 1);
  EXPECT_EQ(spring.u.condition[1].left_saturation, 2);
  EXPECT_EQ(spring.u.condition[1].right_coeff, 3);
  EXPECT_EQ(spring.u.condition[1].left_coeff, -4);
  EXPECT_EQ(spring.u.condition[1].deadband, 5);
  EXPECT_EQ(spring.u.condition[1].center, -6);
  effect = {};
  effect.type = evdev::kFfConstant;
  effect.direction = 0x4000;
  effect.level = -7;
  EXPECT_EQ(unpacked(effect).u.constant.level, -7);
  EXPECT_EQ(unpacked(effect).direction, 0x4000);
  effect = {};
  effect.type = evdev::kFfRumble;
  effect.strong = 9;
  effect.weak = 8;
  EXPECT_EQ(unpacked(effect).u.rumble.strong_magnitude, 9);
  EXPECT_EQ(unpacked(effect).u.rumble.weak_magnitude, 8);
}

TEST(EvdevEffect, HapticIsWhereLinux618ReadsIt) {
  EvdevEffect effect;
  effect.type = evdev::kFfHaptic;
  effect.hid_usage = 0x1003;
  effect.intensity_percent = 60;
  const auto bytes = packed(effect);
  const std::size_t u = offsetof(ff_effect, u);
  const auto at = [&](std::size_t i) { return std::to_integer<int>(bytes[u + i]); };
  EXPECT_EQ(at(0) | at(1) << 8, 0x1003);
  EXPECT_EQ(at(6) | at(7) << 8, 60);
  for (const std::size_t i : {2u, 3u, 4u, 5u, 8u, 9u, 10u, 11u}) EXPECT_EQ(at(i), 0) << i;
}

TEST(EvdevPort, SaysWhatTheSystemSays) {
  const auto missing = open_evdev("/dev/input/no-such-node");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
  EXPECT_NE(missing.error().message.find("/dev/input/no-such-node: No such file"),
            std::string::npos);
  ASSERT_FALSE(open_hidraw("/dev/no-such-node"));
}

/// Uses a named pipe instead of the device node. It delivers events in the kernel's format, but
/// ioctls fail.
TEST(EvdevPort, ReadsWhatTheKernelWrites) {
  std::string folder = ::testing::TempDir() + "evdev-XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/event0";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  auto port = open_evdev(path);
  ASSERT_TRUE(port) << port.error().message;
  EvdevEvent event;
  EXPECT_EQ((*port)->next(event), false);
  input_event bytes{};
  bytes.type = EV_ABS;
  bytes.code = ABS_Y;
  bytes.value = -300;
  const int pipe = open(path.c_str(), O_WRONLY | O_NONBLOCK);
  ASSERT_EQ(write(pipe, &bytes, sizeof bytes), ssize_t{sizeof bytes});
  EXPECT_EQ((*port)->next(event), true);
  EXPECT_EQ(event.type, evdev::kAbs);
  EXPECT_EQ(event.code, evdev::kAbsY);
  EXPECT_EQ(event.value, -300);
  EXPECT_EQ((*port)->axis(evdev::kAbsX).error(), ENOTTY);
  EXPECT_EQ((*port)->axis(0x40).error(), EINVAL);
  EXPECT_EQ((*port)->key(0x300).error(), EINVAL);
  EXPECT_EQ((*port)->slots().error(), ENOTTY);
  EXPECT_EQ((*port)->upload({}).error(), ENOTTY);
  EXPECT_EQ((*port)->erase(0).error(), ENOTTY);
  close(pipe);
  unlink(path.c_str());
  rmdir(folder.c_str());
}

TEST(HidrawPort, ReadsAndWritesReports) {
  std::string folder = ::testing::TempDir() + "hidraw-XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/hidraw0";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  auto port = open_hidraw(path);
  ASSERT_TRUE(port) << port.error().message;
  std::array<std::uint8_t, 8> room{};
  EXPECT_EQ((*port)->read(room, 0), 0u);
  const std::array<std::uint8_t, 3> report{0x11, 2, 3};
  EXPECT_TRUE((*port)->write(report));  // the port also reads from this pipe
  EXPECT_EQ((*port)->read(room, 1'000'000'000), 3u);
  EXPECT_EQ(room[2], 3);
  EXPECT_EQ((*port)->feature(room).error(), ENOTTY);
  EXPECT_EQ((*port)->feature({}).error(), EINVAL);
  unlink(path.c_str());
  rmdir(folder.c_str());
}

}  // namespace
}  // namespace felt::evdev_port_test
