// Tests complete sessions of a user with the real code of every driver. The window's studio and its
// DeviceCare are real; the drivers' test benches (tests/devices/drivers) simulate the vendors'
// libraries and devices.
#include <gtest/gtest.h>

#include <QFile>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>

#include "desktop/devices/device_care.h"
#include "desktop/engine/settings.h"
#include "felt/base/constants.h"
#include "tests/devices/drivers/driver_bench.h"

namespace felt::desktop::device_benches_test {
namespace {

/// The bench's device, opened as the window's driver opens a device. Its ticks follow the studio's
/// time.
class BenchPen final : public DriverDevice {
 public:
  BenchPen(DriverBench& bench, const Studio*& studio) : bench_(bench), studio_(studio) {}

  [[nodiscard]] std::string_view name() const noexcept override { return inner().name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return inner().capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    // The bench's clock does not restart with each loop.
    const std::int64_t bench_ns = studio_->now_ns();
    bench_.before_tick(bench_ns);
    auto sample = inner().read(bench_ns);
    if (sample) sample->time_ns += now_ns - bench_ns;
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return inner().write(force);
  }
  void stop() noexcept override { inner().stop(); }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override {
    return inner().descriptor();
  }
  [[nodiscard]] DeviceStatus status() noexcept override { return inner().status(); }

 private:
  [[nodiscard]] DriverDevice& inner() const noexcept { return *bench_.device(); }

  DriverBench& bench_;
  const Studio*& studio_;
};

class BenchDriver final : public Driver {
 public:
  BenchDriver(DriverBench& bench, const Studio*& studio)
      : bench_(bench), studio_(studio), seen_(bench.device()->descriptor()) {}

  [[nodiscard]] std::string_view name() const noexcept override { return seen_.driver; }
  [[nodiscard]] std::string_view label() const noexcept override { return seen_.driver; }
  std::vector<DeviceDescriptor> find() override { return {seen_}; }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor&, const OpenOptions&) override {
    if (was_opened_) {
      if (Result<void> again = bench_.reconnect(); !again) return tl::unexpected(again.error());
    }
    was_opened_ = true;
    return std::make_unique<BenchPen>(bench_, studio_);
  }
  std::vector<Finding> diagnose(const SystemView&) override { return {}; }

 private:
  DriverBench& bench_;
  const Studio*& studio_;
  DeviceDescriptor seen_;
  bool was_opened_ = false;
};

struct Fixture {
  Fixture(std::string_view name, std::vector<FaultWindow> faults)
      : bench(make_driver_bench(name, std::move(faults))) {
    id = QString::fromStdString(bench->device()->descriptor().id);
    DeviceProfile profile;
    profile.device_id = id.toStdString();
    profile.plane = bench->plane();
    EXPECT_TRUE(keep_profile(profile).has_value());
    std::vector<std::unique_ptr<Driver>> drivers;
    drivers.push_back(std::make_unique<BenchDriver>(*bench, studio_of_bench));
    watch.emplace(std::move(drivers));
    StudioOptions options;
    options.live = false;
    studio = std::make_unique<Studio>(options);
    studio_of_bench = studio.get();
    care = new DeviceCare(*studio, *notice, &window);
    const Capabilities can = bench->plane().to_page(bench->device()->capabilities());
    middle = 0.5 * (can.workspace_min + can.workspace_max);
    look();
  }
  ~Fixture() {
    delete care;
    studio.reset();
    QFile::remove(profile_path(id));
    Settings::the().reset(QString::fromLatin1(kPenDeviceKey));
  }
  Fixture(const Fixture&) = delete;
  Fixture& operator=(const Fixture&) = delete;

  void look() {
    for (int i = 0; i < 2; ++i) {
      QSignalSpy looked(&*watch, &DriverWatch::looked);
      watch->look();
      EXPECT_TRUE(looked.wait(5000));
    }
  }
  /// Moves the hand evenly from its present position, and delivers the signals.
  void move_to(double x, double y, double z, std::int64_t ms) {
    const Vec3 to = middle + Vec3{x, y, z - middle.z}, from = hand;
    const std::int64_t start_ns = studio->now_ns();
    for (std::int64_t i = 1; i <= ms; ++i) {
      hand = from + (double(i) / double(ms)) * (to - from);
      bench->hand().aim(hand, {}, 0);
      // A tick of a slow loop takes longer than a millisecond.
      if (studio->now_ns() < start_ns + i * kMs) studio->advance(kMs);
      // The bench advances even while nothing reads it.
      if (studio->loop().device().info().id != id) bench->before_tick(studio->now_ns());
    }
    QCoreApplication::processEvents();
  }
  [[nodiscard]] std::size_t strokes() const { return studio->session().document().stroke_count(); }
  [[nodiscard]] std::string said() const { return notice->message().text.toStdString(); }

  std::unique_ptr<DriverBench> bench;
  const Studio* studio_of_bench = nullptr;
  QString id;
  std::optional<DriverWatch> watch;
  QMainWindow window;
  DeviceNotice* notice = new DeviceNotice(&window);
  std::unique_ptr<Studio> studio;
  DeviceCare* care = nullptr;
  Vec3 middle, hand;
};

class Benches : public ::testing::TestWithParam<std::string_view> {};

TEST_P(Benches, UnpluggedMidLineTheInkIsKeptAndItComesBackWithoutForce) {
  Fixture at(GetParam(), {{InjectedFault::kUnplugged, 2000 * kMs, 3500 * kMs, 1.0}});
  at.hand = at.middle;
  ASSERT_TRUE(at.care->use(at.id, nullptr));
  EXPECT_FALSE(at.studio->loop().forces_are_on());
  at.studio->loop().set_forces(true);
  at.move_to(-20, 0, 10, 700);
  at.move_to(-20, 0, -6, 700);
  ASSERT_EQ(at.studio->loop().device().info().id, at.id) << at.said();
  EXPECT_TRUE(at.studio->session().gesture_in_progress());
  const std::size_t before = at.strokes();  // a light arm bounces when it lands, and draws a dot
  at.move_to(10, 10, -6, 900);
  EXPECT_EQ(at.studio->loop().device().info().id, QStringLiteral("tablet"));
  EXPECT_GT(at.strokes(), before) << "the ink up to the fault";
  const std::size_t kept = at.strokes();
  EXPECT_NE(at.said().find("is no longer connected."), std::string::npos) << at.said();
  at.move_to(0, 30, 10, 1500);
  EXPECT_EQ(at.strokes(), kept) << "the hand is not read";
  // The device reconnects automatically if the driver can find it without opening it; otherwise
  // the user presses the button.
  at.look();
  QTest::qWait(2 * DeviceCare::kCalmMs + 100);
  if (at.studio->loop().device().info().id != at.id) at.notice->press(0);
  ASSERT_EQ(at.studio->loop().device().info().id, at.id) << at.said();
  EXPECT_FALSE(at.studio->loop().forces_are_on());
  at.move_to(0, 30, 10, 300);
  at.move_to(0, 30, -6, 500);
  at.move_to(-20, 25, -6, 500);
  at.move_to(-20, 25, 10, 500);
  EXPECT_GT(at.strokes(), kept);
  EXPECT_EQ(norm(at.studio->pen().sent), 0.0) << "nobody has switched them on";
  EXPECT_EQ(at.bench->broken_rule(), "");
}

TEST_P(Benches, ForcesThatItSwitchesOffEndNoLine) {
  for (const InjectedFault fault : {InjectedFault::kForcesOff, InjectedFault::kWarmMotors}) {
    Fixture at(GetParam(), {{fault, 2000 * kMs, 2600 * kMs, 1.0}});
    if (!at.bench->shows(fault)) continue;
    SCOPED_TRACE(name_of(fault));
    at.hand = at.middle;
    ASSERT_TRUE(at.care->use(at.id, nullptr));
    at.studio->loop().set_forces(true);
    at.move_to(-20, 0, 10, 700);
    at.move_to(-20, 0, -6, 700);
    at.move_to(10, 10, -6, 900);
    EXPECT_EQ(at.studio->loop().device().info().id, at.id);
    EXPECT_TRUE(at.studio->session().gesture_in_progress());
    EXPECT_EQ(at.studio->loop().tick().safety.state, SafetyState::kLatched)
        << "until a person says so";
    EXPECT_NE(at.said().find(fault == InjectedFault::kForcesOff ? "has switched its forces off"
                                                                : "are too warm"),
              std::string::npos)
        << at.said();
    const std::size_t before = at.strokes();
    at.move_to(20, 10, 10, 500);
    EXPECT_GT(at.strokes(), before);
  }
}

std::string name_of_param(const ::testing::TestParamInfo<std::string_view>& param) {
  return std::string(param.param);
}

INSTANTIATE_TEST_SUITE_P(Drivers, Benches, ::testing::ValuesIn(driver_bench_names()),
                         name_of_param);

}  // namespace
}  // namespace felt::desktop::device_benches_test
