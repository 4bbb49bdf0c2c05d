#include "felt/devices/evdev/stick_axes.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <deque>
#include <map>

#include "felt/base/constants.h"

namespace felt::stick_axes_test {
namespace {

/// A fake port with queued events and a settable state of the axes.
class Queue final : public EvdevPort {
 public:
  tl::expected<bool, int> next(EvdevEvent& event) noexcept override {
    if (error_ != 0) return tl::unexpected(error_);
    if (events.empty()) return false;
    event = events.front();
    events.pop_front();
    return true;
  }
  tl::expected<EvdevAxis, int> axis(std::uint16_t code) noexcept override {
    ++asked;
    const auto found = axes.find(code);
    if (found == axes.end()) return tl::unexpected(EINVAL);
    return found->second;
  }
  tl::expected<bool, int> key(std::uint16_t code) noexcept override {
    ++asked;
    return keys[code];
  }
  tl::expected<int, int> slots() noexcept override { return 0; }
  tl::expected<std::int16_t, int> upload(const EvdevEffect&) noexcept override {
    return tl::unexpected(EINVAL);
  }
  tl::expected<void, int> erase(std::int16_t) noexcept override { return tl::unexpected(EINVAL); }
  tl::expected<void, int> send(const EvdevEvent&) noexcept override { return {}; }

  void say(std::uint16_t type, std::uint16_t code, std::int32_t value) {
    events.push_back({type, code, value});
  }
  void report() { say(evdev::kSyn, evdev::kSynReport, 0); }

  std::deque<EvdevEvent> events;
  std::map<std::uint16_t, EvdevAxis> axes{{evdev::kAbsX, {512, 0, 1023, 0}},
                                          {evdev::kAbsY, {512, 0, 1023, 0}},
                                          {evdev::kAbsThrottle, {255, 0, 255, 0}}};
  std::map<std::uint16_t, bool> keys;
  int error_ = 0;
  int asked = 0;
};

TEST(StickAxes, PlacesAreInMillimetresAboutTheMiddle) {
  Queue port;
  port.axes[evdev::kAbsX].value = 1023;
  port.axes[evdev::kAbsY].value = 0;
  StickAxes axes({});
  ASSERT_TRUE(axes.begin(ask_stick(port, {})));
  const PenSample pen = axes.sample(0);
  EXPECT_DOUBLE_EQ(pen.position.x, 45.0);
  EXPECT_DOUBLE_EQ(pen.position.y, -45.0);
  EXPECT_DOUBLE_EQ(pen.position.z, StickAxes::kHoverMm);
  EXPECT_EQ(pen.pressure, 0.0);
  EXPECT_NEAR(axes.step_mm(), 90.0 / 1023, 1e-12);
}

TEST(StickAxes, AReportIsReachedEvenlyWithItsButtonsAtTheEnd) {
  Queue port;
  StickAxes axes({.pressure = evdev::kAbsThrottle});
  ASSERT_TRUE(axes.begin(ask_stick(port, {.pressure = evdev::kAbsThrottle})));
  const double from = axes.sample(0).position.x;
  port.say(evdev::kAbs, evdev::kAbsX, 768);
  port.say(evdev::kAbs, evdev::kAbsThrottle, 51);
  port.say(evdev::kKey, evdev::kButtonTrigger, 1);
  port.say(evdev::kKey, evdev::kButtonTrigger + 2, 1);
  port.report();
  ASSERT_TRUE(axes.listen(port, 0));
  const double to = 45.0 * (768 - 511.5) / 511.5;
  EXPECT_NEAR(axes.sample(2 * kMs).position.x, from + 0.25 * (to - from), 1e-9);
  EXPECT_EQ(axes.sample(7 * kMs).pressure, 0.0);
  EXPECT_EQ(axes.sample(7 * kMs).buttons, 0u);
  const PenSample there = axes.sample(8 * kMs);
  EXPECT_NEAR(there.position.x, to, 1e-9);
  EXPECT_DOUBLE_EQ(*there.pressure, 0.2);
  EXPECT_DOUBLE_EQ(there.position.z, -0.4);
  EXPECT_EQ(there.buttons, 2u);
  EXPECT_GT(there.velocity.x, 0.0);
}

TEST(StickAxes, ATouchThatIsShorterThanTheGlideIsNotLost) {
  Queue port;
  StickAxes axes({});
  ASSERT_TRUE(axes.begin(ask_stick(port, {})));
  for (const int down : {1, 0}) {
    port.say(evdev::kKey, evdev::kButtonTrigger, down);
    port.report();
    ASSERT_TRUE(axes.listen(port, down == 1 ? 0 : 4 * kMs));
  }
  bool touched = false;
  for (int ms = 4; ms < 20; ++ms) touched = in_contact(axes.sample(ms * kMs)) || touched;
  EXPECT_TRUE(touched);
  EXPECT_FALSE(in_contact(axes.sample(20 * kMs)));
}

TEST(StickAxes, TheMiddleMayBeFlatAndTheEndsStay) {
  Queue port;
  port.axes[evdev::kAbsX] = {0, -100, 100, 20};
  StickAxes axes({});
  const auto at = [&](std::int32_t value) {
    port.axes[evdev::kAbsX].value = value;
    EXPECT_TRUE(axes.begin(ask_stick(port, {})));
    return axes.sample(0).position.x;
  };
  EXPECT_EQ(at(20), 0.0);
  EXPECT_EQ(at(-20), 0.0);
  EXPECT_DOUBLE_EQ(at(60), 22.5);
  EXPECT_DOUBLE_EQ(at(100), 45.0);
  EXPECT_DOUBLE_EQ(at(5000), 45.0) << "beyond its own end";
  port.axes[evdev::kAbsX].flat = 100000;  // invalid
  EXPECT_DOUBLE_EQ(at(100), 45.0);
}

TEST(StickAxes, LostEventsAreAskedForAnew) {
  Queue port;
  StickAxes axes({});
  ASSERT_TRUE(axes.begin(ask_stick(port, {})));
  const double from = axes.sample(0).position.x;
  port.say(evdev::kSyn, evdev::kSynDropped, 0);
  port.say(evdev::kAbs, evdev::kAbsX, 3);  // part of an incomplete report: must be ignored
  port.report();
  port.asked = 0;
  ASSERT_TRUE(axes.listen(port, 1 * kMs));
  EXPECT_TRUE(axes.needs_asking());
  EXPECT_EQ(port.asked, 0) << "listening asks nothing of the kernel that may wait";
  // Until the state has been read, events are queued and the pen does not move.
  port.say(evdev::kKey, evdev::kButtonTrigger + 1, 1);
  port.report();
  ASSERT_TRUE(axes.listen(port, 10 * kMs));
  EXPECT_EQ(port.events.size(), 2u);
  EXPECT_EQ(axes.sample(10 * kMs).position.x, from);
  port.axes[evdev::kAbsX].value = 1023;
  port.keys[evdev::kButtonTrigger] = true;
  ASSERT_TRUE(axes.take(ask_stick(port, {}), 11 * kMs));
  EXPECT_FALSE(axes.needs_asking());
  ASSERT_TRUE(axes.listen(port, 11 * kMs));
  const PenSample pen = axes.sample(19 * kMs);
  EXPECT_DOUBLE_EQ(pen.position.x, 45.0);
  EXPECT_EQ(pen.pressure, StickAxes::kUsualPressure);
  EXPECT_EQ(pen.buttons, 1u);
}

TEST(StickAxes, WhereNobodyAnswersThePlaceIsNotForEver) {
  Queue port;
  StickAxes axes({});
  ASSERT_TRUE(axes.begin(ask_stick(port, {})));
  port.say(evdev::kSyn, evdev::kSynDropped, 0);
  port.report();
  ASSERT_TRUE(axes.listen(port, 5 * kMs));
  EXPECT_FALSE(axes.is_stale(5 * kMs + StickAxes::kStaleNs));
  EXPECT_TRUE(axes.is_stale(6 * kMs + StickAxes::kStaleNs));
  StickStand gone;
  gone.error = ENODEV;
  EXPECT_EQ(axes.take(gone, 60 * kMs).error(), ENODEV);
  EXPECT_TRUE(axes.needs_asking());
  ASSERT_TRUE(axes.take(ask_stick(port, {}), 61 * kMs));
  EXPECT_FALSE(axes.is_stale(1000 * kMs));
}

TEST(StickAxes, TakesBoundedlyManyEventsAtATime) {
  Queue port;
  StickAxes axes({});
  ASSERT_TRUE(axes.begin(ask_stick(port, {})));
  for (int i = 0; i < 500; ++i) port.say(evdev::kAbs, evdev::kAbsX, i);
  ASSERT_TRUE(axes.listen(port, 0));
  EXPECT_EQ(port.events.size(), 500u - StickAxes::kMaxEvents);
}

TEST(StickAxes, AnAxisWithoutWayOrADeviceThatIsGoneIsAnError) {
  Queue port;
  port.axes[evdev::kAbsY] = {5, 5, 5, 0};
  StickAxes axes({});
  EXPECT_EQ(axes.begin(ask_stick(port, {})).error(), EINVAL);
  port.error_ = ENODEV;
  EXPECT_EQ(axes.listen(port, 0).error(), ENODEV);
  StickAxes wheel({.y = std::nullopt});
  EXPECT_TRUE(wheel.begin(ask_stick(port, {.y = std::nullopt})));
  EXPECT_EQ(wheel.sample(0).position.y, 0.0);
}

}  // namespace
}  // namespace felt::stick_axes_test
