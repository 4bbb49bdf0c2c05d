// Tests haptic pens, mice, touchpads and controllers that fail, are unplugged or report wrong
// values: random cues and faults with a thousand seeds. A seed that breaks a rule is printed, and
// running it again repeats the failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "felt/base/constants.h"
#include "tests/devices/drivers/cue/cue_fixture.h"

namespace felt::cue_faults_test {
namespace {

constexpr int kSeeds = 1000;
constexpr std::array<const char*, 5> kDevices{kPenId, kMouseId, kReceiverId, kPadId, kControllerId};

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool one_in(std::size_t count) { return below(count) == 0; }
  double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::vector<std::uint8_t> bytes(std::size_t largest) {
    std::vector<std::uint8_t> some(below(largest + 1));
    for (std::uint8_t& byte : some) byte = static_cast<std::uint8_t>(engine_());
    return some;
  }

 private:
  std::mt19937_64 engine_;
};

/// Runs one device for some hundred cues. The fake fails occasionally, at any call, and is
/// unplugged once, possibly during a cue. All the values it reports may be wrong.
class Episode {
 public:
  explicit Episode(std::uint64_t seed) : random_(seed), id_(kDevices[random_.below(5)]) {
    lies_ = random_.one_in(3);
    fault_every_ = random_.one_in(3) ? 0 : 1 + random_.below(30);
    if (random_.one_in(2)) calls_to_unplugging_ = 1 + random_.below(60);
    const auto fault = [this] { return fault_now(); };
    fixture_.pen.fault = fixture_.mouse.fault = fixture_.pad.fault = fixture_.controller.fault =
        fault;
    fixture_.pad.slots = static_cast<int>(random_.below(4));
    fixture_.controller.slots = static_cast<int>(random_.below(4));
    fixture_.mouse.is_asleep = random_.one_in(8);
    fixture_.mouse.waveforms = static_cast<std::uint32_t>(random_.below(0x10000));
    if (lies_) lie();
  }

  void run() {
    auto opened = fixture_.open(id_);
    if (!opened) {
      EXPECT_FALSE(opened.error().message.empty());
      return;
    }
    device_ = *std::move(opened);
    for (int i = 0; i < 200; ++i) {
      const auto passed_ns = static_cast<std::int64_t>(random_.below(60)) * kMs;
      now_ns_ += passed_ns;
      fixture_.pen.now_ns += passed_ns;
      if (random_.one_in(60)) now_ns_ -= 5000 * kMs;  // the program's clock was set back
      step();
    }
    is_faultless_ = true;
    device_->stop();
    EXPECT_TRUE(was_unplugged_ || !hums()) << "after stop(), with nothing in its way";
    device_.reset();
    EXPECT_TRUE(fixture_.pad.effects.empty() && fixture_.controller.effects.empty());
    check_rules();
  }

  /// Returns what was played, to compare two runs with the same seed.
  [[nodiscard]] std::vector<std::size_t> trace() const {
    std::vector<std::size_t> all{fixture_.mouse.played.size(), fixture_.pad.played.size(),
                                 fixture_.controller.played.size(), calls_};
    for (const FakePen::Played& p : fixture_.pen.played)
      all.push_back(p.ordinal + 1000U * p.intensity);
    return all;
  }
  [[nodiscard]] bool was_open() const { return calls_ > 0; }
  [[nodiscard]] bool was_unplugged() const { return was_unplugged_; }
  [[nodiscard]] std::size_t refusals() const { return refusals_; }

 private:
  int fault_now() {
    ++calls_;
    if (calls_ == calls_to_unplugging_) was_unplugged_ = true;
    if (was_unplugged_) return is_back_ ? 0 : ENODEV;
    if (is_faultless_ || fault_every_ == 0 || !random_.one_in(fault_every_)) return 0;
    constexpr std::array<int, 6> kErrors{EIO, EINVAL, EPIPE, ENOSPC, EINTR, ETIMEDOUT};
    return kErrors[random_.below(kErrors.size())];
  }

  void lie() {
    std::vector<std::uint8_t> descriptor = pen_descriptor(65);
    for (std::size_t i = 1 + random_.below(6); i > 0; --i) {
      descriptor[random_.below(descriptor.size())] = static_cast<std::uint8_t>(random_.below(256));
    }
    if (random_.one_in(4)) descriptor = random_.bytes(200);
    add_hidraw(fixture_.system, 0, kPenKernel, "Slim pen", "", descriptor);
    fixture_.pen.lies = random_.bytes(40);
    for (std::size_t i = random_.below(40); i > 0; --i) {
      std::vector<std::uint8_t> report = random_.bytes(64);
      if (report.size() > 2 && random_.one_in(2)) report[0] = 0x11, report[1] = 0xFF;
      fixture_.mouse.answers.push_back(std::move(report));
    }
    fixture_.pad.waveforms = {static_cast<std::uint16_t>(0x1000 + random_.below(20))};
  }

  void step() {
    const bool was_gone = was_reported_gone_;
    if (random_.one_in(20)) {
      device_->stop();
      return;
    }
    constexpr std::array<double, 4> kOdd{std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::infinity(), -1.0, 7.0};
    Cue cue{static_cast<CueWaveform>(random_.below(14)), random_.share()};
    if (random_.one_in(20)) cue.intensity = kOdd[random_.below(kOdd.size())];
    const auto done = device_->play(cue, now_ns_);
    if (!done) ++refusals_;
    if (was_gone) {
      EXPECT_TRUE(!done && done.error() == DeviceFault::kDisconnected) << "gone is for ever";
    } else if (!done) {
      was_reported_gone_ = done.error() == DeviceFault::kDisconnected;
      EXPECT_TRUE(was_reported_gone_ || done.error() == DeviceFault::kOther);
      EXPECT_LE(was_reported_gone_, was_unplugged_) << "told gone, and is there";
    }
    if (was_reported_gone_ && random_.one_in(10)) is_back_ = true;  // it is plugged in again
  }

  [[nodiscard]] bool hums() const {
    return (!lies_ && fixture_.pen.hums()) || !fixture_.pad.playing.empty() ||
           !fixture_.controller.playing.empty();
  }

  void check_rules() const {
    // A pen that reports wrong values has limits that the driver cannot know.
    EXPECT_EQ(lies_ ? "" : fixture_.pen.broken_rule, "");
    EXPECT_EQ(lies_ ? "" : fixture_.mouse.broken_rule, "");
    EXPECT_EQ(fixture_.pad.broken_rule, "");
    EXPECT_EQ(fixture_.controller.broken_rule, "");
    for (const FakePen::Played& p : fixture_.pen.played) {
      if (lies_) break;
      EXPECT_LE(p.intensity, 100);
      const bool goes_on = p.ordinal >= 4 && p.ordinal <= 7;
      EXPECT_EQ(p.cutoff, goes_on ? 40 : 0) << "what hums ends by itself";
    }
    for (const FakePad* pad : {&fixture_.pad, &fixture_.controller}) {
      for (const EvdevEffect& effect : pad->played) {
        EXPECT_LE(effect.intensity_percent, 100);
        EXPECT_TRUE(effect.length_ms >= 1 && effect.length_ms <= kCueHoldNs / kMs);
      }
    }
  }

  Random random_;
  std::string id_;
  CueFixture fixture_;
  std::unique_ptr<CueDevice> device_;
  std::int64_t now_ns_ = 10'000 * kMs;
  std::size_t fault_every_ = 0, calls_ = 0, calls_to_unplugging_ = 0, refusals_ = 0;
  bool lies_ = false, is_faultless_ = false, is_back_ = false;
  bool was_unplugged_ = false, was_reported_gone_ = false;
};

TEST(CueFaults, AThousandSeedsBreakNoRule) {
  std::size_t unplugged = 0, refusals = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Episode episode(seed);
    episode.run();
    unplugged += episode.was_unplugged() ? 1 : 0;
    refusals += episode.refusals();
    if (seed % 50 != 0) continue;
    Episode again(seed);
    again.run();
    EXPECT_EQ(again.trace(), episode.trace()) << "deterministic";
  }
  EXPECT_GT(unplugged, 100u) << "it was tried";
  EXPECT_GT(refusals, 1000u);
}

/// If the kernel refuses the command that ends a vibration, the driver sends it again with the next
/// silence.
TEST(CueFaults, AStopThatWasRefusedIsToldAgain) {
  CueFixture fixture;
  auto device = fixture.open(kControllerId);
  ASSERT_TRUE(device) << device.error().message;
  ASSERT_TRUE((*device)->play({CueWaveform::kPencil, 0.5}, 0));
  ASSERT_EQ(fixture.controller.playing.size(), 1u);
  fixture.controller.error = EINTR;
  (*device)->stop();
  EXPECT_EQ(fixture.controller.playing.size(), 1u);
  fixture.controller.error = 0;
  (*device)->stop();
  EXPECT_TRUE(fixture.controller.playing.empty());
}

}  // namespace
}  // namespace felt::cue_faults_test
