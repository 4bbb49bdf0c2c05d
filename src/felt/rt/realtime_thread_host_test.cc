#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "felt/rt/realtime_thread.h"
#include "felt/rt/testing/scripted_device.h"

namespace felt::realtime_thread_host_test {
namespace {

using ::testing::HasSubstr;

// A vendor's scheduler: calls about every 0.2 ms until it is stopped or reaches its limit of calls.
class FakeHost final : public LoopHost {
 public:
  ~FakeHost() override { FakeHost::stop_loop(); }

  Result<void> start_loop(Tick tick, void* context) override {
    ++starts;
    if (refuses) return fail(ErrorCode::kIo, "scheduler full");
    stop_ = false;
    thread_ = std::thread([this, tick, context] {
      while (!stop_) {
        if (calls < max_calls) {
          ++calls;
          tick(context);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
    return {};
  }
  void stop_loop() noexcept override {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] bool runs() const { return thread_.joinable(); }
  [[nodiscard]] std::thread::id thread() const { return thread_.get_id(); }

  bool refuses = false;
  int starts = 0;
  std::atomic<int> calls = 0;
  std::atomic<int> max_calls = 1'000'000'000;

 private:
  std::thread thread_;
  std::atomic<bool> stop_ = false;
};

// A device that records on which thread it was stopped, and whether the force was zero by then.
class WatchedDevice final : public Device {
 public:
  [[nodiscard]] std::string_view name() const noexcept override { return "watched"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return inner.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    read_on = std::this_thread::get_id();
    return inner.read(now_ns);
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return inner.write(force);
  }
  void stop() noexcept override {
    stopped_on = std::this_thread::get_id();
    zero_before_stop = inner.force == Force{};
    inner.stop();
  }

  ScriptedDevice inner;
  std::thread::id read_on, stopped_on;
  bool zero_before_stop = false;
};

struct Push {
  [[nodiscard]] Slopes slopes() const noexcept { return {}; }
  Force operator()(const PenSample&, ForceMemory&) const noexcept { return {0, 0, 1.0}; }
};

class HostedLoop : public ::testing::Test {
 protected:
  // Waits until the loop sends a force, which the test then expects to be removed.
  void press_until_there_is_force(RealtimeThread& loop) {
    wait_until([&] {
      servo->heartbeat(loop.now_ns());
      servo->arm();  // again: on a busy machine late ticks may have latched the chain
      const SafetyState state = servo->latest().safety.state;
      if (state == SafetyState::kEngaging || state == SafetyState::kActive) {
        servo->publish(ForceModel(Push{}));
      } else {
        servo->publish(ForceModel{});
      }
      return servo->latest().sent.z > 0.01;
    });
  }

  WatchedDevice device;
  FakeHost host;
  std::unique_ptr<Servo> servo =
      std::make_unique<Servo>(device, ServoOptions{.limits = limits_for(device.capabilities())});
};

TEST_F(HostedLoop, TicksOnTheHostsThreadAndEndsThereWithoutForce) {
  RealtimeThread loop(*servo, {}, &host);
  EXPECT_FALSE(loop.is_running());
  ASSERT_TRUE(loop.start().has_value());
  ASSERT_TRUE(loop.start().has_value());  // it is already running
  EXPECT_EQ(host.starts, 1);
  EXPECT_TRUE(loop.is_running());
  EXPECT_EQ(loop.status().scheduling, LoopScheduling::kHost);
  EXPECT_THAT(describe(loop.status()), HasSubstr("device's software"));
  EXPECT_GE(loop.first_due_ns(), 0);
  EXPECT_LE(loop.first_due_ns(), loop.now_ns());
  wait_until([&] { return servo->for_edit().size() >= 20; });
  const std::thread::id hosts_thread = host.thread();
  EXPECT_TRUE(loop.stop());
  EXPECT_FALSE(loop.is_running());
  EXPECT_FALSE(host.runs());
  EXPECT_EQ(loop.status().scheduling, LoopScheduling::kNotRunning);
  EXPECT_EQ(device.inner.stops, 1);
  EXPECT_EQ(device.read_on, hosts_thread);
  EXPECT_EQ(device.stopped_on, hosts_thread);
  EXPECT_GE(loop.stats().ticks(), 20U);
  EXPECT_EQ(loop.stats().ticks(), servo->stats().ticks());
  EXPECT_TRUE(loop.stop());
  EXPECT_EQ(device.inner.stops, 1);
}

TEST_F(HostedLoop, TakesTheForceAwayBeforeItStopsTheDevice) {
  RealtimeThread loop(*servo, {}, &host);
  ASSERT_TRUE(loop.start().has_value());
  press_until_there_is_force(loop);
  EXPECT_TRUE(loop.stop());
  EXPECT_TRUE(device.zero_before_stop);
  EXPECT_EQ(device.inner.force, Force{});
}

TEST_F(HostedLoop, StartsAgainAndStopsWhenDestroyed) {
  {
    RealtimeThread loop(*servo, {}, &host);
    ASSERT_TRUE(loop.start().has_value());
    EXPECT_TRUE(loop.stop());
    const auto ticks = loop.stats().ticks();
    EXPECT_GT(ticks, 0U);
    ASSERT_TRUE(loop.start().has_value());
  }
  EXPECT_EQ(host.starts, 2);
  EXPECT_FALSE(host.runs());
  EXPECT_EQ(device.inner.stops, 2);
}

TEST_F(HostedLoop, ARefusalComesInTheMakersWords) {
  host.refuses = true;
  RealtimeThread loop(*servo, {}, &host);
  const auto started = loop.start();
  ASSERT_FALSE(started.has_value());
  EXPECT_EQ(started.error().message, "scheduler full");
  EXPECT_FALSE(loop.is_running());
  EXPECT_EQ(loop.status().scheduling, LoopScheduling::kNotRunning);
  EXPECT_EQ(device.inner.stops, 0);
}

TEST_F(HostedLoop, AHostThatNeverCallsIsAnError) {
  host.max_calls = 0;
  RealtimeOptions options;
  options.host_patience_ns = 20'000'000;
  RealtimeThread loop(*servo, options, &host);
  const auto started = loop.start();
  ASSERT_FALSE(started.has_value());
  EXPECT_THAT(started.error().message, HasSubstr("does not run it"));
  EXPECT_FALSE(loop.is_running());
  EXPECT_FALSE(host.runs());
  EXPECT_EQ(device.inner.stops, 1);
}

TEST_F(HostedLoop, AHostThatCallsNoMoreIsToldAndStopsWithoutForceAllTheSame) {
  RealtimeOptions options;
  options.host_patience_ns = 20'000'000;
  RealtimeThread loop(*servo, options, &host);
  ASSERT_TRUE(loop.start().has_value());
  press_until_there_is_force(loop);
  host.max_calls = 0;
  wait_until([&] { return loop.status().is_silent; });
  EXPECT_THAT(describe(loop.status()), HasSubstr("stands still"));
  EXPECT_TRUE(loop.stop());
  EXPECT_FALSE(loop.is_running());
  EXPECT_EQ(device.stopped_on, std::this_thread::get_id());  // there was no other thread
  EXPECT_TRUE(device.zero_before_stop);
  EXPECT_FALSE(loop.status().is_silent);
}

}  // namespace
}  // namespace felt::realtime_thread_host_test
