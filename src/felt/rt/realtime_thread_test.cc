#include "felt/rt/realtime_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <thread>

#include "felt/rt/null_device.h"
#include "felt/rt/testing/scripted_device.h"

namespace felt::realtime_thread_test {
namespace {

/// Removes all samples queued for the edit thread and returns how many there were.
std::size_t drain(Servo& servo) {
  std::size_t count = 0;
  for (PenSample sample; servo.for_edit().pop(sample);) ++count;
  return count;
}

TEST(RealtimeThread, RunsTheServoHandsOverAndEndsWithoutForce) {
  ScriptedDevice device;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  RealtimeThread loop(*servo, {});
  ASSERT_TRUE(loop.start().has_value());
  EXPECT_TRUE(loop.is_running());
  EXPECT_NE(loop.status().scheduling, LoopScheduling::kNotRunning);
  std::int64_t last_ns = -1;
  int samples = 0;
  wait_until([&] {
    PenSample sample;
    while (servo->for_edit().pop(sample)) {
      EXPECT_GT(sample.time_ns, last_ns);
      EXPECT_LE(sample.time_ns, loop.now_ns());
      last_ns = sample.time_ns;
      ++samples;
    }
    servo->heartbeat(loop.now_ns());
    return samples >= 50;
  });
  EXPECT_TRUE(loop.stop());
  EXPECT_FALSE(loop.is_running());
  EXPECT_EQ(loop.status().scheduling, LoopScheduling::kNotRunning);
  EXPECT_EQ(device.stops, 1);
  EXPECT_EQ(device.force, Force{});
  EXPECT_GE(loop.stats().ticks(), 50U);
  EXPECT_EQ(loop.stats().ticks(), servo->stats().ticks());
  EXPECT_EQ(loop.stats().cpu().count(), 0U);
}

TEST(RealtimeThread, StartsAgainStopsTwiceAndStopsWhenDestroyed) {
  ScriptedDevice device;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  {
    RealtimeThread loop(*servo, {});
    EXPECT_TRUE(loop.stop());  // nothing to stop
    ASSERT_TRUE(loop.start().has_value());
    ASSERT_TRUE(loop.start().has_value());
    EXPECT_TRUE(loop.stop());
    EXPECT_TRUE(loop.stop());
    ASSERT_TRUE(loop.start().has_value());
  }
  EXPECT_EQ(device.stops, 2);
}

TEST(RealtimeThread, WithoutAskingItIsAnOrdinaryThreadAndSaysSo) {
  NullDevice device;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  RealtimeOptions options;
  options.fifo_priority = 0;
  options.lock_memory = false;
  options.measure_cpu = true;
  RealtimeThread loop(*servo, options);
  ASSERT_TRUE(loop.start().has_value());
  EXPECT_NE(loop.status().scheduling, LoopScheduling::kFifo);
  EXPECT_FALSE(loop.status().memory_locked);
  wait_until([&] { return loop.stats().ticks() > 0 && servo->for_edit().size() >= 5; });
  EXPECT_TRUE(loop.stop());
  EXPECT_EQ(loop.stats().cpu().count(), loop.stats().ticks());
}

TEST(RealtimeThread, EachStatusHasASentence) {
  EXPECT_EQ(describe(RealtimeStatus{}), "The haptic loop is not running.");
  EXPECT_EQ(describe({LoopScheduling::kFifo, true}),
            "The haptic loop runs in real time (SCHED_FIFO), with its memory locked.");
  EXPECT_NE(describe({LoopScheduling::kOrdinary, false}).find("rtprio"), std::string::npos);
  EXPECT_NE(describe({LoopScheduling::kNice, false}).find("nice"), std::string::npos);
}

// Publishes, arms and reads while the loop runs, for ThreadSanitizer.
TEST(RealtimeThread, TheEditSideMayDoEverythingWhileItRuns) {
  NullDevice device;
  ServoOptions options;
  options.period_ns = 200'000;
  const auto servo = std::make_unique<Servo>(device, options);
  RealtimeThread loop(*servo, {});
  ASSERT_TRUE(loop.start().has_value());
  std::uint64_t drained = 0;
  for (std::uint32_t i = 0; drained < 200; ++i) {
    device.aim({0.01 * (i % 100), 0.0, -0.1}, 0.5, i);
    ForceModel model;
    model.set_fade_id(i % 3);
    servo->publish(model);
    servo->heartbeat(loop.now_ns());
    if (i % 2 == 0) servo->arm();
    if (i % 7 == 0) servo->disarm();
    PenSample sample;
    while (servo->for_edit().pop(sample)) ++drained;
    while (servo->for_autosave().pop(sample)) {
    }
    EXPECT_TRUE(is_finite(servo->latest().sent));
    static_cast<void>(loop.stats());
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  EXPECT_TRUE(loop.stop());
}

TEST(RealtimeThread, APausedLoopDoesNotTickAndGoesOnAtOnce) {
  NullDevice device;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  RealtimeThread loop(*servo, {});
  loop.pause();
  EXPECT_FALSE(loop.is_paused()) << "it does not run";
  ASSERT_TRUE(loop.start().has_value());
  wait_until([&] { return drain(*servo) > 0; });
  loop.pause();
  EXPECT_TRUE(loop.is_paused());
  EXPECT_FALSE(loop.status().is_silent);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // for the tick in progress
  drain(*servo);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_EQ(drain(*servo), 0U);
  servo->heartbeat(loop.now_ns());
  loop.resume();
  PenSample sample;
  wait_until([&] { return servo->for_edit().pop(sample); });
  EXPECT_FALSE(loop.status().is_silent);
  // Counting periods from the first tick is still correct.
  loop.pause();
  EXPECT_TRUE(loop.stop()) << "a paused loop ends, too";
  EXPECT_FALSE(loop.is_paused());
}

TEST(RealtimeThread, AfterALongPauseTheLoopIsNotSilent) {
  ScriptedDevice device;
  const auto servo = std::make_unique<Servo>(device, ServoOptions{});
  RealtimeThread loop(*servo, {});
  ASSERT_TRUE(loop.start().has_value());
  wait_until([&] { return drain(*servo) > 0; });
  for (int i = 0; i < 3; ++i) {
    loop.pause();
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    loop.resume();
    EXPECT_FALSE(loop.status().is_silent);
    drain(*servo);
    wait_until([&] { return drain(*servo) > 0; });
  }
  EXPECT_TRUE(loop.stop());
  EXPECT_LT(loop.stats().duration_ns(), 3 * 600'000'000);
}

}  // namespace
}  // namespace felt::realtime_thread_test
