#include "desktop/engine/driver_watch.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <condition_variable>
#include <mutex>

namespace felt::desktop::driver_watch_test {
namespace {

/// Blocks a library call until the test calls open().
struct Gate {
  std::mutex mutex;
  std::condition_variable changed;
  bool is_shut = true;
  int inside = 0;

  void pass() {
    std::unique_lock lock(mutex);
    ++inside;
    changed.wait(lock, [this] { return !is_shut; });
    --inside;
    changed.notify_all();
  }
  void open() {
    std::unique_lock lock(mutex);
    is_shut = false;
    changed.notify_all();
    changed.wait(lock, [this] { return inside == 0; });
  }
};

class GatedDriver final : public Driver {
 public:
  GatedDriver(std::string name, Gate* gate) : name_(std::move(name)), gate_(gate) {}
  [[nodiscard]] std::string_view name() const noexcept override { return name_; }
  [[nodiscard]] std::string_view label() const noexcept override { return name_; }
  std::vector<DeviceDescriptor> find() override {
    if (gate_) gate_->pass();
    DeviceDescriptor device;
    device.id = name_ + ":1";
    device.driver = name_;
    device.label = name_;
    device.is_connected = true;
    return {device};
  }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor&, const OpenOptions&) override {
    return fail(ErrorCode::kUnsupported, "for show");
  }
  std::vector<Finding> diagnose(const SystemView&) override { return {}; }

 private:
  std::string name_;
  Gate* gate_;
};

std::vector<std::unique_ptr<Driver>> drivers(Gate& gate) {
  std::vector<std::unique_ptr<Driver>> made;
  made.push_back(std::make_unique<GatedDriver>("hanging", &gate));
  made.push_back(std::make_unique<GatedDriver>("good", nullptr));
  return made;
}

TEST(DriverWatch, ALibraryThatHangsIsGivenUpAndTheOthersAreFound) {
  static Gate gate;  // a hanging call may outlive this test
  {
    DriverWatch watch(drivers(gate), nullptr, 100);
    QSignalSpy looked(&watch, &DriverWatch::looked);
    const DriverWatch::Watching watching;
    ASSERT_TRUE(looked.wait(20'000)) << "the watch waits for ever";
    ASSERT_EQ(watch.found().size(), 1U);
    EXPECT_EQ(watch.found()[0].id, QStringLiteral("good:1"));
    watch.look();
    ASSERT_TRUE(looked.wait(20'000));
    EXPECT_EQ(watch.found().size(), 1U);
  }
  gate.open();  // the call returns, but nothing waits for its result any more
}

TEST(DriverWatch, EndsAlthoughALibraryHangs) {
  static Gate gate;
  auto watch = std::make_unique<DriverWatch>(drivers(gate));
  watch->look();
  QElapsedTimer time;
  time.start();
  watch.reset();
  EXPECT_LT(time.elapsed(), 10 * DriverWatch::kPatienceMs);
  gate.open();
}

}  // namespace
}  // namespace felt::desktop::driver_watch_test
