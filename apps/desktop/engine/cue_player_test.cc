#include "desktop/engine/cue_player.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QSignalSpy>
#include <atomic>
#include <cmath>
#include <mutex>

#include "desktop/engine/settings.h"
#include "felt/base/constants.h"

namespace felt::desktop::cue_player_test {
namespace {

struct Played {
  std::int64_t now_ns = 0;
  Cue cue;
};

/// The state that the test shares with a device that only records what it plays.
struct Tape {
  std::mutex mutex;
  std::vector<Played> played;
  int opened = 0, closed = 0, stops = 0;
  std::atomic<bool> is_there{true};
  bool refuses = false;

  int count(CueWaveform waveform) {
    const std::lock_guard lock(mutex);
    return static_cast<int>(std::count_if(
        played.begin(), played.end(), [=](const Played& p) { return p.cue.waveform == waveform; }));
  }
};

class TapeDevice final : public CueDevice {
 public:
  TapeDevice(Tape& tape, DeviceDescriptor descriptor)
      : tape_(tape), descriptor_(std::move(descriptor)) {
    ++tape_.opened;
  }
  ~TapeDevice() override { ++tape_.closed; }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] bool plays(CueWaveform) const noexcept override { return true; }
  tl::expected<void, DeviceFault> play(const Cue& cue, std::int64_t now_ns) noexcept override {
    if (!tape_.is_there) return tl::unexpected(DeviceFault::kDisconnected);
    const std::lock_guard lock(tape_.mutex);
    tape_.played.push_back({now_ns, cue});
    return {};
  }
  void stop() noexcept override { ++tape_.stops; }

 private:
  Tape& tape_;
  DeviceDescriptor descriptor_;
};

class TapeDriver final : public Driver {
 public:
  explicit TapeDriver(Tape& tape) : tape_(tape) {}
  [[nodiscard]] std::string_view name() const noexcept override { return "tape"; }
  [[nodiscard]] std::string_view label() const noexcept override { return "A tape"; }
  std::vector<DeviceDescriptor> find() override {
    if (!tape_.is_there) return {};
    DeviceDescriptor pen;
    pen.id = "tape:pen";
    pen.driver = "tape";
    pen.kind = DeviceKind::kCue;
    pen.label = "Pen with a tape";
    DeviceDescriptor arm = pen;
    arm.id = "tape:arm";
    arm.kind = DeviceKind::kForce;
    return {arm, pen};
  }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor&, const OpenOptions&) override {
    return fail(ErrorCode::kUnsupported, "plays cues only");
  }
  Result<std::unique_ptr<CueDevice>> open_cue(const DeviceDescriptor& device) override {
    if (tape_.refuses) return fail(ErrorCode::kIo, "the tape is torn");
    return std::make_unique<TapeDevice>(tape_, device);
  }
  std::vector<Finding> diagnose(const SystemView&) override { return {}; }

 private:
  Tape& tape_;
};

class CuePlayerTest : public ::testing::Test {
 public:
  CuePlayerTest() : studio_(options()) {
    Settings::the().reset(QString::fromLatin1(kCueDeviceKey));
    number_ = add_cue_driver(std::make_shared<TapeDriver>(tape_));
  }
  ~CuePlayerTest() override {
    player_.reset();
    remove_cue_driver(number_);
    Settings::the().reset(QString::fromLatin1(kCueDeviceKey));
  }

 protected:
  static StudioOptions options() {
    StudioOptions options;
    options.live = false;
    options.first_options = false;
    return options;
  }
  void choose() {
    Settings::the().set(QString::fromLatin1(kCueDeviceKey), QStringLiteral("tape:pen"));
  }
  void start() { player_ = std::make_unique<CuePlayer>(studio_); }
  void point(Point at, double pressure) {
    studio_.point({studio_.now_ns(), at, pressure > 0.0, pressure, 0});
  }
  void wait(int ms) { studio_.advance(ms * kMs); }
  void draw(Point from, Point to) {
    point(from, 0.0);
    wait(40);
    for (int i = 0; i <= 80; ++i) {
      const double t = i / 80.0;
      point({std::lerp(from.x, to.x, t), std::lerp(from.y, to.y, t)}, 0.6);
      wait(5);
    }
    point(to, 0.0);
    wait(300);
  }

  Tape tape_;
  Studio studio_;
  std::unique_ptr<CuePlayer> player_;
  int number_ = 0;
};

TEST_F(CuePlayerTest, OnlyCueDevicesAreListedAndNoneIsChosenAtFirst) {
  std::vector<QString> ids;
  for (const CueDeviceInfo& info : cue_devices()) ids.push_back(info.id);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), QStringLiteral("tape:pen")), 1);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), QStringLiteral("tape:arm")), 0);
  start();
  draw({20, 20}, {80, 30});
  EXPECT_EQ(player_->in_use(), QString());
  EXPECT_EQ(tape_.opened, 0);
}

TEST_F(CuePlayerTest, AStrokeTouchesHumsAndLifts) {
  choose();
  start();
  EXPECT_EQ(player_->in_use(), QStringLiteral("tape:pen"));
  draw({20, 20}, {80, 30});
  ASSERT_GE(tape_.played.size(), 3u);
  EXPECT_EQ(tape_.played.front().cue.waveform, CueWaveform::kPress);
  EXPECT_EQ(tape_.played.back().cue.waveform, CueWaveform::kRelease);
  EXPECT_GE(tape_.count(CueWaveform::kPencil), 1);
  for (std::size_t i = 1; i < tape_.played.size(); ++i) {
    EXPECT_GE(tape_.played[i].now_ns - tape_.played[i - 1].now_ns, CueLaw::kMinApartNs);
  }
}

TEST_F(CuePlayerTest, FollowsMaterialAndTool) {
  choose();
  start();
  studio_.apply(SetOption{"pencil.medium", OptionValue(std::string("felt-tip"))});
  draw({20, 20}, {80, 30});
  EXPECT_GE(tape_.count(CueWaveform::kMarker), 1);
  EXPECT_EQ(tape_.count(CueWaveform::kPencil), 0);
  studio_.apply(SelectTool{"eraser"});
  draw({20, 60}, {80, 60});
  EXPECT_GE(tape_.count(CueWaveform::kEraser), 1);
  EXPECT_EQ(tape_.count(CueWaveform::kError), 0) << "bare paper is no mistake";
}

TEST_F(CuePlayerTest, AnEndThatWouldSnapTicks) {
  choose();
  start();
  draw({20, 20}, {80, 30});
  EXPECT_EQ(tape_.count(CueWaveform::kSuccess), 0);
  draw({80, 70}, {80.5, 30.5});  // to the end of the first stroke
  EXPECT_EQ(tape_.count(CueWaveform::kSuccess), 1);
}

TEST_F(CuePlayerTest, PullingTakesHoldOrIsRefused) {
  choose();
  start();
  draw({20, 20}, {80, 20});
  studio_.apply(SelectTool{"pull"});
  draw({50, 20}, {50, 30});
  EXPECT_EQ(tape_.count(CueWaveform::kClick), 1);
  EXPECT_EQ(tape_.count(CueWaveform::kError), 0);
  draw({50, 120}, {50, 130});
  EXPECT_EQ(tape_.count(CueWaveform::kClick), 1);
  EXPECT_EQ(tape_.count(CueWaveform::kError), 1);
}

TEST_F(CuePlayerTest, IsSilentWithoutForcesAndWeakerWithWeakOnes) {
  choose();
  start();
  studio_.loop().set_strength(0.5);
  draw({20, 20}, {80, 30});
  for (const Played& played : tape_.played) EXPECT_LE(played.cue.intensity, 0.5);
  tape_.played.clear();
  studio_.loop().set_forces(false);
  draw({20, 40}, {80, 40});
  EXPECT_TRUE(tape_.played.empty());
}

TEST_F(CuePlayerTest, SettingChangesWhatPlays) {
  start();
  QSignalSpy changed(player_.get(), &CuePlayer::changed);
  choose();
  EXPECT_EQ(player_->in_use(), QStringLiteral("tape:pen"));
  EXPECT_EQ(changed.count(), 1);
  Settings::the().set(QString::fromLatin1(kCueDeviceKey), QString());
  EXPECT_EQ(player_->in_use(), QString());
  EXPECT_EQ(changed.count(), 2);
  EXPECT_EQ(tape_.opened, 1);
  EXPECT_EQ(tape_.closed, 1);
}

TEST_F(CuePlayerTest, ADeviceThatDoesNotOpenSaysWhy) {
  tape_.refuses = true;
  start();
  QSignalSpy refused(player_.get(), &CuePlayer::refused);
  EXPECT_FALSE(player_->use(QStringLiteral("tape:pen")));
  EXPECT_FALSE(player_->use(QStringLiteral("tape:other")));
  ASSERT_EQ(refused.count(), 2);
  EXPECT_EQ(refused[0][0].toString(), QStringLiteral("the tape is torn"));
  EXPECT_TRUE(refused[1][0].toString().contains(QStringLiteral("tape:other")));
}

// Right after a device is plugged in, its permissions may still be missing.
TEST_F(CuePlayerTest, ADeviceThatDoesNotOpenAtFirstIsTriedAgain) {
  tape_.refuses = true;
  choose();
  start();
  EXPECT_EQ(player_->in_use(), QString());
  QSignalSpy refused(player_.get(), &CuePlayer::refused);
  QSignalSpy changed(player_.get(), &CuePlayer::changed);
  tape_.refuses = false;
  ASSERT_TRUE(changed.wait(8000));
  EXPECT_EQ(player_->in_use(), QStringLiteral("tape:pen"));
  EXPECT_EQ(refused.count(), 0);
}

TEST_F(CuePlayerTest, AnUnpluggedOneIsLetGoAndComesBack) {
  choose();
  start();
  tape_.is_there = false;
  QSignalSpy refused(player_.get(), &CuePlayer::refused);
  draw({20, 20}, {80, 30});
  QCoreApplication::processEvents();
  EXPECT_EQ(player_->in_use(), QString());
  ASSERT_EQ(refused.count(), 1);
  EXPECT_TRUE(refused[0][0].toString().contains(QStringLiteral("Pen with a tape")));
  EXPECT_EQ(studio_.session().document().stroke_count(), 1u) << "the drawing goes on";
  tape_.is_there = true;
  ASSERT_TRUE(QSignalSpy(player_.get(), &CuePlayer::changed).wait(8000));
  EXPECT_EQ(player_->in_use(), QStringLiteral("tape:pen"));
}

/// With the thread, only cues that are too old are dropped, and the last command silences the
/// device.
TEST(CueThread, PlaysOnAThreadOfItsOwn) {
  Tape tape;
  std::atomic<int> faults{0};
  {
    CueThread thread(std::make_unique<TapeDevice>(tape, DeviceDescriptor{}), true,
                     [&](DeviceFault) { ++faults; });
    thread.play({CueWaveform::kClick, 0.5}, 1);
    while (tape.count(CueWaveform::kClick) == 0) std::this_thread::yield();
    tape.is_there = false;
    thread.play({CueWaveform::kClick, 0.5}, 2);
    while (faults == 0) std::this_thread::yield();
    thread.play({CueWaveform::kClick, 0.5}, 3);
    thread.stop();
  }
  EXPECT_EQ(faults, 1);
  EXPECT_GE(tape.stops, 1);
  EXPECT_EQ(tape.closed, 1);
  EXPECT_EQ(tape.count(CueWaveform::kClick), 1);
}

}  // namespace
}  // namespace felt::desktop::cue_player_test
