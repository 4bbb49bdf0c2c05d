// Tests the haptic thread and the worker thread of a stick running at the same time.
#include "felt/devices/evdev/effect_keeper.h"
#include "felt/base/constants.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <functional>
#include <mutex>
#include <set>
#include <thread>

#include "felt/devices/evdev/evdev_driver.h"
#include "tests/devices/drivers/evdev/fake_stick.h"

namespace felt::effect_keeper_test {
namespace {

/// A device with transfers of any duration. At each transfer it calls the function that the test
/// has set.
class SlowPort final : public EvdevPort {
 public:
  tl::expected<bool, int> next(EvdevEvent&) noexcept override { return false; }
  tl::expected<EvdevAxis, int> axis(std::uint16_t) noexcept override {
    return EvdevAxis{0, -100, 100, 0};
  }
  tl::expected<bool, int> key(std::uint16_t) noexcept override { return false; }
  tl::expected<int, int> slots() noexcept override { return 16; }
  tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept override {
    const auto id = effect.id < 0 ? ++newest : effect.id;
    if (during_upload) during_upload();
    return id;
  }
  tl::expected<void, int> erase(std::int16_t) noexcept override { return {}; }
  tl::expected<void, int> send(const EvdevEvent& event) noexcept override {
    if (error != 0) return tl::unexpected(error);
    if (event.value > 0 && during_play) during_play();
    if (event.value > 0) {
      ++plays;
      playing.insert(event.code);
    } else {
      playing.erase(event.code);
    }
    return {};
  }

  std::function<void()> during_upload, during_play;
  std::int16_t newest = -1;
  std::set<std::uint16_t> playing;
  int plays = 0, error = 0;
};

EffectPlan two_effects() {
  EffectPlan plan;
  plan.effects[EffectPlan::kSpring].type = evdev::kFfSpring;
  plan.effects[EffectPlan::kFriction].type = evdev::kFfFriction;
  plan.plays[EffectPlan::kSpring] = plan.plays[EffectPlan::kFriction] = true;
  return plan;
}

/// An effect that is silenced while its upload runs is not played after the upload.
TEST(EffectKeeper, WhatIsSilencedDuringAnUploadIsNotPlayed) {
  SlowPort port;
  EffectKeeper keeper(port, {}, 1.0);
  keeper.want(two_effects());
  port.during_upload = [&] { keeper.silence(); };
  keeper.serve(0);
  EXPECT_EQ(port.plays, 0);
  keeper.want(two_effects());
  port.during_upload = [&] {
    if (port.newest == 1) keeper.silence();  // the second upload
  };
  keeper.serve(EffectKeeper::kUploadNs);
  EXPECT_EQ(port.plays, 1);
  EXPECT_TRUE(port.playing.empty()) << "the first is stopped at once";
  // The silence comes between the check and the play; the same serve() stops the effect.
  port.during_upload = nullptr;
  port.during_play = [&] { keeper.silence(); };
  keeper.want(two_effects());
  keeper.serve(2 * EffectKeeper::kUploadNs);
  EXPECT_TRUE(port.playing.empty());
}

/// If the kernel refuses a stop, the keeper repeats it until the kernel accepts it.
TEST(EffectKeeper, AStopThatWasNotHeardIsToldAgain) {
  SlowPort port;
  EffectKeeper keeper(port, {}, 1.0);
  keeper.want(two_effects());
  keeper.serve(0);
  ASSERT_EQ(port.playing.size(), 2u);
  port.error = EINTR;
  keeper.silence();
  keeper.serve(kMs);
  EXPECT_EQ(port.playing.size(), 2u);
  EXPECT_EQ(keeper.error(), EINTR);
  port.error = 0;
  keeper.serve(2 * kMs);
  EXPECT_TRUE(port.playing.empty());
  keeper.serve(EffectKeeper::kUploadNs);
  EXPECT_EQ(keeper.error(), 0) << "it takes effects again";
}

/// Models the kernel's lock: one lock for each device, held for the whole duration of an upload.
class LockedPort final : public EvdevPort {
 public:
  struct Kernel {
    std::mutex lock;
    std::atomic<bool> must_hang{false}, hangs{false}, loses_events{false};
    std::atomic<int> waits{0};  // how often threads other than the worker waited for the lock
  };
  explicit LockedPort(Kernel& kernel) : kernel_(kernel) {}
  tl::expected<bool, int> next(EvdevEvent& event) noexcept override {
    if (said_ == 0 && !kernel_.loses_events.exchange(false)) return false;
    event = {evdev::kSyn, said_ == 0 ? evdev::kSynDropped : evdev::kSynReport, 0};
    said_ = 1 - said_;
    return true;
  }
  tl::expected<EvdevAxis, int> axis(std::uint16_t) noexcept override {
    take_lock();
    return EvdevAxis{0, -100, 100, 0};
  }
  tl::expected<bool, int> key(std::uint16_t) noexcept override {
    take_lock();
    return false;
  }
  tl::expected<int, int> slots() noexcept override { return 16; }
  tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept override {
    const std::lock_guard<std::mutex> held(kernel_.lock);
    while (kernel_.must_hang) {
      kernel_.hangs = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return effect.id < 0 ? std::int16_t{0} : effect.id;
  }
  tl::expected<void, int> erase(std::int16_t) noexcept override { return {}; }
  tl::expected<void, int> send(const EvdevEvent&) noexcept override {
    take_lock();
    return {};
  }

 private:
  /// Only records that a real call would wait, so that a test fails instead of hanging.
  void take_lock() noexcept {
    if (!kernel_.lock.try_lock()) {
      ++kernel_.waits;
      return;
    }
    kernel_.lock.unlock();
  }

  Kernel& kernel_;
  int said_ = 0;
};

/// An upload hangs in the kernel. The haptic thread continues drawing and never waits for it.
TEST(EvdevDriver, AnUploadThatHangsKeepsNobodyWaiting) {
  FakeStick stick({});
  LockedPort::Kernel kernel;
  EvdevOptions options;
  options.system = &stick.system();
  options.open = [&kernel](const std::string&) -> Result<std::unique_ptr<EvdevPort>> {
    return std::make_unique<LockedPort>(kernel);
  };
  const auto driver = make_evdev_driver(std::move(options));
  auto device = driver->open(driver->find().front(), {});
  ASSERT_TRUE(device) << device.error().message;
  std::int64_t now_ns = 0;
  kernel.must_hang = true;
  while (!kernel.hangs) {
    ASSERT_TRUE((*device)->read(now_ns += kMs));
    ASSERT_TRUE((*device)->write({0.5, 0, 0}));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kernel.loses_events = true;
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE((*device)->read(now_ns += kMs));
    static_cast<void>((*device)->write({0.5, 0, 0}));
    static_cast<void>((*device)->write({}));
    (*device)->stop();
  }
  EXPECT_EQ(kernel.waits, 0);
  kernel.must_hang = false;
  device->reset();
}

}  // namespace
}  // namespace felt::effect_keeper_test
