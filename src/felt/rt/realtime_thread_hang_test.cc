// A device that hangs in a call of its vendor's driver: the loop is abandoned, the program
// continues.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "felt/rt/abandon.h"
#include "felt/rt/realtime_thread.h"
#include "felt/rt/testing/scripted_device.h"

namespace felt::realtime_thread_hang_test {
namespace {

/// State shared by a hanging device and a test: the device reports its calls, and the test releases
/// them. It outlives the abandoned objects.
struct Call {
  std::atomic<bool> hangs{false};
  std::atomic<bool> is_in{false};
  std::atomic<int> stops{0};
};

class HangingDevice final : public Device {
 public:
  explicit HangingDevice(Call& call) : call_(call) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "hanging"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return inner_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    while (call_.hangs) {
      call_.is_in = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return inner_.read(now_ns);
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return inner_.write(force);
  }
  void stop() noexcept override { ++call_.stops; }

 private:
  Call& call_;
  ScriptedDevice inner_;
};

// A vendor's scheduler with a callback that may never return, so that it cannot be stopped either.
class JoiningHost final : public LoopHost {
 public:
  ~JoiningHost() override { JoiningHost::stop_loop(); }
  Result<void> start_loop(Tick tick, void* context) override {
    thread_ = std::thread([this, tick, context] {
      while (!stop_) {
        tick(context);
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      }
    });
    return {};
  }
  void stop_loop() noexcept override {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }

 private:
  std::thread thread_;
  std::atomic<bool> stop_{false};
};

constexpr RealtimeOptions kImpatient{.fifo_priority = 0,
                                     .lock_memory = false,
                                     .host_patience_ns = 20'000'000,
                                     .stop_patience_ns = 20'000'000};

/// Tests with and without a host, because calls may hang in both cases.
class HangingLoop : public ::testing::TestWithParam<bool> {
 protected:
  void hang() {
    ASSERT_TRUE(loop->start().has_value());
    wait_until([&] { return servo->for_edit().size() >= 3; });
    call.hangs = true;
    wait_until([&] { return call.is_in.load(); });
  }
  ~HangingLoop() override { call.hangs = false; }

  Call call;
  std::unique_ptr<HangingDevice> device = std::make_unique<HangingDevice>(call);
  std::unique_ptr<JoiningHost> host = std::make_unique<JoiningHost>();
  std::unique_ptr<Servo> servo = std::make_unique<Servo>(*device, ServoOptions{});
  std::unique_ptr<RealtimeThread> loop =
      std::make_unique<RealtimeThread>(*servo, kImpatient, GetParam() ? host.get() : nullptr);
};

TEST_P(HangingLoop, StopGivesUpAndEndsItOnceTheCallIsBack) {
  hang();
  EXPECT_FALSE(loop->stop());
  EXPECT_TRUE(loop->is_running());
  EXPECT_EQ(call.stops, 0) << "the device is the loop's own until its call is back";
  EXPECT_FALSE(loop->stop());
  call.hangs = false;
  wait_until([&] { return call.stops == 1; });  // the loop ends by itself, without another stop()
  wait_until([&] { return loop->stop(); });
  EXPECT_FALSE(loop->is_running());
  EXPECT_EQ(call.stops, 1);
}

TEST_P(HangingLoop, TheDestructorWaitsForTheCall) {
  hang();
  EXPECT_FALSE(loop->stop());
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    call.hangs = false;
  });
  loop.reset();
  EXPECT_FALSE(call.hangs);
  EXPECT_EQ(call.stops, 1);
  later.join();
}

TEST_P(HangingLoop, AbandonedItMayComeBackAtAnyTime) {
  hang();
  ASSERT_FALSE(loop->stop());
  abandon(std::move(loop), std::move(servo), std::move(host), std::move(device));
  EXPECT_EQ(loop, nullptr);
  EXPECT_EQ(device, nullptr);
  call.hangs = false;
  wait_until([&] { return call.stops == 1; });
}

INSTANTIATE_TEST_SUITE_P(OwnThreadAndHost, HangingLoop, ::testing::Bool(),
                         [](const auto& which) { return which.param ? "Host" : "OwnThread"; });

}  // namespace
}  // namespace felt::realtime_thread_hang_test
