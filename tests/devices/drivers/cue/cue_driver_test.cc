// Tests haptic pens, mice, touchpads and controllers with fakes of their kernel nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/haptics/cue_law.h"
#include "tests/devices/drivers/cue/cue_fixture.h"

namespace felt::cue_driver_test {
namespace {

TEST(CueDriver, FindsAllOfThemWithoutOpeningAny) {
  CueFixture fixture;
  for (int i = 0; i < 8; ++i) fixture.system.forbid("/dev/hidraw" + std::to_string(i));
  std::vector<std::string> ids;
  for (const DeviceDescriptor& found : fixture.driver->find()) {
    ids.push_back(found.id);
    EXPECT_EQ(found.kind, DeviceKind::kCue);
    EXPECT_EQ(found.driver, "cue");
    EXPECT_FALSE(found.label.empty());
    EXPECT_EQ(found.is_connected, found.id != kReceiverId);
  }
  EXPECT_EQ(ids, (std::vector<std::string>{kPenId, kMouseId, kReceiverId, kPadId, kControllerId}));
}

TEST(CueDriver, TwoAlikeHaveIdsOfTheirOwn) {
  CueFixture fixture;
  add_input(fixture.system, 15, "0003:045E:02EA.0017", "X-Box One pad", "045e", "02ea",
            "107030000 0");
  const auto found = fixture.driver->find();
  EXPECT_EQ(found.back().id, std::string(kControllerId) + "#2");
}

TEST(CueDriver, APenPlaysWhatItsListSays) {
  CueFixture fixture;
  auto device = fixture.open(kPenId);
  ASSERT_TRUE(device) << device.error().message;
  EXPECT_TRUE((*device)->plays(CueWaveform::kPencil));
  EXPECT_TRUE((*device)->plays(CueWaveform::kBrush)) << "by its nearest relative";
  EXPECT_TRUE((*device)->play({CueWaveform::kPencil, 0.5}, 0));
  EXPECT_TRUE((*device)->play({CueWaveform::kHover, 1.0}, 100 * kMs));
  EXPECT_TRUE((*device)->play({CueWaveform::kEraser, 2.0}, 200 * kMs));
  EXPECT_TRUE((*device)->play({}, 300 * kMs));
  EXPECT_TRUE((*device)->play({}, 301 * kMs));
  ASSERT_EQ(fixture.pen.played.size(), 4u) << "silence is asked for once";
  EXPECT_EQ(fixture.pen.played[0].ordinal, 5);
  EXPECT_EQ(fixture.pen.played[0].intensity, 50);
  EXPECT_EQ(fixture.pen.played[0].cutoff, 40) << "400 ms in steps of 10";
  EXPECT_EQ(fixture.pen.played[1].ordinal, 3) << "a click stands for hovering";
  EXPECT_EQ(fixture.pen.played[1].cutoff, 0);
  EXPECT_EQ(fixture.pen.played[2].ordinal, 7);
  EXPECT_EQ(fixture.pen.played[2].intensity, 100);
  EXPECT_EQ(fixture.pen.played[3].ordinal, 2) << "stop";
  EXPECT_EQ(fixture.pen.broken_rule, "");
}

TEST(CueDriver, ReportNumbersAreNotTakenForGranted) {
  CueFixture fixture;
  fixture.pen.report = 17;
  add_hidraw(fixture.system, 0, kPenKernel, "Slim pen", "", pen_descriptor(17));
  auto device = fixture.open(kPenId);
  ASSERT_TRUE(device);
  EXPECT_TRUE((*device)->play({CueWaveform::kClick, 1.0}, 0));
  EXPECT_EQ(fixture.pen.played.size(), 1u);
  EXPECT_EQ(fixture.pen.broken_rule, "");
}

TEST(CueDriver, AHostileDescriptorIsNoDevice) {
  CueFixture fixture;
  for (const std::vector<std::uint8_t>& bytes :
       {std::vector<std::uint8_t>(5000, 0xA1), std::vector<std::uint8_t>{0x91},
        std::vector<std::uint8_t>{}}) {
    add_hidraw(fixture.system, 0, kPenKernel, "Slim pen", "", bytes);
    EXPECT_FALSE(fixture.open(kPenId));
  }
}

TEST(CueDriver, APenIsNeverUsedHeavily) {
  CueFixture fixture;
  auto device = fixture.open(kPenId);
  ASSERT_TRUE(device);
  for (int ms = 0; ms < 5000; ++ms) {
    fixture.pen.now_ns = ms * kMs;
    EXPECT_TRUE((*device)->play({CueWaveform::kInk, 0.5 + 0.0001 * ms}, fixture.pen.now_ns));
  }
  EXPECT_LE(fixture.pen.max_in_a_second(), 20u);
  EXPECT_GE(fixture.pen.played.size(), 70u);
  EXPECT_EQ(fixture.pen.broken_rule, "");
}

TEST(CueDriver, AnUnpluggedDeviceIsGoneForEver) {
  CueFixture fixture;
  auto pen = fixture.open(kPenId);
  ASSERT_TRUE(pen);
  fixture.pen.error = EIO;
  EXPECT_EQ((*pen)->play({CueWaveform::kClick, 1.0}, 0).error(), DeviceFault::kOther);
  fixture.pen.error = ENODEV;
  EXPECT_EQ((*pen)->play({CueWaveform::kClick, 1.0}, 100 * kMs).error(),
            DeviceFault::kDisconnected);
  fixture.pen.error = 0;
  EXPECT_EQ((*pen)->play({CueWaveform::kClick, 1.0}, 200 * kMs).error(),
            DeviceFault::kDisconnected);
  (*pen)->stop();
  EXPECT_TRUE(fixture.pen.played.empty());

  auto controller = fixture.open(kControllerId);
  ASSERT_TRUE(controller);
  fixture.controller.error = ENODEV;
  EXPECT_EQ((*controller)->play({CueWaveform::kClick, 1.0}, 0).error(), DeviceFault::kDisconnected);
  fixture.controller.error = 0;
  EXPECT_FALSE((*controller)->play({CueWaveform::kClick, 1.0}, 100 * kMs));
}

TEST(CueDriver, AMouseTicksBesideOtherPrograms) {
  for (const char* id : {kMouseId, kReceiverId}) {
    CueFixture fixture;
    fixture.mouse.foreign = 20;
    auto device = fixture.open(id);
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_FALSE((*device)->plays(CueWaveform::kPencil));
    EXPECT_FALSE((*device)->plays(CueWaveform::kPress));
    EXPECT_TRUE((*device)->play({CueWaveform::kPencil, 1.0}, 0));
    EXPECT_TRUE((*device)->play({CueWaveform::kSuccess, 0.8}, 100 * kMs));
    EXPECT_TRUE((*device)->play({CueWaveform::kClick, 0.6}, 300 * kMs));
    EXPECT_TRUE((*device)->play({CueWaveform::kHover, 0.3}, 500 * kMs));
    EXPECT_EQ(fixture.mouse.played, (std::vector<std::uint8_t>{4, 1, 0x1B})) << id;
    EXPECT_EQ(fixture.mouse.broken_rule, "");
  }
}

TEST(CueDriver, AMouseThatSleepsOrHasNoHapticsSaysSo) {
  CueFixture fixture;
  fixture.mouse.is_asleep = true;
  auto device = fixture.open(kReceiverId);
  ASSERT_FALSE(device);
  EXPECT_NE(device.error().message.find("awake"), std::string::npos);
  fixture.mouse.is_asleep = false;
  fixture.mouse.number = 9;  // a number that no device of a receiver can have
  EXPECT_FALSE(fixture.open(kReceiverId));
  fixture.mouse.error = ENODEV;
  EXPECT_FALSE(fixture.open(kMouseId));
  fixture.mouse.error = 0;
  fixture.mouse.waveforms = 0x2;  // only one waveform
  auto poor = fixture.open(kMouseId);
  ASSERT_TRUE(poor);
  EXPECT_TRUE((*poor)->plays(CueWaveform::kClick));
  EXPECT_FALSE((*poor)->plays(CueWaveform::kSuccess));
  EXPECT_EQ(fixture.mouse.broken_rule, "");
}

TEST(CueDriver, ATouchpadKeepsItsOwnClicks) {
  CueFixture fixture;
  auto device = fixture.open(kPadId);
  ASSERT_TRUE(device) << device.error().message;
  EXPECT_TRUE((*device)->play({CueWaveform::kPress, 0.5}, 0));
  EXPECT_TRUE((*device)->play({CueWaveform::kSuccess, 0.5}, 100 * kMs));
  ASSERT_EQ(fixture.pad.played.size(), 2u);
  for (const EvdevEffect& effect : fixture.pad.played) {
    EXPECT_EQ(effect.hid_usage, 0x1003);
    EXPECT_EQ(effect.intensity_percent, 50);
  }
  // The device supports no vibration that we know. The driver detects this once and does not try
  // again.
  EXPECT_TRUE((*device)->play({CueWaveform::kPencil, 0.5}, 200 * kMs));
  EXPECT_FALSE((*device)->plays(CueWaveform::kPencil));
  EXPECT_EQ(fixture.pad.played.size(), 2u);
  EXPECT_EQ(fixture.pad.effects.size(), 1u);
  device->reset();
  EXPECT_TRUE(fixture.pad.effects.empty());
  EXPECT_EQ(fixture.pad.broken_rule, "");
}

TEST(CueDriver, AControllerRumblesAndFallsSilent) {
  CueFixture fixture;
  auto device = fixture.open(kControllerId);
  ASSERT_TRUE(device);
  EXPECT_TRUE((*device)->play({CueWaveform::kPencil, 0.5}, 0));
  EXPECT_TRUE((*device)->play({CueWaveform::kEraser, 1.0}, 100 * kMs));
  EXPECT_TRUE((*device)->play({CueWaveform::kSuccess, 1.0}, 200 * kMs));
  ASSERT_EQ(fixture.controller.played.size(), 3u);
  EXPECT_EQ(fixture.controller.played[0].strong, 0);
  EXPECT_GT(fixture.controller.played[0].weak, 0x8000);
  EXPECT_EQ(fixture.controller.played[0].length_ms, 400);
  EXPECT_EQ(fixture.controller.played[1].weak, 0);
  EXPECT_EQ(fixture.controller.played[1].strong, 0xFFFF);
  EXPECT_EQ(fixture.controller.played[2].length_ms, 40);
  EXPECT_EQ(fixture.controller.stopped, 1) << "the tick interrupts the hum";
  EXPECT_EQ(fixture.controller.effects.size(), 2u);
  (*device)->stop();
  EXPECT_EQ(fixture.controller.stopped, 2);
  fixture.controller.slots = 0;
  EXPECT_EQ(fixture.controller.broken_rule, "");
}

TEST(CueDriver, ADeviceWithoutSlotsRefusesAndLives) {
  CueFixture fixture;
  fixture.controller.slots = 0;
  auto device = fixture.open(kControllerId);
  ASSERT_TRUE(device);
  EXPECT_EQ((*device)->play({CueWaveform::kClick, 1.0}, 0).error(), DeviceFault::kOther);
  fixture.controller.slots = 1;
  EXPECT_TRUE((*device)->play({CueWaveform::kClick, 1.0}, 100 * kMs));
}

TEST(CueDriver, DoctorSaysWhoMayNotAndHowToMendIt) {
  CueFixture fixture;
  for (const Finding& finding : fixture.driver->diagnose(fixture.system)) {
    EXPECT_EQ(finding.level, FindingLevel::kOk) << finding.what;
  }
  fixture.system.forbid("/dev/hidraw0").forbid("/dev/input/event5");
  const std::vector<Finding> findings = fixture.driver->diagnose(fixture.system);
  int problems = 0;
  for (const Finding& finding : findings) {
    if (finding.level != FindingLevel::kProblem) continue;
    ++problems;
    ASSERT_TRUE(finding.fix);
    EXPECT_EQ(finding.fix->path, "/etc/udev/rules.d/70-feltline-haptics.rules");
    EXPECT_EQ(finding.fix->content,
              "KERNEL==\"hidraw*\", KERNELS==\"*:045E:0C1B.*\", TAG+=\"uaccess\"\n"
              "KERNEL==\"event*\", SUBSYSTEM==\"input\", ATTRS{id/vendor}==\"045e\", "
              "ATTRS{id/product}==\"02ea\", TAG+=\"uaccess\"\n");
    EXPECT_NE(finding.details.find("Permission denied"), std::string::npos);
  }
  EXPECT_EQ(problems, 2);
  auto refused = fixture.open(kPenId);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("feltline doctor"), std::string::npos);
}

TEST(CueDriver, DoctorKnowsKernelsThatAreTooOld) {
  FakeSystem system;
  add_hidraw(system, 4, kPadKernel, "Pad", "", pen_descriptor(9, true));
  system.add_file("/proc/sys/kernel/osrelease", "6.1.0-13-amd64\n");
  const auto driver = make_cue_driver();
  std::vector<Finding> findings = driver->diagnose(system);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].level, FindingLevel::kWarning);
  EXPECT_NE(findings[0].what.find("this kernel does not"), std::string::npos);
  EXPECT_EQ(findings[0].details, "6.1.0-13-amd64");
  system.add_file("/proc/sys/kernel/osrelease", "6.18.2\n");
  EXPECT_NE(driver->diagnose(system)[0].what.find("does not provide access"), std::string::npos);
  const FakeSystem empty;
  ASSERT_EQ(driver->diagnose(empty).size(), 1u);
  EXPECT_EQ(driver->diagnose(empty)[0].level, FindingLevel::kAbsent);
}

/// Simulates a hand that draws three strokes and undoes one: pen, cue rules and device in a whole
/// session.
std::vector<FakePen::Played> drawing_session() {
  CueFixture fixture;
  auto device = fixture.open(kPenId);
  EXPECT_TRUE(device);
  SimulatedStylus stylus(*find_stylus_preset("tablet"));
  const SurfaceMaterial& paper = *find_surface("paper");
  CueLaw law;
  law.set_feel(cue_feel_of(*find_medium("pencil"), paper));
  for (std::int64_t ms = 0; ms < 6000; ++ms) {
    const double t = 1e-3 * static_cast<double>(ms % 2000);
    const bool presses = t > 0.3 && t < 1.5;
    stylus.aim({20 + 30 * t, 40 + 20 * std::sin(6 * t), presses ? -1.0 : 4.0},
               presses ? 0.2 + 0.3 * t : 0.0, 0);
    const auto pen = stylus.read(ms * kMs);
    if (!pen) continue;
    fixture.pen.now_ns = ms * kMs;
    if (ms == 3490) law.report(CueEvent::kSnapped);
    const auto cue = law.step(cue_input_of(*pen, paper));
    if (cue) {
      EXPECT_TRUE((*device)->play(*cue, ms * kMs));
    }
  }
  (*device)->stop();
  EXPECT_EQ(fixture.pen.broken_rule, "");
  EXPECT_LE(fixture.pen.max_in_a_second(), 20u);
  return fixture.pen.played;
}

TEST(CueScenario, ADrawingSessionIsHeardThroughTheDriver) {
  const auto played = drawing_session();
  const auto count = [&](std::uint8_t ordinal) {
    return std::count_if(played.begin(), played.end(),
                         [=](const FakePen::Played& p) { return p.ordinal == ordinal; });
  };
  // Ordinals: 3 click (touching and lifting, by the nearest relative), 5 pencil, 8 success, 2 stop.
  EXPECT_EQ(count(3), 3 + 3) << "three touches, three lifts";
  EXPECT_EQ(count(8), 1);
  EXPECT_GE(count(5), 12);
  EXPECT_EQ(count(4) + count(6) + count(7), 0);
  for (const FakePen::Played& p : played) EXPECT_LE(p.intensity, 100);
  const auto again = drawing_session();
  ASSERT_EQ(again.size(), played.size()) << "deterministic";
  for (std::size_t i = 0; i < played.size(); ++i) {
    EXPECT_EQ(again[i].now_ns, played[i].now_ns);
    EXPECT_EQ(again[i].ordinal, played[i].ordinal);
    EXPECT_EQ(again[i].intensity, played[i].intensity);
  }
}

}  // namespace
}  // namespace felt::cue_driver_test
